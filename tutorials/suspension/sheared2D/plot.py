# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the runs: plots/{viscosity,discs}.png"""

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

ENDS = {
    "sliding": "no walls, box slides", "walls": "both walls move",
    "wallAtRest": "bottom wall at rest",
}
CONTACTS = {"viscous": "-", "inelastic": "--"}
R, NU = 0.0618039, 10
# Exact: square arrays of discs of that area fraction, at shifts 0 and 1/2
ARRAYS = 1.46535637, 1.56648162


def viscosity():
    """Effective viscosity over time."""
    figure, ax = plt.subplots(figsize=(8, 4.6))
    ax.axhspan(*ARRAYS, color="0.88", label="square arrays, exact")
    for k, (ends, name) in enumerate(ENDS.items()):
        for contact, style in CONTACTS.items():
            columns = tables.run_columns(
                here/f"runs/{ends}.{contact}", "stress", "suspensionStress"
            )
            time, value = columns["time"], columns["viscosity"]/NU
            ax.plot(time, value, style, color=f"C{k}",
                    label=f"{name}, {contact}")
            late = value[time > 2]
            print(f"{name}, {contact}: {late.mean():.3f} from t = 2 on")
    ax.set(xlabel="t", ylabel="viscosity over that of the fluid",
           ylim=(1.2, None))
    ax.legend(fontsize=8, ncol=2)
    gp.save(figure, here/"plots/viscosity.png")


def discs():
    """Where they are at the end."""
    figure, axes = plt.subplots(
        len(CONTACTS), len(ENDS), figsize=(9, 6.4), sharex=True, sharey=True
    )
    for row, contact in zip(axes, CONTACTS):
        for ax, (ends, name) in zip(row, ENDS.items()):
            case = here/f"runs/{ends}.{contact}"
            for disc in gp.readMotion(case).values():
                x, y = disc["position_x"][-1], disc["position_y"][-1]
                for dx in (-1, 0, 1):
                    gp.drawGrain(ax, (x + dx, y), R, gp.angle(gp.at(disc, 1e9)),
                                 facecolor="white", edgecolor="C0")
            ax.set(xlim=(0, 1), ylim=(0, 1), aspect="equal",
                   title=f"{name}, {contact}")
            ax.title.set_fontsize(9)
    gp.save(figure, here/"plots/discs.png")


viscosity()
discs()
