# SPDX-License-Identifier: GPL-3.0-or-later
"""Are groups of bodies, close to each other and to walls, stable?"""

import itertools
import random

import numpy as np

import boxMesh
from bodyCase import BodyCase
from boxMesh import graded
from freeRun import FreeRun
from measure import set_profile, set_viscosity

RATIOS = (0.01, 0.1, 0.5, 1, 2, 1000)
COURANTS = (0.2, 0.5, 1)
REYNOLDS = (0.1, 2, 40, 1000)

# By dimensions: Re, density ratio, Courant number
FULL = {
    2: (REYNOLDS, RATIOS, COURANTS),
    3: (REYNOLDS, RATIOS, (0.5,)),
}
QUICK = {
    2: ((2, 1000), (0.01, 0.5, 1000), (0.2, 1)),
    3: ((2, 1000), (0.01, 1000), (0.5,)),
}
RADIUS, SPEED, STEPS = 0.2, 1.5, 12

# D/h, number of bodies, half width of the tube, half length of the group
CELLS = {2: 8, 3: 6}
BODIES = {2: 5, 3: 8}
HALF = {2: 1, 3: 0.6}
REACH = {2: 0.9, 3: 1.0}
SHAPES = {2: "disc", 3: "sphere"}
PROFILES = {
    2: "1.5*(1 - sqr(pos().y()))",
    3: "1.5*(1 - sqr(pos().y()/0.6))*(1 - sqr(pos().z()/0.6))",
}
SIDES = {2: "y- y+", 3: "y- y+ z- z+"}


def prepare(folder, dimensions):
    """A tube with room for the group, and its number of cells."""
    h = 2*RADIUS/CELLS[dimensions]
    half, reach = HALF[dimensions], REACH[dimensions] + RADIUS
    core = h*round(reach/h)
    along = graded(-2.2, 3, (-core, core + STEPS*h), h)
    across = [-half, (2*half, round(2*half/h), 1)]
    case = BodyCase("tube", folder, f"mesh{dimensions}D")
    set_profile(case, PROFILES[2], PROFILES[dimensions])
    n = boxMesh.write(
        case, along, across, across if dimensions == 3 else None,
        {"inlet": "x-", "outlet": "x+", "walls": SIDES[dimensions]},
    )
    case.run("blockMesh")
    case.run("setExprFields")
    return case, n


def places(dimensions, draw):
    """Random centres with gaps of one cell and more; the first two are
    within one to two cells of a wall, the others within three of a body."""
    h = 2*RADIUS/CELLS[dimensions]
    half, reach = HALF[dimensions], REACH[dimensions]
    found = []
    while len(found) < BODIES[dimensions]:
        new = np.array([
            draw.uniform(-size, size)
            for size in (reach, half - RADIUS, half - RADIUS)
        ])
        if dimensions == 2:
            new[2] = 0
        if len(found) < 2:
            edge = half - RADIUS - draw.uniform(1, 2)*h
            new[1] = edge if len(found) else -edge
        across = new[1:dimensions]
        gap = half - RADIUS - abs(across).max()
        gaps = [np.linalg.norm(new - old) - 2*RADIUS for old in found]
        near = min(gaps, default=h)
        if gap >= h and near >= h and (len(found) < 2 or near < 3*h):
            found.append(new)
    return found


def run_case(mesh, n, folder, dimensions, Re, ratio, courant):
    """A run of the matrix, from rest in the undisturbed flow."""
    settings = f"{dimensions}D Re {Re} r {ratio} Co {courant}"
    cells = CELLS[dimensions]
    case = BodyCase(mesh, folder, settings.replace(" ", "_"))
    set_viscosity(case, 1/Re)
    centres = "\n".join(
        "({:.6f} {:.6f} {:.6f})".format(*centre)
        for centre in places(dimensions, random.Random(settings))
    )
    case.bodies(f"""
        body
        {{
            shape       {{ type {SHAPES[dimensions]}; radius {RADIUS}; }}
            densityRatio {ratio};
            positions   ({centres});
        }}
    """)
    dt = courant*2*RADIUS/cells/SPEED
    case.controls(endTime=f"{STEPS*dt:.10g}", deltaT=f"{dt:.10g}")
    return FreeRun(
        case, settings, cells, n, dt, RADIUS, SPEED, BODIES[dimensions]
    )


def summary(runs, settings):
    """Rows over several runs: mean outer iterations, how many steps have
    converged, and what has gone wrong, if anything has."""
    outers = [number for run in runs for number in run.outers]
    rows = [
        ("outer iterations", np.mean(outers) if outers else None, None),
        ("steps converged", sum(run.converged for run in runs), len(outers)),
    ] + [
        (quantity, number, None) for quantity, number in (
            ("steps repeated", sum(run.repeats for run in runs)),
            ("runs diverged", sum(bool(run.reason) for run in runs)),
            ("runs with overlap", sum(bool(run.overlap) for run in runs)),
        ) if number
    ]
    for quantity, value, reference in rows:
        yield {
            **runs[-1].row(quantity, value, reference),
            "settings": settings,
            "steps": len(outers),
            "cpu_s": sum(run.cpu for run in runs),
        }


def rows(folder, quick):
    for dimensions, (Res, ratios, courants) in (
        (QUICK if quick else FULL).items()
    ):
        mesh, n = prepare(folder, dimensions)
        for Re, ratio in itertools.product(Res, ratios):
            runs = []
            for courant in courants:
                runs.append(run_case(
                    mesh, n, folder, dimensions, Re, ratio, courant
                ))
                yield from runs[-1].rows()
            yield from summary(runs, f"{dimensions}D Re {Re} r {ratio}")
