# SPDX-License-Identifier: GPL-3.0-or-later
"""Height in a tube at which a free disc has no lift, by Re and density."""

import csv
import shutil
import subprocess
from pathlib import Path

import numpy as np

from bodyCase import CASES
from grainfoam import tables
from grainfoam.study import analysis
from measure import DEPTH, StateRun

# Re: |y| without lift, V_x and spin there
REFERENCES = {
    2: (0.48561, 1.140747, -0.724658),
    10: (0.48401, 1.142816, -0.720657),
    20: (0.47670, 1.152854, -0.705601),
    40: (0.43042, 1.215293, -0.628914),
}

# States of the study, see tube/system/studyDict
QUICK = "Re <= 10 and ratio <= 2 and cells == 8"


def run_study(folder, quick):
    """Run the study in the folder; what has finished there stays."""
    for source in CASES/"tube", Path(__file__).parent/"tube":
        shutil.copytree(source, folder, dirs_exist_ok=True)
    command = ["grainFoamStudy", "-case", folder, "-jobs", "1"]
    done = subprocess.run(command + ["-where", QUICK]*quick, check=False)
    # With 1 it ends if a state has failed
    if done.returncode != 1:
        done.check_returncode()


def states(folder):
    """Rows of the study's table, by Re, density ratio and D/h."""
    found = {}
    with open(folder/"postProcessing/study.csv", newline="") as file:
        for row in csv.DictReader(file):
            key = row["Re"], row["ratio"], row["cells"]
            found.setdefault(key, []).append(row)
    return found


def change(folder):
    """Of the lift over the last tenth of the time."""
    lift = tables.run_columns(folder, "forces")["fluidForce_y"]/DEPTH
    return lift[-1] - lift[int(0.9*len(lift))]


def rows(folder, quick):
    run_study(folder, quick)
    for (Re, ratio, cells), held in states(folder).items():
        runs = [
            StateRun(folder/"states"/row["state"], row["status"],
                     f"Re {Re} density ratio {ratio}", int(cells))
            for row in held
        ]
        run = next((r for r in runs if r.failed), runs[-1])
        run.cpu = sum(r.cpu for r in runs)
        if run.failed:
            yield run.diverged()
            continue
        y, lift, *others = (
            np.array([float(row[name]) for row in held])
            for name in ("y", "lift", "speed", "spin")
        )
        # Of the parabola through the three
        (zero,) = analysis.zeros(y, lift)
        height, *known = REFERENCES[int(Re)]
        yield run.row("|y| without lift", -zero.x, height)
        for name, values, reference in zip(
            ("V_x", "spin"), others, known, strict=True
        ):
            there = np.polyval(np.polyfit(y, values, 2), zero.x)
            yield run.row(f"{name} there", there, reference)
        unsteady = max(abs(change(r.path)) for r in runs)
        yield run.row("last change, %", 100*unsteady/np.ptp(lift))
