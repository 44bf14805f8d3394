# SPDX-License-Identifier: GPL-3.0-or-later
"""Do all steps converge, of two discs that touch and of bodies released?"""

import re

import numpy as np

import boxMesh
from bodyCase import BodyCase
from boxMesh import graded, uniform
from freeRun import why
from measure import Run, set_direct, set_viscosity

CELLS, GALILEI, STEP = 8, 50, 0.06
H = 1/CELLS
WIDTH, HEIGHT = 6, 16

# Density ratio: end; that of 1 is driven. They touch at 6, driven ones at 0.5; up
# to 18 those at 1.01, 0.5 and 3 come to rest at a wall
PAIRS = {1.01: 18, 1: 3, 0.5: 18, 3: 18}
QUICK = {1.01: 7.5, 1: 1.5, 0.5: 7.5}
RATIOS = 0.01, 0.1, 0.5, 1.01, 2, 10, 1e4
RELEASED = 8
# Tolerance and iterations of the run that the others are compared with
EXACT = "coupling { tolerance 1e-6; nOuterCorrectors 300; }"

U = 'walls { type noSlip; } "front.*" { type empty; }'
P = 'walls { type zeroGradient; } "front.*" { type empty; }'
NEAR = """
    contact     { type softSphere; restitution 0.9; }
    lubrication { type leadingOrder; roughness 1e-3; }
"""


def make_case(folder, name, ratio, mesh, walls):
    """A closed box of fluid at rest, gravity along -y; its number of cells."""
    case = BodyCase("tube", folder, name.replace(" ", "_"))
    flat = len(mesh) == 2
    case.conditions(*(
        text if flat else text.split('"')[0] for text in (U, P)
    ))
    n = boxMesh.write(case, *mesh, patches={"walls": walls})
    case.run("blockMesh")
    set_viscosity(case, 1/GALILEI)
    set_direct(case)
    case.gravity(0, -1/abs(ratio - 1) if ratio != 1 else 0)
    return case, n


def pair(folder, ratio, end, coupling=""):
    """Case and run of two discs; a heavy pair starts on top."""
    name = f"pair r {ratio}{' exact'*bool(coupling)}"
    case, n = make_case(
        folder, name, ratio,
        (uniform(-3, 3, WIDTH*CELLS), uniform(-8, 8, HEIGHT*CELLS)),
        "x- x+ y- y+",
    )
    down = 1 if ratio > 1 else -1
    y = (6.5*down, 4.9*down) if ratio != 1 else (0.65, -0.65)
    speed = 1 if ratio == 1 else 0
    bodies = "\n".join(f"""
        {name}
        {{
            shape       {{ type disc; radius 0.5; }}
            densityRatio {ratio};
            position    ({x:.6g} {height:.6g} 0);
            velocity    (0 {v} 0);
            angularVelocity (0 0 0);
        }}
    """ for name, x, height, v in (
        # Off the lines of the mesh, and not quite above each other
        ("follower", 0.07, y[0], -speed), ("leader", 0.02, y[1], speed),
    ))
    case.bodies(bodies, NEAR + coupling)
    case.controls(endTime=f"{end}", deltaT=f"{STEP}")
    return case, Run(case, name, CELLS, n, may_fail=True)


def release(folder, shape, ratio, coupling=""):
    """The run of one body from rest."""
    name = f"{shape} released r {ratio:g}{' exact'*bool(coupling)}"
    side = graded(-4, 4, (-8*H, 8*H), H, 1.2)
    mesh, walls = (side, side), "x- x+ y- y+"
    if shape == "sphere":
        mesh, walls = (side,)*3, f"{walls} z- z+"
    case, n = make_case(folder, name, ratio, mesh, walls)
    depth = 0.043 if shape == "sphere" else 0
    case.bodies(f"""
        body
        {{
            shape       {{ type {shape}; radius 0.5; }}
            densityRatio {ratio};
            position    (0.03 0.04 {depth});
            velocity    (0 0 0);
            angularVelocity (0 0 0);
        }}
    """, coupling)
    case.controls(endTime=f"{RELEASED*STEP:.6g}", deltaT=f"{STEP}")
    return case, Run(case, name, CELLS, n, may_fail=True)


def counts(case, run):
    """Rows that every run has."""
    log = (case.path / "log.foamRun").read_text()
    if run.failed:
        print(f"{run.settings}: {why(log)}")
        yield run.diverged()
    missed = run.steps - run.converged
    repeats = log.count(", repeated with deltaT")
    for quantity, number in (
        ("not converged", missed), ("steps repeated", repeats)
    ):
        yield run.row(quantity, number, 0, 100*number/max(run.steps, 1))
    if not run.steps:
        return
    yield run.row("outers, mean", np.mean(run.outers))
    yield run.row("outers, largest", max(run.outers))
    yield run.row("outers, first", run.outers[0])


def compared(run, case, exact, bodies):
    """Row: largest difference of velocities along gravity from those of the case
    `exact`, over their largest."""
    error = 0
    for body in range(bodies):
        v, best = (c.table("motion", body) for c in (case, exact))
        at = np.interp(best["time"], v["time"], v["velocity_y"])
        error = max(
            error, abs(at - best["velocity_y"]).max()
            / abs(best["velocity_y"]).max()
        )
    yield run.row("velocity off 1e-6, %", 100*error, 0, 100*error)


def contact(case, run):
    """Rows of two discs: how near they come, what the steps there do."""
    tables = [case.table("motion", body) for body in range(2)]
    distance = np.hypot(*(
        tables[0][f"position_{c}"] - tables[1][f"position_{c}"] for c in "xy"
    ))
    gap = distance - 1
    yield run.row("smallest gap/D", gap.min())

    log = (case.path / "log.foamRun").read_text()
    missed = np.array([
        bool(text) for text in re.findall(
            r"outer iterations \d+( \(not conv)?", log
        )
    ])
    # With repeated steps the table may be shorter than the log: from the end
    n = min(len(gap), len(missed))
    near = gap[-n:] < H
    share = missed[-n:][near].mean() if near.any() else 0
    yield run.row("steps near contact", near.sum())
    yield run.row(
        "not conv., near", missed[-n:][near].sum(), 0, 100*share
    )


def rows(folder, quick):
    for ratio, end in (QUICK if quick else PAIRS).items():
        case, run = pair(folder, ratio, end)
        yield from counts(case, run)
        yield from contact(case, run)
        exact, _ = pair(folder, ratio, end, EXACT)
        yield from compared(run, case, exact, 2)
    for shape in ("disc", "sphere"):
        for ratio in RATIOS:
            case, run = release(folder, shape, ratio)
            yield from counts(case, run)
            exact, _ = release(folder, shape, ratio, EXACT)
            yield from compared(run, case, exact, 1)
