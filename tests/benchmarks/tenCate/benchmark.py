# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocity of a sphere that settles in a closed box, against experiment."""

from pathlib import Path

import numpy as np

import boxMesh
from bodyCase import BodyCase
from boxMesh import graded
from measure import Run, set_box, set_over_relaxed

# Densities [kg/m3] of fluid and sphere, viscosity [Pa s], largest velocity
# measured [m/s], time to a gap of about half a diameter [s]
CASES = {
    "E1": (970, 1120, 0.373, 0.947*0.038, 3.5),
    "E2": (965, 1120, 0.212, 0.953*0.060, 2.1),
    "E3": (962, 1120, 0.113, 0.959*0.091, 1.4),
    "E4": (960, 1120, 0.058, 0.955*0.128, 1.1),
}

COURANT = 0.5

# Case, D/h, whole or a quarter of the box, Courant number if another
QUICK = (("E4", 8, False),)
FULL = (
    *((name, 8, False) for name in CASES), ("E4", 8, True),
    *((name, 10, False) for name in CASES), ("E4", 16, False),
    ("E1", 10, True), ("E1", 10, False, 0.75),
    ("E4", 10, True), ("E4", 10, True, 0.75), ("E4", 10, True, 1),
)
DIAMETER, GAP, WIDTH, HEIGHT = 0.015, 0.120, 0.100, 0.160
GRAVITY = 9.81

PLOT = Path(__file__).resolve().parent.parent / "results/tenCate_curves.png"


def mesh(case, cells, whole):
    """Cubic cells along the way of the sphere; number of cells."""
    h = DIAMETER/cells
    top = h*round((0.5*DIAMETER + GAP + 0.9*DIAMETER)/h)
    core = h*round(0.9*DIAMETER/h)
    along = graded(0, HEIGHT, (0, top), h)
    if whole:
        across = graded(-0.5*WIDTH, 0.5*WIDTH, (-core, core), h)
        return case.mesh(across, across, along)

    across = graded(0, 0.5*WIDTH, (0, core), h)
    n = boxMesh.write(case, across, across, along, {
        "walls": "x+ y+ z- z+", "middleX": "x-", "middleY": "y-",
    })
    for plane in ("middleX", "middleY"):
        case.set_symmetry(plane)
    case.run("blockMesh")
    return n


def solve(folder, name, cells, whole, courant=COURANT, coupling=""):
    """Times, gaps over the diameter, velocities [m/s] and the run. courant: of
    the largest velocity measured."""
    rho, rho_s, mu, fastest, end = CASES[name]
    part = "whole" if whole else "quarter"
    if courant != COURANT:
        part += f" Co {courant}"
    case = BodyCase("box", folder, f"{name}_D{cells}_{part.replace(' ', '')}")
    n = mesh(case, cells, whole)
    set_box(case)
    set_over_relaxed(case)
    case.replace(
        "constant/transportProperties", "0.1;", f"{mu/rho:.12g};"
    )
    case.replace("constant/g", "(0 0 -1)", f"(0 0 -{GRAVITY})")
    case.bodies(f"""
        sphere
        {{
            shape       {{ type sphere; radius {0.5*DIAMETER}; }}
            densityRatio {rho_s/rho:.12g};
            position    (0 0 {0.5*DIAMETER + GAP});
        }}
    """, coupling)
    dt = courant*DIAMETER/cells/fastest
    case.controls(endTime=f"{end}", deltaT=f"{dt:.6g}")
    run = Run(case, f"{name} {part}", cells, n, may_fail=True)
    motion = case.table("motion")
    gap = motion["position_z"]/DIAMETER - 0.5
    return motion["time"], gap, -motion["velocity_z"], run


def plot(curves):
    """Gap and velocity against time, a line for each run, of one colour for
    each case; the largest velocity measured."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(
        1, 2, figsize=(11, 4.5), layout="constrained"
    )
    for i, (name, (*_, fastest, _)) in enumerate(CASES.items()):
        runs = [run for label, run in curves.items() if name in label]
        for time, gap, speed in runs:
            axes[0].plot(time, gap, color=f"C{i}", linewidth=1)
            axes[1].plot(time, -speed, color=f"C{i}", linewidth=1)
        if runs:
            axes[0].plot([], color=f"C{i}", label=f"{name}, {len(runs)} runs")
            axes[1].axhline(-fastest, color=f"C{i}", linestyle=":")
    axes[1].plot([], color="black", linestyle=":", label="largest, measured")
    axes[0].set_ylabel("gap / diameter")
    axes[1].set_ylabel("velocity [m/s]")
    for ax in axes:
        ax.set_xlabel("time [s]")
        ax.grid(alpha=0.3)
        ax.legend(loc="upper right")
    PLOT.parent.mkdir(exist_ok=True)
    figure.savefig(PLOT, dpi=150)
    pyplot.close(figure)


def rows(folder, quick):
    curves = {}
    for name, cells, *others in QUICK if quick else FULL:
        time, gap, speed, run = solve(folder, name, cells, *others)
        if run.failed:
            yield run.diverged()
            continue
        curves[f"{run.settings} D/h {cells}"] = time, gap, speed
        yield run.row("V max, m/s", speed.max(), CASES[name][3])
        yield run.row("gap/D at V max", gap[speed.argmax()])
        yield run.row("V, m/s, at gap/D 0.5", np.interp(-0.5, -gap, speed))
    plot(curves)
