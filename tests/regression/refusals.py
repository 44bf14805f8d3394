# SPDX-License-Identifier: GPL-3.0-or-later
"""What foamRun says to cases that it refuses, many of them in one go: each is
run by a fork of grainFoamRefusals (tests/refusals), which loads the libraries
once.

    refused = refusals.run({"radius": case, "density": other})
    refused["radius"].names("'radius'", "greater than 0")
"""

import subprocess
from dataclasses import dataclass

from foamCase import FoamCase

PROGRAM = "grainFoamRefusals"


@dataclass
class Refusal:
    """The end of a run that was to fail."""

    case: FoamCase
    status: int
    log: str

    def names(self, *parts, steps=0):
        """The run was refused, with these texts in the message, before its
        first time step or within so many."""
        assert self.status != 0, self.log[-2000:]
        assert "FOAM FATAL" in self.log
        assert self.log.count("\nTime = ") <= steps
        assert self.case.times() == ["0"]
        assert [part for part in parts if part not in self.log] == []


def run(cases, *options):
    """Refusals by the names of the cases."""
    done = subprocess.run(
        [PROGRAM, *options, *(str(case.path) for case in cases.values())],
        text=True, stdout=subprocess.PIPE, check=True,
    )
    status = {}
    for line in done.stdout.splitlines():
        number, path = line.split(" ", 1)
        status[path] = int(number)
    return {
        name: Refusal(
            case, status[str(case.path)],
            (case.path / "log.foamRun").read_text(errors="replace"),
        )
        for name, case in cases.items()
    }


def of_copies(case, folder, changes):
    """The same, of copies of a case with changes: functions of the copy, by
    name."""
    cases = {}
    for i, (name, change) in enumerate(changes.items()):
        cases[name] = case.copy(folder, f"{i}")
        change(cases[name])
    return run(cases)
