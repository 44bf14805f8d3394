# SPDX-License-Identifier: GPL-3.0-or-later
"""Time per step beside stock pimpleFoam, and where it goes."""

import sys
from pathlib import Path

from bodyCase import BodyCase

sys.path.append(str(Path(__file__).parent))

from picture import draw  # noqa: E402, F401
from timedRun import TimedRun  # noqa: E402
from vortices import Box, Tube, bodies, make  # noqa: E402

# Mesh, and diameters in cells by number of bodies
MESHES = {
    "2D 384x128": (Box(384, 128), {1: 16, 20: 16}),
    "2D 256x128 stretched": (Box(256, 128, ratio=3), {1: 16, 20: 16}),
    "2D 1536x512": (Box(1536, 512), {1: 16, 20: 16, 1000: 8}),
    "3D 64^3": (Box(64, 64, 64), {1: 8, 20: 8}),
    "3D 128x64x64": (Box(128, 64, 64), {1: 8, 20: 8, 1000: 4}),
    "3D tube": (Tube(90, 24), {1: 8, 20: 6}),
}
QUICK = ("2D 384x128", "2D 256x128 stretched")
STOCK = ["pimpleFoam"]
OURS = ["foamRun", "-solver", "incompressibleFluid"]
IMMERSED = ["foamRun", "-solver", "immersedFluid"]
PROJECTED = "coupling { fluid projected; }"


def solve(case, mesh, command, settings, ranks=1, crowd=(0, 0), fixed=False,
          direct=False, projected=False, steps=None):
    """Run a copy of the case with so many bodies of such a diameter. steps:
    see TimedRun."""
    number, diameter = crowd
    kind = "fixed" if fixed else "free"
    pressure = "fastPoisson" if direct else "GAMG"
    copy = BodyCase(
        case, case.path.parent,
        f"{command[-1]}_{pressure}_{number}_{kind}_{ranks}_{projected}",
    )
    if projected:
        settings += ", projected"
        copy.bodies("", PROJECTED)
    elif number:
        settings += f", {number} {kind}"
        copy.bodies(bodies(mesh, number, diameter, fixed))
    else:
        (copy.path/"constant/immersedBodyProperties").unlink()
    if direct:
        copy.replace("system/fvSolution", "GAMG", pressure)
    if ranks > 1:
        settings += f", {ranks} ranks"
        copy.decompose(ranks)
    return TimedRun(
        copy, command, f"{settings}, {pressure}", diameter or None,
        mesh.cells, ranks, steps,
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
    if run.exchange is not None:
        yield run.row("MPI ms", run.exchange)
    if run.outers:
        yield run.row("outer iterations", run.outers)


def arguments(mesh, crowds):
    """Of the runs on one mesh, beside those of pimpleFoam."""
    yield {"command": OURS}
    yield {"command": IMMERSED}
    if isinstance(mesh, Box):
        yield {"projected": True, "direct": True}
    for direct in (False, True) if isinstance(mesh, Box) else (False,):
        yield {"crowd": (1, crowds[1]), "fixed": True, "direct": direct}
        for crowd in crowds.items():
            yield {"crowd": crowd, "direct": direct}


def rows(folder, quick):
    """All meshes, solvers and numbers of bodies."""
    for name, (mesh, crowds) in MESHES.items():
        if quick and name not in QUICK:
            continue
        place = folder/name.replace(" ", "_")
        place.mkdir()
        case = make(place, mesh, "mesh")
        for ranks in (1,) if quick else (1, 2):
            stock = solve(case, mesh, STOCK, name, ranks)
            yield from table(stock, stock)
            for options in arguments(mesh, crowds):
                run = solve(
                    case, mesh, settings=name, ranks=ranks,
                    **{"command": IMMERSED, **options},
                )
                yield from table(run, stock)
