# SPDX-License-Identifier: GPL-3.0-or-later
"""Terminal velocity of a sphere that settles, in a comoving window."""

import math

import numpy as np

import boxMesh
import stream
from bodyCase import BodyCase
from boxMesh import graded
from measure import Run, set_viscosity

RATIO, GALILEI, WIDTH = 2.56, 49, 7.5
SCALE = math.sqrt(RATIO - 1)    # sqrt((r - 1) g D), g = D = 1
COMPUTED, MEASURED = 0.870, 0.852

# Window ahead of the sphere and behind, Courant number, end
BASE = {"ahead": 8, "behind": 15, "courant": 1, "end": 25}
CHANGES = {
    "whole sphere, free": {"whole": True},
    "longer window": {"ahead": 12, "behind": 40},
    "half the time step": {"courant": 0.5},
}

# The sphere falls along x, fluid ahead is at rest
PATCHES = {
    True: {"inlet": "x+", "outlet": "x-", "sides": "y- y+ z- z+"},
    False: {
        "inlet": "x+", "outlet": "x-", "sides": "y+ z+",
        "middleY": "y-", "middleZ": "z-",
    },
}


def make_mesh(case, h, ahead, behind, whole):
    """Mesh of the box or of its quarter y, z > 0; number of cells."""
    side, core = 0.5*WIDTH, h*round(0.9/h)
    across = graded(-side*whole, side, (-core*whole, core), h)
    along = graded(-behind, ahead, (-h*round(1.2/h), core), h)
    n = boxMesh.write(case, along, across, across, PATCHES[whole])
    for plane in () if whole else ("middleY", "middleZ"):
        case.set_symmetry(plane)
    case.run("blockMesh")
    return n


def solve(folder, name, cells, ahead, behind, courant, end, whole=False):
    """Velocity over sqrt((r - 1) g D) by time step, and the run."""
    h = 1/cells
    case = BodyCase("tube", folder, f"{name}_D{cells}".replace(" ", "_"))
    case.conditions(stream.velocity(0), stream.P)
    n = make_mesh(case, h, ahead, behind, whole)
    set_viscosity(case, SCALE/GALILEI)
    case.gravity(1)
    case.bodies(f"""
        sphere
        {{
            shape       {{ type sphere; radius 0.5; }}
            densityRatio {RATIO};
            position    (0 0 0);
            velocity    ({COMPUTED*SCALE:.6g} 0 0);
            angularVelocity (0 0 0);
        }}
    """, "window { type comoving; direction (1 0 0); }")
    case.controls(
        endTime=f"{end}", deltaT=f"{courant*h/(COMPUTED*SCALE):.6g}"
    )
    run = Run(case, name, cells, n, may_fail=True)
    motion = case.table("motion")
    return motion["velocity_x"]/SCALE, run


def terminal(folder, name, cells, **settings):
    """Rows of a run, and the terminal velocity."""
    speed, run = solve(folder, name, cells, **settings)
    if run.failed:
        return [run.diverged()], None
    last = speed[int(0.9*len(speed)):]/speed[-1] - 1
    return [
        run.row("V*", speed[-1], COMPUTED),
        run.row("V* (experiment)", speed[-1], MEASURED),
        run.row("last change, %", 100*abs(last).max()),
    ], speed[-1]


def order(sizes, speeds):
    """Order p and limit of V* = limit + c h^p, by least squares."""
    h = 1/np.array(sizes)
    fits = []
    for p in np.linspace(0.3, 6, 571):
        terms = np.c_[np.ones_like(h), h**p]
        fit = np.linalg.lstsq(terms, speeds, rcond=None)[0]
        fits.append((np.linalg.norm(terms @ fit - speeds), p, fit[0]))
    return min(fits)[1:]


def rows(folder, quick):
    sizes = (8,) if quick else (8, 10, 12)
    speeds = []
    for cells in sizes:
        found, speed = terminal(folder, "quarter", cells, **BASE)
        yield from found
        speeds.append(speed)
    if quick or None in speeds:
        return
    p, limit = order(sizes, speeds)
    row = {**found[0], "settings": "D/h 8, 10, 12", "error_percent": None}
    yield {**row, "quantity": "order", "value": float(p), "reference": None}
    yield {**row, "quantity": "V* at h = 0", "value": float(limit)}
    for name, change in CHANGES.items():
        found, _ = terminal(folder, name, sizes[0], **{**BASE, **change})
        yield found[0]
