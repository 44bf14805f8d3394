# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the runs at Re = 2 and 40: plots/{trajectory,velocity,flow}.png"""

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
runs = {Re: here/f"Re{Re}" for Re in (2, 40)}
colours = {2: "C0", 40: "C3"}

# Steady axial speed and spin at y = -0.3, Re = 2, by body-fitted finite
# elements
reference = {"velocity_x": 1.36129, "angularVelocity_z": -0.44865}


def ambient(y):
    return 1.5*(1 - y**2)


def trajectory(motions):
    figure, ax = plt.subplots(figsize=(7, 3.2))

    for Re, grain in motions.items():
        ax.plot(grain["position_x"], grain["position_y"], color=colours[Re],
                label=f"Re = {Re}")
        ax.plot(grain["position_x"][-1], grain["position_y"][-1], "o",
                color=colours[Re])

    ax.set(xlabel="x [m]", ylabel="y [m]",
           title="Path of the grain's centre (vertical scale enlarged)")
    ax.margins(y=0.3)
    ax.legend()
    gp.save(figure, here/"plots/trajectory.png")


def velocity(motions):
    labels = {
        "velocity_x": "axial velocity [m/s]",
        "velocity_y": "transverse velocity [m/s]",
        "angularVelocity_z": "spin [rad/s]",
    }
    figure, axes = plt.subplots(3, 1, figsize=(7, 7), sharex=True)

    for ax, (name, label) in zip(axes, labels.items()):
        for Re, grain in motions.items():
            ax.plot(grain["time"], grain[name], color=colours[Re],
                    label=f"Re = {Re}")
        if name in reference:
            ax.axhline(reference[name], color="k", linestyle="--", linewidth=1,
                       label="finite elements, Re = 2, y = -0.3")
        ax.set_ylabel(label)

    axes[0].legend(loc="best")
    axes[-1].set_xlabel("time [s]")
    figure.align_ylabels()
    gp.save(figure, here/"plots/velocity.png")


def flow(motions):
    """Disturbance of the axial velocity, and streamlines as seen by an
    observer who travels with the grain."""
    figure, axes = plt.subplots(2, 1, figsize=(7, 6.6))

    for ax, (Re, case) in zip(axes, runs.items()):
        time = gp.planeTimes(case)[-1]
        grain = gp.at(motions[Re], time)
        x0, y0 = grain["position_x"], grain["position_y"]
        x = np.linspace(x0 - 0.5, x0 + 0.5, 301)
        y = np.linspace(y0 - 0.19, y0 + 0.19, 121)

        # The disturbance is small: take it before interpolating
        points, U = gp.readPlane(case, "U", time)
        U[:, 0] -= ambient(points[:, 1])
        ux, uy = (gp.resample(points, U[:, i], x, y) for i in (0, 1))
        image = gp.drawField(ax, x, y, ux, limit=0.03)
        ax.streamplot(
            x, y,
            ux + ambient(y)[:, np.newaxis] - grain["velocity_x"],
            uy - grain["velocity_y"],
            color="0.35", linewidth=0.6, density=1.1, arrowsize=0.7
        )
        gp.drawGrain(ax, (x0, y0), R, gp.angle(grain))
        ax.set(xlabel="x [m]", ylabel="y [m]", title=f"Re = {Re}, t = {time} s",
               xlim=(x[0], x[-1]), ylim=(y[0], y[-1]))

    gp.colourBar(figure, image, axes,
                 "axial velocity less the undisturbed one [m/s]")
    gp.save(figure, here/"plots/flow.png")


motions = {Re: gp.readMotion(case)["grain"] for Re, case in runs.items()}

trajectory(motions)
velocity(motions)
flow(motions)

for Re, grain in motions.items():
    print(f"Re = {Re}: at t = {grain['time'][-1]:g} s y = "
          f"{grain['position_y'][-1]:.4f} m, axial velocity "
          f"{grain['velocity_x'][-1]:.4f} m/s, spin "
          f"{grain['angularVelocity_z'][-1]:.4f} rad/s")
