# SPDX-License-Identifier: GPL-3.0-or-later
"""Peers in FreeFem++: scripts of this folder that print names and numbers."""

import os
import subprocess
from pathlib import Path

from measure import Result
from peers.installed import installed

FITTED = "FreeFem++ P2/P1"
PENALISED = "FreeFem++ penalised"


def solve(script, *arguments):
    """What the script prints: numbers by name."""
    # One core, as for the other solvers
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    done = subprocess.run(
        ["FreeFem++", "-v", "0", "-nw", script, *map(str, arguments)],
        cwd=Path(__file__).parent, env=environment, text=True, check=True,
        stdout=subprocess.PIPE,
    )
    lines = [line.split() for line in done.stdout.splitlines()]
    return {line[0]: float(line[1]) for line in lines if len(line) == 2}


def results(solver, script, arguments, settings, edges):
    """(result, numbers) for each number of edges that the script takes last;
    nothing without FreeFem++."""
    if not installed("FreeFem++", solver):
        return
    for n in edges:
        numbers = solve(script, *arguments, n)
        # Edges on the circumference or per diameter
        D_over_h = n/3.14159265 if solver == FITTED else n
        yield Result(
            settings, round(D_over_h, 1), int(numbers["cells"]),
            cpu=numbers["cpu"], solver=solver,
        ), numbers
