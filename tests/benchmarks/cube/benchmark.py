# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag of a cube in a square duct, steady."""

import math

import boxMesh
from bodyCase import BodyCase
from boxMesh import graded
from measure import Run, around
from peers import fittedCube

SIDE, SPEED = fittedCube.SIDE, 1
INLET, OUTLET = fittedCube.INLET, fittedCube.OUTLET
PATCHES = {
    "inlet": "x-", "outlet": "x+", "walls": "y+ z+",
    "south": "y-", "middle": "z-",
}
# Re: drag coefficient by the largest velocity and the side
REFERENCES = {1: 52.65, 20: 3.294}
GROWTH = 1.08


def solve(folder, Re, cells, model="exponential"):
    """The run, and the drag on the whole cube over density."""
    h = SIDE/cells
    settings = f"Re {Re}" if model == "exponential" else f"Re {Re} {model}"
    case = BodyCase("cylinder", folder, f"{model}_Re{Re}_D{cells}")
    across = graded(0, 1, (0, math.ceil(cells)*h), h, GROWTH)
    n = boxMesh.write(
        case,
        # Faces of the cube on faces of the mesh if D/h is even, through
        # centres of cells if odd; the same across
        graded(INLET, OUTLET, around(0, 1.5*SIDE, h), h, GROWTH),
        across, across, PATCHES,
    )
    fittedCube.set_conditions(case, Re)
    case.bodies(f"""
        cube
        {{
            shape       {{ type box; size ({SIDE} {SIDE} {SIDE}); }}
            position    (0 0 0);
            motion      {{ type fixed; }}
        }}
    """, f"steady {{}}\nresistance {{ type {model}; }}")
    case.controls(endTime="60", deltaT="0.1")
    run = Run(case, settings, cells, n, may_fail=True)
    return run, case.table("forces")["fluidForce_x"][-1]


def rows(folder, quick):
    scale = 2/(SPEED**2*SIDE**2)
    for Re, reference in REFERENCES.items():
        runs = [(cells, "exponential") for cells in (
            (8, 8.6, 9) if quick else (8, 8.6, 9, 12.6, 16.6)
        )]
        if Re == 20:
            runs += [(cells, "distanceWeighted") for cells in (
                (8.6,) if quick else (8.6, 12.6, 16.6)
            )]
        for cells, model in runs:
            run, drag = solve(folder, Re, cells, model)
            if run.failed:
                yield run.diverged()
                continue
            yield run.row("C_D", scale*drag, reference)
        for refinement in (0.7,) if quick else (0.7, 1):
            for result, drag in fittedCube.results(folder, Re, refinement):
                yield result.row("C_D", scale*drag, reference)
