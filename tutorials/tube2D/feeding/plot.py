# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the run: plots/{spacing,flow,sensor*}.png"""

import os
import pathlib
import sys

import numpy as np

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
root = os.environ.get("GRAINFOAM_DIR", here/"../../..")
sys.path.insert(0, f"{root}/tutorials/plotting")

import animate  # source etc/bashrc of grainFoam
import grainPlots as gp
import sensorPlots
from grainPlots import plt


def intervals(times):
    return np.diff(np.sort(list(times.values())))


def spacing(entered, left, height):
    """When each grain enters and leaves, and the time to the next one."""
    figure, (ax, below) = plt.subplots(2, 1, figsize=(8, 6))

    for name, time in left.items():
        ax.plot([entered[name], time], [0, 1], "-o", markersize=4,
                color=plt.cm.viridis((height[name] + 1)/2))
    ax.set(xlabel="time [s]", yticks=(0, 1), yticklabels=("inlet", "outlet"))
    figure.colorbar(plt.cm.ScalarMappable(plt.Normalize(-1, 1), "viridis"),
                    ax=ax, label="y at the inlet [m]")

    for times, label in ((entered, "inlet"), (left, "outlet")):
        below.step(range(1, len(times)), intervals(times), where="mid",
                   label=label)
    below.set(xlabel="number of the grain, in the order there",
              ylabel="time to the next [s]")
    below.set_ylim(bottom=0)
    below.legend()
    gp.save(figure, here/"plots/spacing.png")


def flow(grains, shapes):
    """Axial velocity at three times."""
    times = gp.planeTimes(here)
    frames = [times[len(times)*k//10] for k in (2, 5, 8)]
    figure, axes = plt.subplots(3, 1, figsize=(7, 10), sharex=True)
    x, y = np.linspace(0.02, 3.98, 400), np.linspace(-0.98, 0.98, 200)

    for ax, time in zip(axes, frames):
        points, U = gp.readPlane(here, "U", time)
        u = gp.resample(points, U[:, 0], x, y)
        image = gp.drawField(ax, x, y, u, limit=(0, 1.6), cmap="viridis")

        for name, grain in grains.items():
            state = gp.at(grain, time)
            if abs(state["time"] - float(time)) < 1e-6:
                corners = animate.hull(shapes[name][:, :2])
                x0, y0 = state["position_x"], state["position_y"]
                ax.fill(x0 + corners[:, 0], y0 + corners[:, 1],
                        facecolor="0.93", edgecolor="k", linewidth=0.8,
                        zorder=5)
        ax.set(xlim=(0, 4), ylim=(-1, 1), ylabel="y [m]", title=f"t = {time} s")

    axes[-1].set_xlabel("x [m]")
    gp.colourBar(figure, image, axes, "axial velocity [m/s]")
    gp.save(figure, here/"plots/flow.png")


events = gp.readPassage(here)
entered = {e["name"]: e["time"] for e in events if e["what"] == "enters"}
height = {e["name"]: e["position_y"] for e in events if e["what"] == "enters"}
left = {e["name"]: e["time"] for e in events if e["what"] == "leaves"}

spacing(entered, left, height)
grains, numbers = animate.readGrains(here)
flow(grains, animate.readShapes(here, grains, numbers))
sensorPlots.drawAll(here)

for times, where in ((entered, "inlet"), (left, "outlet")):
    dt = intervals(times)
    print(f"{len(times)} grains at the {where}: {dt.mean():.3f} s apart, "
          f"standard deviation {dt.std():.3f} s, least {dt.min():.3f} s")
