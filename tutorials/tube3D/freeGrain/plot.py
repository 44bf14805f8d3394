# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the run: plots/{trajectory,velocity,flow}.png"""

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

R = 0.3

# Force-free sphere of this size on the axis, Stokes flow (exact series)
onAxis = 0.94046*2


def ambient(y):
    return 2*(1 - y**2)


def trajectory(grain):
    figure, ax = plt.subplots(figsize=(7, 3))

    ax.plot(grain["position_x"], grain["position_y"], label="y")
    ax.plot(grain["position_x"], grain["position_z"], label="z")
    ax.set(xlabel="x [m]", ylabel="y, z [m]",
           title="Path of the grain's centre (vertical scale enlarged)")
    ax.legend()
    gp.save(figure, here/"plots/trajectory.png")


def velocity(grain):
    labels = {
        "velocity_x": "axial velocity [m/s]",
        "velocity_y": "transverse velocity [m/s]",
        "angularVelocity_z": "spin about z [rad/s]",
    }
    figure, axes = plt.subplots(3, 1, figsize=(7, 7), sharex=True)

    for ax, (name, label) in zip(axes, labels.items()):
        ax.plot(grain["time"], grain[name])
        ax.set_ylabel(label)

    axes[0].plot(grain["time"], ambient(grain["position_y"]), "k:",
                 linewidth=1, label="undisturbed flow at its centre")
    axes[0].axhline(onAxis, color="k", linestyle="--", linewidth=1,
                    label="exact for Stokes flow, on the axis")
    axes[2].plot(grain["time"], 2*grain["position_y"], "k:", linewidth=1,
                 label="half the vorticity of the undisturbed flow")
    axes[0].legend(loc="upper right", bbox_to_anchor=(1, 0.88))
    axes[2].legend()
    axes[2].set_xlabel("time [s]")
    figure.align_ylabels()
    gp.save(figure, here/"plots/velocity.png")


def flow(grain):
    """The plane z = 0 at the end: axial velocity less the undisturbed one, and
    streamlines as seen by an observer who travels with the grain."""
    figure, ax = plt.subplots(figsize=(7, 5.8))

    time = gp.planeTimes(here)[-1]
    state = gp.at(grain, time)
    x0, y0 = state["position_x"], state["position_y"]
    x, y = np.linspace(x0 - 1.5, x0 + 1.5, 301), np.linspace(-0.97, 0.97, 195)

    # The disturbance is small: take it before interpolating
    points, U = gp.readPlane(here, "U", time)
    U[:, 0] -= ambient(points[:, 1])
    ux, uy = (gp.resample(points, U[:, i], x, y) for i in (0, 1))
    image = gp.drawField(ax, x, y, ux, limit=0.15)
    ax.streamplot(x, y,
                  ux + ambient(y)[:, np.newaxis] - state["velocity_x"],
                  uy - state["velocity_y"],
                  color="0.35", linewidth=0.6, density=1.3, arrowsize=0.7)
    gp.drawGrain(ax, (x0, y0), R, gp.angle(state))

    for wall in (-1, 1):
        ax.axhline(wall, color="k", linewidth=2)

    ax.set(xlabel="x [m]", ylabel="y [m]", title=f"Plane z = 0, t = {time} s",
           xlim=(x[0], x[-1]), ylim=(-1.03, 1.03))
    gp.colourBar(figure, image, ax,
                 "axial velocity less the undisturbed one [m/s]")
    gp.save(figure, here/"plots/flow.png")


grain = gp.readMotion(here)["grain"]

trajectory(grain)
velocity(grain)
flow(grain)

print(f"At t = {grain['time'][-1]:g} s y = {grain['position_y'][-1]:.4f} m, "
      f"axial velocity {grain['velocity_x'][-1]:.4f} m/s, spin "
      f"{grain['angularVelocity_z'][-1]:.4f} rad/s")
