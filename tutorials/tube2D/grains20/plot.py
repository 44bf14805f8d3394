# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the two runs: plots/{trajectories,velocity,flow}.png"""

import os
import pathlib
import sys

import numpy as np

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
root = os.environ.get("GRAINFOAM_DIR", here/"../../..")
sys.path.insert(0, f"{root}/tutorials/plotting")

import grainPlots as gp  # source etc/bashrc of grainFoam
from grainPlots import plt

R = 0.065
runs = {ratio: here/f"ratio{ratio}" for ratio in (2, 1000)}


def ambient(y):
    return 1.5*(1 - y**2)


def tube(ax, xMax=2.2):
    ax.axhline(-1, color="k", linewidth=2)
    ax.axhline(1, color="k", linewidth=2)
    ax.set(xlim=(-3, xMax), ylim=(-1.05, 1.05), ylabel="y [m]", aspect="equal")


def colourOf(grain):
    """By height at the start: the same grain, the same colour."""
    return plt.cm.viridis((grain["position_y"][0] + 1)/2)


def trajectories(motions):
    figure, axes = plt.subplots(2, 1, figsize=(8, 7), sharex=True)

    for ax, (ratio, grains) in zip(axes, motions.items()):
        tube(ax)
        for grain in grains.values():
            x, y = grain["position_x"], grain["position_y"]
            colour = colourOf(grain)
            ax.plot(x, y, color=colour, zorder=4)
            gp.drawGrain(ax, (x[0], y[0]), R, facecolor="none",
                         edgecolor=colour, linestyle=":")
            gp.drawGrain(ax, (x[-1], y[-1]), R, gp.angle(gp.at(grain, 1e9)),
                         facecolor="white", edgecolor=colour)
        ax.set_title(f"density ratio {ratio}: from the start (dotted) to "
                     f"t = {grain['time'][-1]:g} s")

    axes[-1].set_xlabel("x [m]")
    gp.save(figure, here/"plots/trajectories.png")


def velocity(motions):
    figure, axes = plt.subplots(1, 2, figsize=(8, 3.8), sharey=True)

    for ax, (ratio, grains) in zip(axes, motions.items()):
        for grain in grains.values():
            ax.plot(grain["time"], grain["velocity_x"], color=colourOf(grain),
                    linewidth=1)
        ax.set(xlabel="time [s]", title=f"density ratio {ratio}")

    axes[0].set(ylabel="axial velocity [m/s]", ylim=(0, None))
    figure.colorbar(plt.cm.ScalarMappable(plt.Normalize(-1, 1), "viridis"),
                    ax=axes, label="y at the start [m]")
    gp.save(figure, here/"plots/velocity.png")


def flow(motions):
    """Axial velocity at the first and the last time."""
    figure, axes = plt.subplots(4, 1, figsize=(7, 11), sharex=True)
    x, y = np.linspace(-2.98, 2.2, 600), np.linspace(-0.99, 0.99, 240)
    frames = [(ratio, i) for ratio in runs for i in (0, -1)]

    for ax, (ratio, i) in zip(axes, frames):
        time = gp.planeTimes(runs[ratio])[i]
        points, U = gp.readPlane(runs[ratio], "U", time)
        u = gp.resample(points, U[:, 0], x, y)
        image = gp.drawField(ax, x, y, u, limit=(0, 2.2), cmap="viridis")
        tube(ax)

        for grain in motions[ratio].values():
            state = gp.at(grain, time)
            gp.drawGrain(ax, (state["position_x"], state["position_y"]), R,
                         gp.angle(state), linewidth=0.8)
        ax.set_title(f"density ratio {ratio}, t = {time} s")

    axes[-1].set_xlabel("x [m]")
    gp.colourBar(figure, image, axes, "axial velocity [m/s]")
    gp.save(figure, here/"plots/flow.png")


motions = {ratio: gp.readMotion(case) for ratio, case in runs.items()}

trajectories(motions)
velocity(motions)
flow(motions)

for ratio, grains in motions.items():
    mean = np.mean([grain["velocity_x"][-1] for grain in grains.values()])
    print(f"Density ratio {ratio}: mean axial velocity of the {len(grains)} "
          f"grains at the end {mean:.4f} m/s")
