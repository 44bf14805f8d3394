# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocity and path of a sphere that settles, with a wake that may be unsteady."""

import math

import numpy as np

import boxMesh
import stream
from bodyCase import BodyCase
from boxMesh import graded
from measure import Run, set_direct, set_viscosity
from periods import whole_periods

RATIO = 1.5
G = 1/(RATIO - 1)       # D = 1, u_g = 1
AHEAD, BEHIND, SIDE = 6, 12, 5

# Ga: V, V_H, that by which gravity is turned, velocity across at the start, end
CASES = {
    144: (1.2853, 0, 0, 0.01, 60),
    178.46: (1.356, 0.1245, 0.1245, 0.1, 60),
    190: (1.3827, None, 0.13, 0.1, 120),
    250: (1.4604, None, 0, 0.01, 120),
}
# Ga and cells per diameter: the threshold at Ga 155 is sensitive to them
RUNS = ((144, 10), (144, 16), (178.46, 16), (190, 16), (250, 16))
CORE = ((-1, 1), (-1, 1))
WINDOW = """
    window { type comoving; directions ((1 0 0) (0 1 0) (0 0 1)); }
"""
OSCILLATE = 190, 250

PATCHES = {"inlet": "x+", "outlet": "x-", "sides": "y- y+ z- z+"}


def on_mesh(low, high, h):
    return h*round(low/h), h*round(high/h)


def make_mesh(case, h, growth):
    """Number of cells."""
    along = graded(-BEHIND, AHEAD, on_mesh(-1.6, 0.9, h), h, growth)
    across = [
        graded(low - SIDE, high + SIDE, on_mesh(low, high, h), h, growth)
        for low, high in CORE
    ]
    n = boxMesh.write(case, along, *across, PATCHES)
    case.run("blockMesh")
    return n


def solve(folder, galilei, cells, end, growth):
    """Case after its run, the run, unit vectors along gravity and across."""
    V, _, turned, kick, _ = CASES[galilei]
    h, angle = 1/cells, math.atan2(turned, V)
    down = np.array([math.cos(angle), -math.sin(angle)])
    across = np.array([math.sin(angle), math.cos(angle)])
    start = V*down + kick*across
    case = BodyCase("tube", folder, f"Ga{galilei}_D{cells}")
    # Fluid ahead is at rest
    case.conditions(stream.velocity(0), stream.P)
    n = make_mesh(case, h, growth)
    set_viscosity(case, 1/galilei)
    set_direct(case)
    case.gravity(*(G*down))
    case.bodies(f"""
        sphere
        {{
            shape       {{ type sphere; radius 0.5; }}
            densityRatio {RATIO};
            position    (0 {0.23*h:.6g} {0.31*h:.6g});
            velocity    ({start[0]:.12g} {start[1]:.12g} 0);
            angularVelocity (0 0 0);
        }}
    """, WINDOW)
    case.controls(endTime=f"{end}", deltaT=f"{0.5*h/V:.6g}")
    run = Run(case, f"Ga {galilei}", cells, n, may_fail=True)
    return case, run, down, across


def figures(case, run, galilei, down, across):
    """Rows of a run."""
    V, V_H, *_ = CASES[galilei]
    motion = case.table("motion")
    # At even times: steps may have been repeated with half their length
    time = np.linspace(motion["time"][0], motion["time"][-1], len(motion["time"]))
    late = time > 2*time[-1]/3
    velocity = np.array([
        np.interp(time, motion["time"], motion[f"velocity_{c}"]) for c in "xyz"
    ])[:, late]
    time = time[late]
    fall = down @ velocity[:2]
    # Across gravity, in the plane x, y and out of it
    aside = np.array([across @ velocity[:2], velocity[2]])
    speed = np.hypot(*aside)

    whole, period = slice(None), None
    if galilei in OSCILLATE:
        whole, period = whole_periods(time, speed)
    yield run.row("V", fall[whole].mean(), V)
    mean = np.hypot(*aside[:, whole].mean(axis=1))
    if galilei == 144:
        drift = 100*mean
        yield run.row("drift in 100", drift, 0, drift/V)
    else:
        yield run.row("V_H", mean, V_H)
    yield run.row("V_H, rms", np.sqrt(np.mean(speed[whole]**2)))
    if period:
        yield run.row("frequency", 1/period)
    spin = np.linalg.norm(
        [motion[f"angularVelocity_{c}"] for c in "xyz"], axis=0
    )
    yield run.row("spin", spin[2*len(spin)//3:].mean())
    yield run.row("change of V, %", 100*np.ptp(fall)/V)
    yield run.row("outers, mean", np.mean(run.outers))
    yield run.row("outers, largest", max(run.outers))
    yield run.row(
        "not converged", run.steps - run.converged, 0,
        100*(1 - run.converged/run.steps),
    )


def rows(folder, quick):
    for galilei, cells in ((144, 8),) if quick else RUNS:
        growth = 1.15 if quick else 1.12
        end = 12 if quick else CASES[galilei][4]
        case, run, *axes = solve(folder, galilei, cells, end, growth)
        if run.failed:
            yield run.diverged()
            continue
        yield from figures(case, run, galilei, *axes)
