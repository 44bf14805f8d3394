# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the run: plots/plug.png"""

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

RHO, D = 1.2, 2             # [kg/m3], [mm]
LENGTH = 180                # [mm]
TIMES = (0.005, 0.1, 0.25, 0.3, 0.35)


def pressure():
    """Times [s] and pressure drop [Pa]."""
    file = here/"postProcessing/inlet/0/surfaceFieldValue.dat"
    t, p = np.loadtxt(file, comments="#").T
    return t, RHO*p


def draw():
    rows = tables.run_columns(here, "motion", "immersedBodyMotion")
    t, drop = pressure()
    figure, axes = plt.subplots(
        len(TIMES) + 1, 1, figsize=(7.5, 7), constrained_layout=True,
        gridspec_kw={"height_ratios": [3] + [1]*len(TIMES)},
    )
    axes[0].plot(t, drop, color="C0")
    axes[0].set(xlabel="time [s]", ylabel="pressure drop [Pa]",
                ylim=(0, 1.1*drop[t > 0.02].max()), xlim=(0, t[-1]))
    times = np.unique(rows["time"])
    for ax, wanted in zip(axes[1:], TIMES):
        time = times[np.argmin(abs(times - wanted))]
        axes[0].axvline(time, color="0.7", linewidth=0.8)
        now = rows["time"] == time
        bar = np.char.startswith(rows["name"][now].astype(str), "bar")
        x, z = (1e3*rows[f"position_{k}"][now] for k in "xz")
        for grains, colour, size in ((~bar, "C1", D), (bar, "0.3", 1.3*D)):
            for at in zip(x[grains], z[grains]):
                ax.add_patch(plt.Circle(at, size/2, facecolor=colour,
                                        edgecolor="k", linewidth=0.2))
        ax.set(xlim=(0, LENGTH), ylim=(-6, 6), aspect="equal", yticks=[],
               title=f"{1e3*time:.0f} ms")
        ax.title.set_fontsize(8)
        ax.tick_params(labelbottom=ax is axes[-1])
    axes[-1].set(xlabel="x [mm]")
    gp.save(figure, here/"plots/plug.png")

    packed = (t > 0.2) & (t < 0.25)
    print(f"pressure drop of the plug {drop[packed].mean():.0f} Pa, "
          f"at the end {drop[-20:].mean():.0f} Pa")


draw()
