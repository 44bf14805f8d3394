# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the bed and the profiles: plots/{bed,profiles}.png"""

import os
import pathlib
import sys

import numpy as np

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
root = os.environ.get("GRAINFOAM_DIR", here/"../../..")
sys.path.insert(0, f"{root}/tutorials/plotting")

import grainPlots as gp  # source etc/bashrc of grainFoam
from grainPlots import plt, tables

LENGTH, HEIGHT, WIDTH, MIDDLE = 8, 7, 3, 1.5625
# Of the bed at the start, and its fraction; weight of the spheres less
# buoyancy, per volume and density of the fluid
BED, FRACTION = 3.5, 0.6
WEIGHT = 1.5*5.128
# Time from which on means are taken
FROM = 10


def profiles():
    """Columns of the layers, mean from FROM on: {name: values}."""
    rows = tables.run_columns(here, "averages", "bodyAverages")
    times = np.unique(rows["time"])
    shape = len(times), -1
    late = times > FROM
    phi, eps = rows["bodyFraction"], rows["fluidFraction"]
    found = {"y": rows["position"].reshape(shape)[0]}

    # Means over a phase are weighted with its fraction
    for name, values in rows.items():
        weight = phi if name.startswith("UBodies") else \
            eps if name.startswith("UFluid") else np.ones(len(phi))
        values = np.where(weight > 0, values, 0)*weight
        total = weight.reshape(shape)[late].sum(axis=0)
        with np.errstate(invalid="ignore", divide="ignore"):
            found[name] = values.reshape(shape)[late].sum(axis=0)/total
    return found


def bed():
    """Spheres cut by the middle plane, and fluid, early and at the end."""
    motion = gp.readMotion(here)
    figure, axes = plt.subplots(1, 2, figsize=(9, 4.4), sharey=True)
    times = gp.planeTimes(here)
    for ax, time in zip(axes, (times[0], times[-1])):
        points, U = gp.readPlane(here, "U", time)
        order = np.lexsort((points[:, 0], points[:, 1]))
        speed = U[order, 0].reshape(len(np.unique(points[:, 1])), -1)
        image = ax.imshow(
            speed, extent=(0, LENGTH, 0, HEIGHT), origin="lower",
            cmap="viridis", vmin=0, vmax=3.5, interpolation="bilinear",
        )
        for sphere in motion.values():
            state = gp.at(sphere, time)
            beside = state["position_z"] - MIDDLE
            beside -= WIDTH*round(beside/WIDTH)
            if abs(beside) >= 0.5:
                continue
            r = (0.25 - beside**2)**0.5
            for dx in (-LENGTH, 0, LENGTH):
                x = state["position_x"] % LENGTH + dx
                gp.drawGrain(
                    ax, (x, state["position_y"]), r, facecolor="0.9",
                    edgecolor="k", linewidth=0.6,
                )
        ax.set(xlim=(0, LENGTH), ylim=(0, HEIGHT), aspect="equal",
               xlabel="x / D", title=f"t = {float(time):g}")
        ax.grid(False)
    axes[0].set(ylabel="y / D")
    figure.colorbar(image, ax=axes, label="velocity of the fluid")
    gp.save(figure, here/"plots/bed.png")


def draw(mean):
    """Fractions, velocities, stresses and forces over the height."""
    y = mean["y"]
    figure, axes = plt.subplots(1, 4, figsize=(12, 4.2), sharey=True)
    axes[0].plot(mean["fluidFraction"], y, label="fluid, $\\epsilon$")
    axes[0].plot(mean["bodyFraction"], y, label="spheres, $\\phi$")
    axes[0].set(xlabel="volume fraction", ylabel="y / D", xlim=(0, 1))

    axes[1].plot(mean["UFluid_x"], y, label="fluid, $<u>_f$")
    some = mean["bodyFraction"] > 0.01
    axes[1].plot(mean["UBodies_x"][some], y[some], "--",
                 label="spheres, $<u>_p$")
    axes[1].set(xlabel="velocity x", xscale="log", xlim=(1e-4, 5))

    fluid = mean["stress_xy"] + mean["traction_xy"]
    axes[2].plot(fluid, y, label="fluid, $S_f$")
    axes[2].plot(mean["contact_xy"], y, label="contact")
    axes[2].plot(fluid + mean["contact_xy"], y, "k:", label="sum")
    axes[2].set(xlabel="shear stress xy")

    axes[3].plot(mean["force_y"], y, label="of the fluid, n<f>")
    axes[3].plot(WEIGHT*mean["bodyFraction"], y, "--",
                 label="weight less buoyancy")
    axes[3].set(xlabel="force on the spheres, up")
    for ax in axes:
        ax.legend(fontsize=8)
    gp.save(figure, here/"plots/profiles.png")


def report(mean):
    """Fractions, flux, and viscosity above and in the bed."""
    y, h = mean["y"], mean["y"][1] - mean["y"][0]
    phi = mean["bodyFraction"]
    flux = (phi*np.nan_to_num(mean["UBodies_x"])).sum()*h
    fluid = mean["stress_xy"] + mean["traction_xy"]
    shear = np.gradient(
        mean["fluidFraction"]*mean["UFluid_x"]
        + phi*np.nan_to_num(mean["UBodies_x"]), y
    )
    total = fluid + mean["contact_xy"]
    inner = (y > 1) & (y < HEIGHT - 1)
    clear = inner & (phi < 0.01)
    print(f"fraction in the bed (1 < y < 2.5): "
          f"{phi[(y > 1) & (y < 2.5)].mean():.3f}")
    print(f"spheres carried along: {flux:.4f} D^2 per unit time and width")
    print(f"shear stress, 1 < y < {HEIGHT - 1}: {total[inner].mean():.3f}"
          f" +- {total[inner].std():.3f}; Shields number"
          f" {total[clear].mean()/WEIGHT if clear.any() else np.nan:.3f}")
    for low, high in ((0.05, 0.2), (0.2, 0.4), (0.4, 0.55)):
        here_ = inner & (phi > low) & (phi < high)
        if here_.any():
            print(f"  phi {phi[here_].mean():.2f}: viscosity"
                  f" {(fluid[here_]/shear[here_]).mean():.2f} (fluid),"
                  f" {(total[here_]/shear[here_]).mean():.2f} (with contact)")


mean = profiles()
bed()
draw(mean)
report(mean)
