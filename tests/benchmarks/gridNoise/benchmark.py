# SPDX-License-Identifier: GPL-3.0-or-later
"""Noise and bias of the drag of a disc that is towed through the mesh."""

import numpy as np

from bodyCase import BodyCase
from boxMesh import graded
from measure import DEPTH, Run, set_profile, set_viscosity

CELLS = 8
DIRECTIONS = {"axis": (1, 0), "oblique": (1, 0.37)}

# Start and end of what is compared: two diameters, centred in the box
FROM, TO = 3, 5


def solve(folder, Re, courant, motion):
    """Drag along the direction of motion per unit depth at t, and the run."""
    h = 1/CELLS
    direction = np.array(DIRECTIONS.get(motion, (1, 0)), dtype=float)
    direction /= np.linalg.norm(direction)
    start = -0.5*(FROM + TO)*direction if motion in DIRECTIONS else (0, 0)

    case = BodyCase("tube", folder, f"{motion}_Re{Re}_Co{courant}")
    set_profile(case, "1.5*(1 - sqr(pos().y()))", "0")
    n = case.mesh(
        graded(-16, 16, (-40*h, 16*h), h),
        graded(-16, 16, (-20*h, 12*h), h),
    )
    set_viscosity(case, 1/Re)
    case.bodies(
        f"""
        disc
        {{
            shape       {{ type disc; radius 0.5; }}
            position    ({start[0]:.12g} {start[1]:.12g} 0);
            velocity    ({direction[0]:.12g} {direction[1]:.12g} 0);
            constraints {{ translate (0 0 0); rotate (0 0 0); }}
        }}
        """,
        "" if motion in DIRECTIONS else
        "window { type comoving; direction (1 0 0); }",
    )
    case.controls(endTime=f"{TO}", deltaT=f"{courant*h:.6g}")
    run = Run(
        case, f"Re {Re} Courant {courant} {motion}", CELLS, n, may_fail=True
    )
    if run.failed:
        return None, None, run

    forces = case.table("forces")
    force = np.c_[forces["fluidForce_x"], forces["fluidForce_y"]]
    return forces["time"], -force @ direction/DEPTH, run


def compare(time, drag, still):
    """Noise and bias of the drag [%], relative to the mean of still."""
    part = time > FROM
    difference = (drag - still)[part]/still[part].mean()
    trend = np.polyval(np.polyfit(time[part], difference, 2), time[part])
    return 100*np.std(difference - trend), 100*difference.mean()


def rows(folder, quick):
    for Re in (2, 100):
        for courant in (0.5,) if quick else (0.5, 0.1):
            time, still, run = solve(folder, Re, courant, "window")
            if run.failed:
                yield run.diverged()
                continue
            for motion in DIRECTIONS:
                _, drag, run = solve(folder, Re, courant, motion)
                if run.failed:
                    yield run.diverged()
                    continue
                noise, bias = compare(time, drag, still)
                yield run.row("noise, % rms", noise, error=noise)
                part = time > FROM
                yield run.row(
                    "drag", drag[part].mean(), float(still[part].mean()),
                    error=bias,
                )
