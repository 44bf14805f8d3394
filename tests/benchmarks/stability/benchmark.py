# SPDX-License-Identifier: GPL-3.0-or-later
"""Which density ratios, time steps, meshes and Reynolds numbers are stable?"""

import itertools
import random
from pathlib import Path

import numpy as np

import boxMesh
from bodyCase import BodyCase
from boxMesh import graded
from freeRun import FreeRun
from measure import set_profile, set_viscosity

RATIOS = (0.01, 0.1, 0.5, 1, 2, 1000, 10000)
COURANTS = (0.2, 0.5, 1, 2)
CELLS = (4, 8, 16)
REYNOLDS = (0.1, 2, 10, 40, 1000)

# By dimensions: Re, density ratio, Courant number, D/h
FULL = {
    2: (REYNOLDS, RATIOS, COURANTS, CELLS),
    3: ((2, 10, 40), RATIOS, (0.5,), (4, 8)),
}
QUICK = {
    2: ((2, 1000), (0.01, 0.5, 10000), (0.2, 2), (4, 8)),
    3: ((2, 10), (0.01, 0.1, 10000), (0.5,), (4,)),
}
RADIUS, SPEED, STEPS = 0.2, 1.5, 20

# Half width of the tube, in 3D that of a square duct
HALF = {2: 1, 3: 0.6}
SHAPES = {2: "disc", 3: "sphere"}
PROFILES = {
    2: "1.5*(1 - sqr(pos().y()))",
    3: "1.5*(1 - sqr(pos().y()/0.6))*(1 - sqr(pos().z()/0.6))",
}
PATCHES = {
    2: {"inlet": "x-", "outlet": "x+", "walls": "y- y+"},
    3: {"inlet": "x-", "outlet": "x+", "walls": "y- y+ z- z+"},
}

PLOT = Path(__file__).resolve().parent.parent / "results/stability_map.png"


def time_step(courant, cells):
    return courant*2*RADIUS/cells/SPEED


def prepare(folder, dimensions, courant, cells):
    """A tube with room for the way of the body, and its number of cells."""
    h = 2*RADIUS/cells
    way = STEPS*time_step(courant, cells)*SPEED
    half = HALF[dimensions]
    start, width = 2*RADIUS, min(3.5*RADIUS, half)
    core = -start, -start + h*round((way + 2*start)/h)
    along = graded(-1, core[1] + 0.6, core, h, 1.2)
    across = graded(-half, half, (-width, width), h, 1.2)

    case = BodyCase("tube", folder, f"mesh{dimensions}D_{cells}_{courant}")
    set_profile(case, PROFILES[2], PROFILES[dimensions])
    n = boxMesh.write(
        case, along, across, across if dimensions == 3 else None,
        PATCHES[dimensions],
    )
    case.run("blockMesh")
    case.run("setExprFields")
    return case, n


def release(dimensions, Re, ratio, courant, cells):
    """Entry of the body: random, of the order of the flow, to the middle."""
    draw = random.Random(f"{dimensions} {Re} {ratio} {courant} {cells}")
    side = draw.choice((-1, 1)), draw.choice((-1, 1))
    offset = HALF[dimensions] - 0.5
    x = draw.uniform(0, 2*RADIUS/cells)
    y, z = (-s*draw.uniform(0.05, offset) for s in side)
    u = draw.uniform(0, SPEED)
    v, w = (s*draw.uniform(0.1, 0.3) for s in side)
    spin = [draw.uniform(-2, 2) for _ in range(3)]
    if dimensions == 2:
        z = w = spin[0] = spin[1] = 0
    return f"""
        body
        {{
            shape       {{ type {SHAPES[dimensions]}; radius {RADIUS}; }}
            densityRatio {ratio};
            position    ({x:.6f} {y:.6f} {z:.6f});
            velocity    ({u:.6f} {v:.6f} {w:.6f});
            angularVelocity ({spin[0]:.6f} {spin[1]:.6f} {spin[2]:.6f});
        }}
    """


def run_case(mesh, n, folder, dimensions, Re, ratio, courant, cells):
    """A run of the matrix."""
    settings = f"{dimensions}D Re {Re} r {ratio} Co {courant}"
    case = BodyCase(mesh, folder, f"{settings} D{cells}".replace(" ", "_"))
    set_viscosity(case, 1/Re)
    case.bodies(release(dimensions, Re, ratio, courant, cells))
    dt = time_step(courant, cells)
    case.controls(endTime=f"{STEPS*dt:.10g}", deltaT=f"{dt:.10g}")
    return FreeRun(case, settings, cells, n, dt, RADIUS, SPEED)


def plot(results):
    """A map of outer iterations per step for each number of dimensions, Re.

    results: {(dimensions, Re): {(ratio, courant, cells): run}}"""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(
        len(results), squeeze=False, figsize=(9, 3*len(results)),
        layout="constrained",
    )
    for ax, ((dimensions, Re), runs) in zip(axes[:, 0], results.items()):
        ratios = sorted({key[0] for key in runs})
        columns = sorted({key[1:] for key in runs})
        image = np.full((len(ratios), len(columns)), np.nan)
        for (ratio, *column), run in runs.items():
            i, j = ratios.index(ratio), columns.index(tuple(column))
            image[i, j] = np.mean(run.outers) if run.outers else np.nan
            ax.text(j, i, run.faults(), ha="center", va="center", color="red")
        shown = ax.imshow(image, aspect="auto", vmin=2, vmax=10)
        ax.set_title(f"{dimensions}D, Re {Re}")
        ax.set_yticks(range(len(ratios)), ratios)
        ax.set_xticks(
            range(len(columns)), [f"{c}\n{n}" for c, n in columns]
        )
        ax.set_xlabel("Courant number, D/h")
        ax.set_ylabel("density ratio")
        figure.colorbar(shown, ax=ax, label="outer iterations")
    PLOT.parent.mkdir(exist_ok=True)
    figure.savefig(PLOT, dpi=120)
    pyplot.close(figure)


def summary(runs, dimensions, Re):
    """Row: how many of the runs are without fault."""
    good = sum(not run.faults() for run in runs)
    return {
        **runs[-1].row("runs without fault", good),
        "reference": len(runs),
        "settings": f"{dimensions}D Re {Re} all",
        "cpu_s": sum(run.cpu for run in runs),
    }


def rows(folder, quick):
    results = {}
    for dimensions, matrix in (QUICK if quick else FULL).items():
        Res, ratios, courants, sizes = matrix
        meshes = {
            key: prepare(folder, dimensions, *key)
            for key in itertools.product(courants, sizes)
        }
        for Re in Res:
            runs = results[dimensions, Re] = {}
            for ratio, *key in itertools.product(ratios, courants, sizes):
                mesh, n = meshes[tuple(key)]
                run = run_case(mesh, n, folder, dimensions, Re, ratio, *key)
                runs[(ratio, *key)] = run
                yield from run.rows()
            yield summary(list(runs.values()), dimensions, Re)
    plot(results)
