# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag of a face-centred array of spheres with inertia."""

import math

import numpy as np

from measure import LOCKED, Run, driving_force, set_direct, set_viscosity
from periodicBox import periodic_case
from periodicTube import FLOW_RATE

FRACTION = 0.367
# Centres in a cell of side 1, and their place on the mesh in cells
CENTRES = ((0, 0, 0), (0.5, 0.5, 0), (0.5, 0, 0.5), (0, 0.5, 0.5))
OFFSET = (0.3, 0.4, 0.2)
DIAMETER = (6*FRACTION/(len(CENTRES)*math.pi))**(1/3)
# F/(3 pi mu d U) in Stokes flow
STOKES = 19.33978
# Of random arrays, Tenneti et al. (2011), by Re = U d/nu
RANDOM = {0.5: 14.883, 10: 17.873, 50: 25.715, 100: 33.55, 300: 59.456}
# Courant number of U, and end in d/U
COURANT, END = 0.3, 30


def solve(folder, reynolds, cells, end=END, courant=COURANT):
    """The run, and the drag after each step."""
    n = round(cells/DIAMETER)
    name = f"Re {reynolds:g}"
    case = periodic_case(
        folder, f"Re{reynolds:g}_n{n}_{courant:g}", n, 3, 0, True
    )
    (case.path / "constant/fvOptions").write_text(FLOW_RATE.format(speed=1))
    nu = DIAMETER/reynolds
    set_viscosity(case, nu)
    set_direct(case)
    positions = " ".join(
        "({:.12g} {:.12g} {:.12g})".format(
            *(x + s/n for x, s in zip(centre, OFFSET))
        ) for centre in CENTRES
    )
    case.bodies(f"""
        body
        {{
            shape {{ type sphere; radius {0.5*DIAMETER:.15g}; }}
            positions ({positions});
            {LOCKED}
        }}
    """)
    case.controls(
        endTime=f"{end*DIAMETER:.12g}", deltaT=f"{courant/n:.12g}"
    )
    run = Run(case, name, round(DIAMETER*n, 2), n**3, may_fail=True)
    scale = len(CENTRES)*3*math.pi*nu*DIAMETER
    return run, driving_force(case)/scale


def figures(folder, reynolds, cells, **changes):
    """Rows of a run: means over the last third, and what changes there."""
    run, drag = solve(folder, reynolds, cells, **changes)
    if run.failed:
        yield run.diverged()
        return
    if "courant" in changes:
        run.settings += f", Courant number {changes['courant']:g}"
    last = drag[2*len(drag)//3:]
    mean = last.mean()
    yield run.row("F/(3 pi mu d U)", mean)
    yield run.row("the same, random (Tenneti et al.)", RANDOM[reynolds])
    yield run.row("F over that of Stokes flow", mean/STOKES)
    yield run.row("range of the last third, %", 100*np.ptp(last)/mean)
    halves = [half.mean() for half in np.array_split(last, 2)]
    yield run.row("drift of it, %", 100*(halves[1] - halves[0])/mean)


def rows(folder, quick):
    for cells in (8,) if quick else (8, 12, 16):
        for reynolds in RANDOM:
            yield from figures(folder, reynolds, cells)
    yield from figures(folder, 100, 8, courant=COURANT/2)
