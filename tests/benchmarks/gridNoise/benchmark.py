# SPDX-License-Identifier: GPL-3.0-or-later
"""Noise and bias of the drag of a disc that is towed through the mesh."""

import numpy as np

from bodyCase import BodyCase
from boxMesh import graded
from measure import DEPTH, Run, set_profile, set_viscosity
from peers import overset
from peers.installed import installed

CELLS = 8
DIRECTIONS = {"axis": (1, 0), "oblique": (1, 0.37)}

# Start and end of what is compared: two diameters, centred in the box
FROM, TO = 3, 5


def course(motion):
    """Direction of motion and start."""
    direction = np.array(DIRECTIONS.get(motion, (1, 0)), dtype=float)
    direction /= np.linalg.norm(direction)
    start = -0.5*(FROM + TO)*direction if motion in DIRECTIONS else (0, 0)
    return direction, start


def background(h):
    """Directions of the mesh."""
    return (
        graded(-16, 16, (-40*h, 16*h), h),
        graded(-16, 16, (-20*h, 12*h), h),
    )


def solve(folder, Re, courant, motion):
    """Drag along the direction of motion per unit depth at t, and the run."""
    h = 1/CELLS
    direction, start = course(motion)
    case = BodyCase("tube", folder, f"{motion}_Re{Re}_Co{courant}")
    set_profile(case, "1.5*(1 - sqr(pos().y()))", "0")
    n = case.mesh(*background(h))
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


def solve_overset(folder, Re, courant, motion):
    """As solve, by an overset mesh on the same background."""
    if not installed(overset.SOLVER, overset.SOLVER):
        return None, None
    h = 1/CELLS
    direction, start = course(motion)
    case = overset.OversetCase(
        folder, f"overset_Re{Re}_Co{courant}", *background(h), start, CELLS
    )
    set_viscosity(case, 1/Re)
    case.replace(
        "constant/dynamicMeshDict", "velocity (1 0 0)",
        "velocity ({:.12g} {:.12g} 0)".format(*direction),
    )
    case.controls(endTime=f"{TO}", deltaT=f"{courant*h:.6g}")
    run = case.solve(f"Re {Re} Courant {courant} {motion}", CELLS)
    _, force = case.history()
    return -force @ direction, run


def compare(time, drag, still):
    """Noise and bias of the drag [%], relative to the mean of still."""
    part = time > FROM
    difference = (drag - still)[part]/still[part].mean()
    trend = np.polyval(np.polyfit(time[part], difference, 2), time[part])
    return 100*np.std(difference - trend), 100*difference.mean()


def figures(run, time, drag, still):
    """Rows of a run that moves, against one that does not."""
    noise, bias = compare(time, drag, still)
    part = time > FROM
    yield run.row("noise, % rms", noise, error=noise)
    yield run.row(
        "drag", drag[part].mean(), float(still[part].mean()), error=bias
    )


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
                yield from figures(run, time, drag, still)
            drag, run = solve_overset(folder, Re, courant, "oblique")
            if run:
                yield from figures(run, time, drag, still)
