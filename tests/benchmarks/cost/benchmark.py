# SPDX-License-Identifier: GPL-3.0-or-later
"""Time per step beside stock pimpleFoam, and where it goes."""

import sys
from pathlib import Path

from bodyCase import BodyCase

sys.path.append(str(Path(__file__).parent))

from timedRun import TimedRun  # noqa: E402
from vortices import Box, Tube, bodies, make  # noqa: E402

# Mesh, and diameters in cells by number of bodies
MESHES = {
    "2D 384x128": (Box(384, 128), {1: 16, 20: 16}),
    "2D 1536x512": (Box(1536, 512), {1: 16, 20: 16, 1000: 8}),
    "2D stretched 256x128": (Box(256, 128, ratio=8), {1: 16, 20: 8}),
    "3D 64^3": (Box(64, 64, 64), {1: 8, 20: 8}),
    "3D 128x64x64": (Box(128, 64, 64), {1: 8, 20: 8, 1000: 4}),
    "3D tube": (Tube(90, 24), {1: 8, 20: 8}),
}
QUICK = ("2D 384x128", "2D stretched 256x128")
STOCK = ["pimpleFoam"]
OURS = ["foamRun", "-solver", "incompressibleFluid"]
IMMERSED = ["foamRun", "-solver", "immersedFluid"]


def solve(folder, case, mesh, name, command, ranks=1, number=0, diameter=0):
    """Run a copy of the case with so many bodies."""
    settings = f"{name}, {number} bodies, {ranks} ranks"
    copy = BodyCase(case, folder, f"run_{command[-1]}_{number}_{ranks}")
    if number:
        copy.bodies(bodies(mesh, number, diameter))
    else:
        (copy.path/"constant/immersedBodyProperties").unlink()
    if ranks > 1:
        copy.decompose(ranks)
    return TimedRun(
        copy, command, settings, diameter or None, mesh.cells, ranks
    )


def table(run, stock):
    """Rows of one run; stock: that of pimpleFoam on as many ranks."""
    yield run.row("ms per step", run.step)
    yield run.row("of pimpleFoam", run.step/stock.step)
    yield run.row("kB per cell", run.memory)
    if run is not stock:
        names = ("momentum ms", "pressure ms", "bodies ms")
        for name, time in zip(names, run.parts, strict=True):
            yield run.row(name, time)
        yield run.row("other ms", run.step - sum(run.parts))
    if run.outers:
        yield run.row("outer iterations", run.outers)


def rows(folder, quick):
    """All meshes, solvers and numbers of bodies."""
    for name, (mesh, crowds) in MESHES.items():
        if quick and name not in QUICK:
            continue
        place = folder/name.replace(" ", "_")
        place.mkdir()
        case = make(place, mesh, "mesh")
        for ranks in (1,) if quick else (1, 2):
            stock = solve(place, case, mesh, name, STOCK, ranks)
            yield from table(stock, stock)
            runs = [(OURS, 0, 0)] + [(IMMERSED, *crowd) for crowd in (
                (0, 0), *crowds.items()
            )]
            for command, number, diameter in runs:
                run = solve(
                    place, case, mesh, name, command, ranks, number, diameter
                )
                yield from table(run, stock)
