# SPDX-License-Identifier: GPL-3.0-or-later
"""Noise and bias of the drag of a disc that is towed through the mesh."""

import numpy as np

from bodyCase import BodyCase
from boxMesh import graded
from measure import DEPTH, Run, around, set_profile, set_viscosity

CELLS = 8
DIRECTIONS = {"axis": (1, 0), "oblique": (1, 0.37)}

# Start and end of what is compared: the disc travels 3 diameters
FROM, TO = 1, 3


def solve(folder, Re, courant, motion):
    """Drag along the direction of motion per unit depth at t, and the run."""
    h = 1/CELLS
    direction = np.array(DIRECTIONS.get(motion, (1, 0)), dtype=float)
    direction /= np.linalg.norm(direction)
    start = -0.5*TO*direction if motion in DIRECTIONS else (0, 0)

    case = BodyCase("tube", folder, f"{motion}_Re{Re}_Co{courant}")
    set_profile(case, "1.5*(1 - sqr(pos().y()))", "0")
    n = case.mesh(
        graded(-16, 16, around(0, 2.5, h), h),
        graded(-16, 16, around(0, 1.75, h), h),
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
    run = Run(case, f"Re {Re} Courant {courant} {motion}", CELLS, n)

    forces = case.table("forces")
    force = np.c_[forces["fluidForce_x"], forces["fluidForce_y"]]
    return forces["time"], -force @ direction/DEPTH, run


def rows(folder, quick):
    for Re in (2, 100):
        for courant in (0.5,) if quick else (0.5, 0.1):
            time, still, _ = solve(folder, Re, courant, "window")
            part = time > FROM
            for motion in DIRECTIONS:
                _, drag, run = solve(folder, Re, courant, motion)
                ratio = (drag/still)[part]
                trend = np.polyfit(time[part], ratio, 2)
                noise = np.std(ratio - np.polyval(trend, time[part]))
                bias = ratio.mean() - 1
                yield run.row("noise, % rms", 100*noise, error=100*noise)
                yield run.row(
                    "drag", drag[part].mean(), float(still[part].mean()),
                    error=100*bias,
                )
