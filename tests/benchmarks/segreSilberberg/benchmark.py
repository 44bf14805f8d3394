# SPDX-License-Identifier: GPL-3.0-or-later
"""Radius at which a neutrally buoyant sphere in a round tube has no lift."""

import numpy as np

import roundTube
from bodyCase import BodyCase
from boxMesh import graded
from grainfoam.study import analysis
from measure import Run, number_of_cells, set_profile, set_viscosity

# Radius over that of the tube; where Segre & Silberberg 1962 found spheres of
# 0.05 to 0.15, over the radius of the tube
RADIUS, GATHER = 0.15, 0.6
# Distances from the axis at which it is held, by Re = mean speed x diameter/nu
PLACES = {20: (0.5, 0.575, 0.65), 60: (0.55, 0.61, 0.68), 200: (0.6, 0.66, 0.72)}
# Re, D/h
QUICK = ((20, 8),)
FULL = ((20, 8), (60, 8), (200, 8), (20, 12))
# Ends of the tube; largest growth of cells; time step over h; latest end
LENGTH, GROWTH, STEP, END = 2.5, 1.2, 4, 40


def tube(folder, name, h):
    """The tube with undisturbed flow, its cells of size h about the sphere."""
    core = h*round((RADIUS + 0.3)/h)
    case = BodyCase("tube", folder, name)
    set_profile(
        case, "1.5*(1 - sqr(pos().y()))",
        "2*(1 - sqr(pos().y()) - sqr(pos().z()))",
    )
    roundTube.write(
        case, graded(-LENGTH, LENGTH, (-core, core), h, GROWTH), h
    )
    case.run("blockMesh")
    case.run("setExprFields")
    return case


def hold(folder, Re, cells, y):
    """Lift over rho U^2 a^2, speed over that of the fluid there, spin, change
    of the lift over the last tenth, and the run."""
    h = 2*RADIUS/cells
    case = tube(folder, f"Re{Re}_D{cells}_y{y:g}", h)
    set_viscosity(case, 2/Re)
    case.bodies(f"""
        sphere
        {{
            shape       {{ type sphere; radius {RADIUS}; }}
            densityRatio 1;
            position    (0 {y} 0);
            velocity    ambient;
            constraints {{ translate (1 0 0); }}
        }}
    """, "window { type comoving; direction (1 0 0); }\nsteady {}")
    case.controls(endTime=f"{END}", deltaT=f"{STEP*h:.6g}")
    run = Run(case, f"Re {Re}", cells, number_of_cells(case), may_fail=True)
    if run.failed:
        return None, run
    lift = case.table("forces")["fluidForce_y"]/RADIUS**2
    motion = case.table("motion")
    slip = motion["velocity_x"][-1]/(2*(1 - y**2))
    early = lift[int(0.9*len(lift))]
    return (
        lift[-1], slip, motion["angularVelocity_z"][-1], lift[-1] - early
    ), run


def rows(folder, quick):
    for Re, cells in QUICK if quick else FULL:
        held, cpu = [], 0
        for y in PLACES[Re]:
            values, run = hold(folder, Re, cells, y)
            cpu += run.cpu
            if run.failed:
                yield run.diverged()
                break
            held.append(values)
            yield run.row(f"lift at r/R {y:g}", values[0])
        else:
            run.cpu = cpu
            lift, slip, spin, drift = np.array(held).T
            (zero,) = analysis.zeros(PLACES[Re], lift)
            y = zero.x
            known = GATHER if Re <= 30 else None
            yield run.row("r/R without lift", y, known)
            for name, values in (("speed/undisturbed", slip), ("spin", spin)):
                there = np.polyval(np.polyfit(PLACES[Re], values, 2), y)
                yield run.row(f"{name} there", there)
            yield run.row("last change, %", 100*abs(drift).max()/np.ptp(lift))


def draw(rows, file):
    """Write the figure: lift over the distance from the axis."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    curves, zeros = {}, {}
    for row in rows:
        key = f"{row['settings']}, D/h {row['D_over_h']}"
        name, value = row["quantity"], float(row["value"])
        if name.startswith("lift at"):
            curves.setdefault(key, []).append((float(name.split()[-1]), value))
        if name == "r/R without lift":
            zeros[key] = value
    figure, ax = pyplot.subplots(figsize=(6, 4), layout="constrained")
    ax.axhline(0, color="0.5", linewidth=0.8)
    ax.axvline(GATHER, color="0.5", linestyle="--", label="Segre & Silberberg")
    for i, (key, points) in enumerate(curves.items()):
        y, lift = np.array(points).T
        if len(y) < 3:
            continue
        fine = np.linspace(y[0], y[-1])
        ax.plot(fine, np.polyval(np.polyfit(y, lift, 2), fine), f"C{i}")
        ax.plot(y, lift, f"C{i}o", label=f"{key}: {zeros[key]:.3f}")
    ax.set(xlabel="r / R", ylabel="lift / (rho U^2 a^2)")
    ax.legend(fontsize=8)
    figure.savefig(file, dpi=110)
    pyplot.close(figure)
