# SPDX-License-Identifier: GPL-3.0-or-later
"""A disc in an oblique stream, seen from four frames that move uniformly."""

import itertools
import math

import numpy as np

import boxMesh
from bodyCase import BodyCase
from boxMesh import graded
from measure import DEPTH, Run, set_direct, set_viscosity

# The stream as the frame sees it, by its part of (cos a, sin a); the disc has
# the rest. Is there a window?
FRAMES = {
    "stream": ((1, 1), False),
    "mesh": ((0, 0), False),
    "window": ((0, 0), True),
    "drifting": ((0.5, 0), False),
}
WINDOW = "window { type comoving; direction (1 0 0); }"

# Start and end of the mean, D/U; by Re: before the vortex street has grown
TIMES = {1: (16, 24), 10: (16, 24), 40: (16, 24), 100: (4, 12)}

# Distance of the disc from all sides: in 20 D the place of the disc in the box
# is seen in the drag, in per cent of it at Re 1
FAR = 60

# Equal cells ahead of and beside the disc, and behind it
AHEAD, WAKE = 1.25, 2.5

# Angle, Re, D/h, Courant number
QUICK = tuple((angle, 40, 8, 0.5) for angle in (7, 20))
FULL = (
    *((*case, 8, 0.5) for case in itertools.product(
        (7, 20, 45), (1, 10, 40, 100)
    )),
    (20, 40, 8, 0.1), (20, 40, 16, 0.5),
)

BOUNDARY = """
    inlet   {{ type {inlet}; value uniform {value}; }}
    outlet  {{ type {outlet}; value uniform {value}; }}
    frontAndBack {{ type empty; }}
"""


def meshes(direction, angle, times, h):
    """Mesh along x and y, the same in all frames, and its patches; the disc is
    at the origin at the middle of the time of the mean."""
    before, after = sum(times)/2, (times[1] - times[0])/2
    # The wake of steep streams leaves through the upper side
    steep = angle > 30
    directions = []
    for way, leaves in zip(direction, (True, steep)):
        beside = WAKE if leaves else AHEAD
        core = (
            -h*round((after*way + AHEAD)/h), h*round((before*way + beside)/h),
        )
        directions.append(graded(-FAR, FAR, core, h))
    return directions, {
        "inlet": "x- y-" if steep else "x- y- y+",
        "outlet": "x+ y+" if steep else "x+",
    }


def make_case(folder, name, mesh, patches, stream):
    """A box with a uniform stream, and its number of cells."""
    case = BodyCase("tube", folder, name)
    n = boxMesh.write(case, *mesh, patches=patches)
    case.run("blockMesh")
    U = "({:.15g} {:.15g} 0)".format(*stream)
    kinds = {
        "U": ("fixedValue", "zeroGradient", U),
        "p": ("zeroGradient", "fixedValue", "0"),
    }
    for field, (inlet, outlet, value) in kinds.items():
        path = case.path / "0" / field
        head = path.read_text().split("boundaryField", 1)[0]
        head = head.replace("uniform (0 0 0)", f"uniform {U}")
        conditions = BOUNDARY.format(inlet=inlet, outlet=outlet, value=value)
        path.write_text(f"{head}boundaryField\n{{{conditions}}}\n")
    set_direct(case)
    return case, n


def solve(folder, angle, Re, cells, courant, frame):
    """Spin, lift and drag coefficient, and the run."""
    h, times = 1/cells, TIMES[Re]
    direction = np.array(
        [math.cos(math.radians(angle)), math.sin(math.radians(angle))]
    )
    part, window = FRAMES[frame]
    stream = part*direction
    velocity = stream - direction
    # At the origin, and not on a symmetric place of the cells, at the middle
    # of the mean; a window is there from the start
    start = -velocity*sum(times)/2 + np.array((0.23, 0.37))*h
    if window:
        start[0] = 0.23*h

    settings = f"{angle} deg Re {Re} Courant {courant} {frame}"
    case, n = make_case(
        folder, f"{settings.replace(' ', '_')}_D{cells}",
        *meshes(direction, angle, times, h), stream,
    )
    set_viscosity(case, 1/Re)
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius 0.5; }}
            densityRatio 1.5;
            position    ({start[0]:.12g} {start[1]:.12g} 0);
            velocity    ({velocity[0]:.12g} {velocity[1]:.12g} 0);
            angularVelocity (0 0 0);
            constraints {{ translate (0 0 0); }}
        }}
    """, WINDOW if window else "")
    case.controls(endTime=f"{times[1]}", deltaT=f"{courant*h:.12g}")
    run = Run(case, settings, cells, n, may_fail=True)
    return None if run.failed else means(case, direction, times), run


def means(case, direction, times):
    """Spin, lift and drag coefficient over the last part of the run."""
    motion, forces = case.table("motion"), case.table("forces")
    late = motion["time"] > times[0] + 1e-9
    x, y = (
        2*forces[f"fluidForce_{i}"][late].mean()/DEPTH for i in "xy"
    )
    dx, dy = direction
    return (
        motion["angularVelocity_z"][late].mean(), y*dx - x*dy, x*dx + y*dy,
    )


def rows(folder, quick):
    for case in QUICK if quick else FULL:
        reference = None
        for frame in FRAMES:
            values, run = solve(folder, *case, frame)
            if run.failed:
                yield run.diverged()
                continue
            spin, lift, drag = values
            if frame == "stream":
                reference = drag
            yield run.row("spin D/U", spin, 0, 100*spin)
            yield run.row("C_L", lift, 0, 100*lift)
            yield run.row("C_D", drag, reference)
            yield run.row("outer iterations", np.mean(run.outers))
