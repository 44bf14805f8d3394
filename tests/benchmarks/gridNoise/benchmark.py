# SPDX-License-Identifier: GPL-3.0-or-later
"""Noise and bias of the drag of a body that is towed through the mesh."""

import itertools

import numpy as np

import boxMesh
from bodyCase import BodyCase
from boxMesh import graded
from measure import DEPTH, Run, set_profile, set_viscosity
from peers import overset
from peers.installed import installed

CELLS, H = 8, 1/8
DIRECTIONS = {"axis": (1, 0), "oblique": (1, 0.37)}

# Start and end of what is compared; the way is centred in the box
TIMES = {"disc": (3, 5), "sphere": (0.5, 2)}

# Along the motion, across and, in 3D, from the plane of symmetry z = 0
MESHES = {
    "disc": (
        graded(-16, 16, (-40*H, 16*H), H), graded(-16, 16, (-20*H, 12*H), H),
    ),
    "sphere": (
        graded(-12, 12, (-18*H, 14*H), H, 1.2),
        graded(-8, 8, (-12*H, 10*H), H, 1.2), graded(0, 8, (0, 8*H), H, 1.2),
    ),
}
PATCHES = {
    "disc": {"inlet": "x-", "outlet": "x+", "walls": "y- y+"},
    "sphere": {
        "inlet": "x-", "outlet": "x+", "walls": "y- y+ z+", "symmetry": "z-",
    },
}


def course(shape, motion):
    """Direction of motion and start."""
    direction = np.array(DIRECTIONS.get(motion, (1, 0)), dtype=float)
    direction /= np.linalg.norm(direction)
    way = sum(TIMES[shape])
    start = -0.5*way*direction if motion in DIRECTIONS else (0, 0)
    return direction, start


def make_case(folder, shape, name):
    """A box of fluid at rest, and its number of cells."""
    case = BodyCase("tube", folder, name)
    set_profile(case, "1.5*(1 - sqr(pos().y()))", "0")
    if shape == "sphere":
        case.replace(
            "0/U", "frontAndBack { type empty; }", "symmetry { type slip; }"
        )
    mesh = MESHES[shape]
    n = boxMesh.write(case, *mesh, patches=PATCHES[shape])
    case.run("blockMesh")
    return case, n


def solve(folder, shape, Re, courant, motion):
    """Drag along the direction of motion at t, and the run."""
    direction, start = course(shape, motion)
    settings = f"{shape} Re {Re} Courant {courant} {motion}"
    case, n = make_case(folder, shape, settings.replace(" ", "_"))
    set_viscosity(case, 1/Re)
    case.bodies(
        f"""
        body
        {{
            shape       {{ type {shape}; radius 0.5; }}
            position    ({start[0]:.12g} {start[1]:.12g} 0);
            velocity    ({direction[0]:.12g} {direction[1]:.12g} 0);
            constraints {{ translate (0 0 0); rotate (0 0 0); }}
        }}
        """,
        "" if motion in DIRECTIONS else
        "window { type comoving; direction (1 0 0); }",
    )
    case.controls(endTime=f"{TIMES[shape][1]}", deltaT=f"{courant*H:.6g}")
    run = Run(case, settings, CELLS, n, may_fail=True)
    if run.failed:
        return None, None, run

    forces = case.table("forces")
    force = np.c_[forces["fluidForce_x"], forces["fluidForce_y"]]
    # Per unit depth of the disc; of the sphere half is in the mesh
    part = DEPTH if shape == "disc" else 0.5
    return forces["time"], -force @ direction/part, run


def solve_overset(folder, Re, courant, motion):
    """As solve, for the disc by an overset mesh on the same background."""
    if not installed(overset.SOLVER, overset.SOLVER):
        return None, None
    direction, start = course("disc", motion)
    case = overset.OversetCase(
        folder, f"overset_Re{Re}_Co{courant}", *MESHES["disc"], start, CELLS
    )
    set_viscosity(case, 1/Re)
    case.replace(
        "constant/dynamicMeshDict", "velocity (1 0 0)",
        "velocity ({:.12g} {:.12g} 0)".format(*direction),
    )
    case.controls(endTime=f"{TIMES['disc'][1]}", deltaT=f"{courant*H:.6g}")
    run = case.solve(f"disc Re {Re} Courant {courant} {motion}", CELLS)
    _, force = case.history()
    return -force @ direction, run


def compare(time, drag, still, start):
    """Noise and bias of the drag [%] from start on, relative to the mean of
    still; mean drag."""
    part = time > start
    difference = (drag - still)[part]/still[part].mean()
    trend = np.polyval(np.polyfit(time[part], difference, 2), time[part])
    return (
        100*np.std(difference - trend), 100*difference.mean(),
        drag[part].mean(), still[part].mean(),
    )


def figures(shape, run, time, drag, still):
    """Rows of a run that moves, against one that does not."""
    noise, bias, mean, reference = compare(time, drag, still, TIMES[shape][0])
    yield run.row("noise, % rms", noise, error=noise)
    yield run.row("drag", mean, float(reference), error=bias)


def rows(folder, quick):
    for shape, Re in itertools.product(TIMES, (2, 100)):
        for courant in (0.5,) if quick or shape == "sphere" else (0.5, 0.1):
            time, still, run = solve(folder, shape, Re, courant, "window")
            if run.failed:
                yield run.diverged()
                continue
            for motion in DIRECTIONS:
                _, drag, run = solve(folder, shape, Re, courant, motion)
                if run.failed:
                    yield run.diverged()
                    continue
                yield from figures(shape, run, time, drag, still)
            if shape == "disc":
                drag, run = solve_overset(folder, Re, courant, "oblique")
                if run:
                    yield from figures(shape, run, time, drag, still)
