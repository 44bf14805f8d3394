# SPDX-License-Identifier: GPL-3.0-or-later
"""The command grainFoamStudy."""

import argparse
import os
import pathlib
import signal
import sys

from . import dictionary, plots, results, runner, states

KEYWORDS = {
    "parameters", "combine", "draws", "seed", "set", "folder", "copy", "link",
    "commands", "results", "plots", "where",
}


def arguments():
    """What the command line says."""
    parser = argparse.ArgumentParser(
        prog="grainFoamStudy", add_help=False,
        description="Run a case for many values of its parameters, as"
        " system/studyDict says, side by side; go on where it was stopped;"
        " write postProcessing/study.csv and plots/*.png.")
    parser.add_argument("-help", action="help", help="say this")
    parser.add_argument("-case", default=".", help="folder of the case")
    parser.add_argument("-dict", default="system/studyDict",
                        help="the study, by default system/studyDict")
    parser.add_argument("-jobs", type=int, default=0,
                        help="states at a time, by default one per processor")
    parser.add_argument("-draws", type=int,
                        help="number of draws, in place of the study's")
    parser.add_argument("-where",
                        help="only states for which this expression of"
                        " parameters is true, in place of the study's")
    parser.add_argument("-retry", action="store_true",
                        help="run states that failed again")
    parser.add_argument("-list", action="store_true",
                        help="list the states, and run none")
    return parser.parse_args()


def main():
    """Run a study; 1 if a state failed, 2 if the study is wrong."""
    given = arguments()
    case = pathlib.Path(given.case).resolve()
    # As a run is stopped from outside: end what it has started
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    try:
        study = dictionary.read(case/given.dict)
        study.check(KEYWORDS)
        if given.draws is not None:
            study.entries["draws"] = given.draws
        if given.where is not None:
            study.entries["where"] = given.where
        all_states = states.states(study)
        if given.list:
            for state in all_states:
                values = " ".join(f"{n}={dictionary.shown(v)}"
                                  for n, v in state.parameters.items())
                print(f"{state.name}: {values}")
            return 0
        results.check(study)
        plots.check(study)
        runs = runner.Runner(study, case, all_states)
        jobs = given.jobs if given.jobs > 0 else os.cpu_count() or 1
        failed = runs.run(jobs, given.retry,
                          lambda text: print(text, flush=True))
        table = results.read_table(runs.table)
        if table and "plots" in study:
            for line in plots.draw(study, table, case/"plots"):
                print(line)
        print(f"Table: {runs.table}")
        for name, record in runs.records.items():
            if record["status"] != "finished":
                print(f"{name} {record['status']}", file=sys.stderr)
        return 1 if failed else 0
    except dictionary.StudyError as error:
        print(f"grainFoamStudy: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("stopped; the same command goes on", file=sys.stderr)
        return 130
