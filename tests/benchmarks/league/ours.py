# SPDX-License-Identifier: GPL-3.0-or-later
"""grainFoam in the league, by its own benchmarks; functions as of a peer."""

from pathlib import Path

import numpy as np

from measure import Run
from report import Report

SOLVER = "immersedFluid"
MISSING = {}
BENCHMARKS = Path(__file__).resolve().parent.parent


def tenCate(program, folder, scene, quick=False):
    """Rows of a sphere that settles in a closed box, whole."""
    module = Report.load(BENCHMARKS/"tenCate")
    _, gap, speed, run = module.solve(folder, scene.name, scene.cells, True)
    if run.failed:
        yield run.diverged()
        return
    yield run.row("V max, m/s", speed.max(), scene.fastest)
    yield run.row("gap/D at V max", gap[speed.argmax()])


def crowd(program, folder, scene, fixed):
    """The run of a crowd, seconds per step in its second half and with one
    fixed sphere, velocities along gravity; a row if it diverged."""
    module = Report.load(BENCHMARKS/"crowd")

    def solve(spheres, held):
        name = f"{len(spheres.centres)}_{spheres.box}_{held}"
        case = module.crowd(
            folder, name, spheres.centres, spheres.box, spheres.cells,
            spheres.steps, held,
        )
        run = Run(
            case, spheres.name, spheres.cells, spheres.box**3, may_fail=True
        )
        late = module.step_times(case)[spheres.steps//2:]
        return run, np.median(late) if late.size else 0.0, case

    _, one, _ = solve(fixed, True)
    run, step, case = solve(scene, False)
    if run.failed:
        yield run.diverged()
        return
    yield run, step, one, module.speeds(case, len(scene.centres))


def fluid(program, folder, scene):
    """Rows of fluid alone, then with a sphere in it, fixed and free."""
    module = Report.load(BENCHMARKS/"cost")
    mesh = module.Box(scene.n, scene.n, scene.n)
    place = folder/f"fluid_{scene.n}"
    place.mkdir()
    case = module.make(place, mesh, "mesh")
    one = (1, scene.n//8)
    for what, options in (
        ("fluid alone", {"projected": True}),
        ("one fixed sphere", {"crowd": one, "fixed": True}),
        ("one free sphere", {"crowd": one}),
    ):
        run = module.solve(
            case, mesh, module.IMMERSED, f"{what}, {scene.n}^3", direct=True,
            steps=scene.steps, **options,
        )
        run.solver = {}
        yield run.row("s per step", 1e-3*run.step)
        yield run.row("ns per cell and step", 1e6*run.step/run.cells)
