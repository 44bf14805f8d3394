# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the runs with a = 0.1 to 100: plots/{profile,speed}.png"""

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

Y = -0.3
friction = (0.1, 1, 10, 100)

# Axial speed and spin, by body-fitted finite elements
reference = {1: (1.09039, -0.11210), 100: (1.35078, -0.43561)}


def ambient(y, a):
    """Undisturbed flow of mean speed 1."""
    B = a/(2 + 2*a/3)
    return 1 + B*(1/3 - y**2)


def profile():
    """Cells two half widths ahead of the grain, and the closed form."""
    figure, ax = plt.subplots(figsize=(6, 4.2))
    y = np.linspace(-1, 1, 201)

    for i, a in enumerate(friction):
        case = here/f"states/a{a}"
        points, U = gp.readPlane(case, "U", gp.planeTimes(case)[-1])
        x = points[np.argmin(abs(points[:, 0] - 2)), 0]
        column = abs(points[:, 0] - x) < 1e-6
        ax.plot(ambient(y, a), y, color=f"C{i}", label=f"a = {a} / m")
        ax.plot(U[column, 0], points[column, 1], ".", color=f"C{i}")

    ax.set(xlabel="axial velocity [m/s]", ylabel="y [m]",
           title="Lines: closed form, dots: cells at x = 2")
    ax.legend()
    gp.save(figure, here/"plots/profile.png")


def speed():
    figure, axes = plt.subplots(2, 1, figsize=(6, 5.5), sharex=True)
    names = "velocity_x", "angularVelocity_z"
    labels = "axial velocity [m/s]", "spin [rad/s]"
    a = np.logspace(-1, 2, 200)
    B = a/(2 + 2*a/3)
    undisturbed = ambient(Y, a), Y*B

    for i, (ax, name) in enumerate(zip(axes, names)):
        ax.plot(a, undisturbed[i], "--", color="0.5", label="undisturbed flow")
        values = []
        for f in friction:
            grain, = gp.readMotion(here/f"states/a{f}").values()
            values.append(grain[name][-1])
        ax.plot(friction, values, "o", label="grain")
        ax.plot(list(reference), [r[i] for r in reference.values()], "kx",
                label="finite elements")
        ax.set(xscale="log", ylabel=labels[i])
        for f, value in zip(friction, values):
            print(f"a = {f}: {name} {value:.5f}")

    axes[0].legend()
    axes[1].set_xlabel("a [1/m], one over the slip length")
    gp.save(figure, here/"plots/speed.png")


profile()
speed()
