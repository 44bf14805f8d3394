# SPDX-License-Identifier: GPL-3.0-or-later
"""Restitution of a sphere that falls onto a wall in a viscous fluid."""

import math

import numpy as np

import boxMesh
from bodyCase import BodyCase
from boxMesh import graded
from measure import Run, set_viscosity

RATIO, DRY = 8, 0.97
STOKES = (27, 50, 152)
START, HEIGHT, WIDTH = 5, 9, 6
# Over D: gaps at which the speed is taken, of the impact and of the rebound
GAP, REBOUND = 0.25, 0.05
FILM = "leadingOrder; roughness 1e-4;"

U = """
    wallBelow { type noSlip; }
    outlet  { type zeroGradient; }
    sides   { type slip; }
"""
P = """
    wallBelow { type zeroGradient; }
    outlet  { type fixedValue; value uniform 0; }
    sides   { type slip; }
"""
PATCHES = {
    "wallBelow": "x-", "outlet": "x+", "sides": "y+ z+",
    "middleY": "y-", "middleZ": "z-",
}
GRAVITY = """FoamFile
{{
    version     2.0;
    format      ascii;
    class       uniformDimensionedVectorField;
    object      g;
}}

dimensions      [0 1 -2 0 0 0 0];
value           ({:.6g} 0 0);
"""


def gravity(reynolds):
    """That of a terminal velocity of one (Schiller & Naumann 1935), D = 1."""
    drag = 24/reynolds*(1 + 0.15*reynolds**0.687)
    return -0.75*drag/(RATIO - 1)


def make_case(folder, name, stokes, cells, courant, contact, film):
    """The case, and its number of cells."""
    h, reynolds = 1/cells, 9*stokes/RATIO
    case = BodyCase("tube", folder, f"{name}_D{cells}".replace(" ", "_"))
    for field, conditions in (("U", U), ("p", P)):
        path = case.path / "0" / field
        head = path.read_text().split("boundaryField", 1)[0]
        path.write_text(f"{head}boundaryField\n{{{conditions}}}\n")

    core = h*round(0.75/h)
    across = graded(0, 0.5*WIDTH, (0, core), h)
    along = graded(0, HEIGHT, (0, h*round((START + 1)/h)), h)
    n = boxMesh.write(case, along, across, across, PATCHES)
    for plane in ("middleY", "middleZ"):
        case.set_symmetry(plane)
    case.run("blockMesh")

    set_viscosity(case, 1/reynolds)
    (case.path / "constant/g").write_text(GRAVITY.format(gravity(reynolds)))
    case.bodies(f"""
        sphere
        {{
            shape       {{ type sphere; radius 0.5; }}
            densityRatio {RATIO};
            position    ({START} 0 0);
            velocity    (-1 0 0);
        }}
    """, f"contact {{ type softSphere; restitution {DRY}; {contact} }}"
        f" lubrication {{ type {film} }}")
    case.controls(endTime=START + 3, deltaT=f"{courant*h:.6g}")
    return case, n


def bounce(folder, name, stokes, cells, courant=0.3, contact="",
           film=FILM):
    """Rows of one fall."""
    case, n = make_case(folder, name, stokes, cells, courant, contact, film)
    run = Run(case, name, cells, n, may_fail=True)
    if run.failed:
        return [run.diverged()]

    motion = case.table("motion")
    x, u = motion["position_x"] - 0.5, motion["velocity_x"]
    turn = np.flatnonzero(u > 0)
    if not len(turn):
        return [run.row("no bounce: smallest gap over D", x.min())]
    down, up = slice(None, turn[0]), slice(turn[0] - 1, None)

    # Before the wall slows it down
    impact = -u[down][x[down] > GAP][-1]
    reached = stokes*impact
    expected = math.exp(-35/reached)
    found = [run.row("St", reached)]
    for gap in (REBOUND, GAP):
        beyond = np.flatnonzero(x[up] > gap)
        if len(beyond):
            i = turn[0] - 1 + beyond[0]
            leaves = np.interp(gap, x[i - 1:i + 1], u[i - 1:i + 1])
            found.append(run.row(
                f"e/e_dry, at {gap} D", leaves/impact/DRY, expected
            ))
    found.append(run.row("rebound over D", x[up].max()))
    return found


def rows(folder, quick):
    for stokes in STOKES[-1:] if quick else STOKES:
        yield from bounce(folder, f"St {stokes}", stokes, 8)
    if quick:
        return
    for stokes in STOKES:
        yield from bounce(
            folder, f"St {stokes}, roughness 1e-3", stokes, 8,
            film="leadingOrder;"
        )
        yield from bounce(
            folder, f"St {stokes}, no lubrication", stokes, 8, film="none;"
        )
    stokes = STOKES[1]
    yield from bounce(folder, f"St {stokes}", stokes, 12)
    yield from bounce(
        folder, f"St {stokes}, half the time step", stokes, 8, courant=0.15
    )
    yield from bounce(
        folder, f"St {stokes}, T = 0.02 D/V", stokes, 8,
        contact="collisionTime 0.02;",
    )
