# SPDX-License-Identifier: GPL-3.0-or-later
"""Time per step against the number of cells, and of bodies."""

import sys
from pathlib import Path

from bodyCase import BodyCase

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parent/"cost"))

from timedRun import TimedRun  # noqa: E402
from vortices import Box, bodies, make  # noqa: E402

CELLS = ((128, 80), (256, 160), (512, 320), (1024, 640), (2560, 1600))
CROWDED = (2000, 1250)
NUMBERS = (1, 10, 100, 1000, 10000)
QUICK = {"cells": CELLS[:3], "crowded": (512, 320), "numbers": (1, 10, 100)}
DIAMETER = 8

STOCK = "pimpleFoam"
IMMERSED = "immersedFluid"
PLOT = HERE.parent/"results/scaling.png"


def timed(case, box, pressure, number=0):
    """Run a copy of a case with so many bodies; none: stock pimpleFoam."""
    copy = BodyCase(case, case.path.parent, f"{pressure}_{number}")
    if number:
        copy.bodies(bodies(box, number, DIAMETER))
    copy.replace("system/fvSolution", "GAMG", pressure)
    command = ["foamRun", "-solver", IMMERSED] if number else [STOCK]
    settings = f"{number} bodies, {pressure}" if number else pressure
    return TimedRun(
        copy, command, settings, DIAMETER if number else None, box.cells
    )


def by_cells(folder, sizes):
    """One body, and none, on meshes of several sizes."""
    for size in sizes:
        place = folder/f"{size[0]}"
        place.mkdir()
        box = Box(*size)
        case = make(place, box, "mesh")
        yield timed(case, box, "GAMG")
        for pressure in ("GAMG", "fastPoisson"):
            yield timed(case, box, pressure, 1)


def by_bodies(folder, size, numbers):
    """Several numbers of bodies on one mesh."""
    place = folder/"crowded"
    place.mkdir()
    box = Box(*size)
    case = make(place, box, "mesh")
    for number in numbers:
        yield timed(case, box, "fastPoisson", number)


def plot(runs, crowds):
    """Both curves, with the parts of the time where there are many bodies."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4.2))
    lines = {}
    for run in runs:
        name = f"{run.solver['solver']}, {run.settings}"
        lines.setdefault(name, []).append((run.cells, run.step))
    for name, points in lines.items():
        label = name.replace("1 bodies", "1 body")
        left.loglog(*zip(*points), "o-", label=label)
    left.set_xlabel("cells")
    left.set_ylabel("time per step [ms]")

    numbers = [int(run.settings.split()[0]) for run in crowds]
    parts = zip(*(run.parts for run in crowds))
    right.loglog(numbers, [run.step for run in crowds], "ko-", label="step")
    for name, part in zip(("momentum", "pressure", "bodies"), parts):
        right.loglog(numbers, part, "o--", label=name)
    right.set_xlabel(f"bodies, {crowds[0].cells} cells")
    for panel in (left, right):
        panel.grid(True, which="major", alpha=0.3)
        panel.legend(fontsize=8)
    figure.tight_layout()
    PLOT.parent.mkdir(exist_ok=True)
    figure.savefig(PLOT, dpi=130)


def table(run):
    """Rows of one run."""
    yield run.row("ms per step", run.step)
    yield run.row("us per step and cell", 1e3*run.step/run.cells)
    if run.outers:
        names = ("momentum ms", "pressure ms", "bodies ms")
        for name, time in zip(names, run.parts):
            yield run.row(name, time)
        yield run.row("outer iterations", run.outers)


def rows(folder, quick):
    """Both sweeps, and the figure."""
    sizes = QUICK["cells"] if quick else CELLS
    crowded = QUICK["crowded"] if quick else CROWDED
    numbers = QUICK["numbers"] if quick else NUMBERS
    runs, crowds = [], []
    for run in by_cells(folder, sizes):
        runs.append(run)
        yield from table(run)
    for run in by_bodies(folder, crowded, numbers):
        crowds.append(run)
        yield from table(run)
    plot(runs, crowds)
