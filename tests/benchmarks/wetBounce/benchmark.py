# SPDX-License-Identifier: GPL-3.0-or-later
"""Restitution of a sphere that falls onto a wall in a viscous fluid."""

import math
import sys
from pathlib import Path

import numpy as np

import boxMesh
from bodyCase import BodyCase
from boxMesh import graded
from measure import Run, set_viscosity

sys.path.append(str(Path(__file__).parent))

from restitutionCurve import draw  # noqa: E402, F401

RATIO, DRY = 8, 0.97
# As of a speed of one; the last but one for the quick run
STOKES = (11, 27, 36, 50, 85, 152, 540)
START, HEIGHT, WIDTH = 5, 9, 6
# Over D: the gap at which the speed of the impact is taken, the way in the time
# of which that of the rebound is, other gaps for the latter, the least height
GAP, WINDOW, GAPS, LEAST = 0.25, 0.5, (0.05, 0.25), 0.01
FILM = "leadingOrder;"
SOFT = f"softSphere; restitution {DRY};"
# Impacts that take most outer iterations: density ratio and St
HARD = ((2, 50), (3, 152), (2, 11), (1.2, 11))
EXACT = "coupling { tolerance 1e-6; nOuterCorrectors 300; }"
SAFE = str.maketrans(" /", "__")

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


def gravity(reynolds, ratio):
    """That of a terminal velocity of one (Schiller & Naumann 1935), D = 1."""
    drag = 24/reynolds*(1 + 0.15*reynolds**0.687)
    return -0.75*drag/(ratio - 1)


def make_case(folder, name, stokes, cells, courant=0.3, contact=SOFT,
              film=FILM, ratio=RATIO, coupling=""):
    """The case, and its number of cells."""
    h, reynolds = 1/cells, 9*stokes/ratio
    case = BodyCase("tube", folder, f"{name}_D{cells}".translate(SAFE))
    case.conditions(U, P)

    core = h*round(0.75/h)
    across = graded(0, 0.5*WIDTH, (0, core), h)
    along = graded(0, HEIGHT, (0, h*round((START + 1)/h)), h)
    n = boxMesh.write(case, along, across, across, PATCHES)
    for plane in ("middleY", "middleZ"):
        case.set_symmetry(plane)
    case.run("blockMesh")

    set_viscosity(case, 1/reynolds)
    case.gravity(gravity(reynolds, ratio))
    case.bodies(f"""
        sphere
        {{
            shape       {{ type sphere; radius 0.5; }}
            densityRatio {ratio};
            position    ({START} 0 0);
            velocity    (-1 0 0);
        }}
    """, f"contact {{ type {contact} }} lubrication {{ type {film} }} {coupling}")
    case.controls(endTime=START + 3, deltaT=f"{courant*h:.6g}")
    return case, n


def rebound_speed(t, x, u, turn, impact):
    """Mean over the time in which a sphere with the speed of the impact goes
    WINDOW, from where this one leaves the wall."""
    free = turn + np.flatnonzero(x[turn:] > 0)[0]
    span = WINDOW/impact
    return np.interp(t[free] - x[free]/u[free] + span, t, x)/span


def bounce(folder, name, stokes, cells, courant=0.3, contact=SOFT,
           film=FILM, ratio=RATIO):
    """Rows of one fall."""
    case, n = make_case(
        folder, name, stokes, cells, courant, contact, film, ratio
    )
    run = Run(case, name, cells, n, may_fail=True)
    if run.failed:
        return [run.diverged()]

    motion = case.table("motion")
    t, x, u = motion["time"], motion["position_x"] - 0.5, motion["velocity_x"]
    turn = np.flatnonzero(u > 0)

    # Before the wall slows it down
    down = slice(None, turn[0] if len(turn) else None)
    impact = -u[down][x[down] > GAP][-1]
    # With the mass of the fluid that moves along
    number = stokes*impact*(ratio + 0.5)/ratio
    found = [
        run.row("St", number), run.row("outers, largest", max(run.outers))
    ]
    if not len(turn) or x[turn[0]:].max() < LEAST:
        return [*found, run.row("e/e_dry: none", 0)]

    expected = math.exp(-35/number)
    leaves = rebound_speed(t, x, u, turn[0], impact)
    found.append(run.row("e/e_dry", leaves/impact/DRY, expected))
    up = slice(turn[0] - 1, None)
    for gap in GAPS:
        beyond = np.flatnonzero(x[up] > gap)
        if len(beyond):
            i = turn[0] - 1 + beyond[0]
            speed = np.interp(gap, x[i - 1:i + 1], u[i - 1:i + 1])
            found.append(run.row(
                f"speed at a gap of {gap} D instead", speed/impact/DRY
            ))
    found.append(run.row("rebound over D", x[up].max()))
    return found


def impact(folder, stokes, ratio, contact, film, name):
    """Rows of the iterations of one fall, beside one with a small tolerance."""
    runs, tables = [], []
    for coupling in ("", EXACT):
        settings = f"St {stokes}, density ratio {ratio}, {name}"
        case, n = make_case(
            folder, settings + " exact"*bool(coupling), stokes, 8,
            contact=contact, film=film, ratio=ratio, coupling=coupling,
        )
        runs.append(Run(case, settings, 8, n))
        tables.append(case.table("motion"))
    run = runs[0]
    v, best = (table["velocity_x"] for table in tables)
    error = 100*abs(v - best).max()/abs(best).max()
    missed = run.steps - run.converged
    return [
        run.row("outers, largest", max(run.outers)),
        run.row("not converged", missed, 0, 100*missed/run.steps),
        run.row("velocity off 1e-6, %", error, 0, error),
    ]


def rows(folder, quick):
    for ratio, stokes in HARD[:1] if quick else HARD:
        yield from impact(
            folder, stokes, ratio, "inelastic;", "none;", "inelastic, no film"
        )
        yield from impact(folder, stokes, ratio, SOFT, FILM, "soft, film")
    for stokes in STOKES[-2:-1] if quick else STOKES:
        yield from bounce(folder, f"St {stokes}", stokes, 8)
    if quick:
        return
    for stokes in STOKES[1:]:
        yield from bounce(
            folder, f"St {stokes}, density ratio 3", stokes, 8, ratio=3
        )
    stokes = 50
    for more in (27, stokes):
        yield from bounce(folder, f"St {more}", more, 12)
    for more in (stokes, 152):
        yield from bounce(
            folder, f"St {more}, roughness 1e-3", more, 8,
            film="leadingOrder; roughness 1e-3;"
        )
        yield from bounce(
            folder, f"St {more}, no lubrication", more, 8, film="none;"
        )
    yield from bounce(
        folder, f"St {stokes}, half the time step", stokes, 8, courant=0.15
    )
    yield from bounce(
        folder, f"St {stokes}, T = 0.02 D/V", stokes, 8,
        contact=f"{SOFT} collisionTime 0.02;",
    )
