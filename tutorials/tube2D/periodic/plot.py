# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the run: plots/{train,drive}.png"""

import os
import pathlib
import re
import sys

import numpy as np

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
root = os.environ.get("GRAINFOAM_DIR", here/"../../..")
sys.path.insert(0, f"{root}/tutorials/plotting")

import grainPlots as gp  # source etc/bashrc of grainFoam
from grainPlots import plt

def train(grains):
    """Heights, and which grain gets ahead: positions as if not wrapped."""
    figure, (upper, lower) = plt.subplots(2, 1, figsize=(7, 6))
    motions = list(grains.values())

    for grain in motions:
        upper.plot(grain["unwrapped_x"], grain["position_y"])
    upper.set(xlabel="way along the tube [m]", ylabel="y [m]", ylim=(-1, 1))

    mean = np.mean([grain["unwrapped_x"] for grain in motions], axis=0)
    for grain in motions:
        lower.plot(grain["time"], grain["unwrapped_x"] - mean)
    lower.set(xlabel="t [s]", ylabel="ahead of the mean of all [m]")
    gp.save(figure, here/"plots/train.png")


def drive():
    """Acceleration that holds the flow rate, once per time step."""
    times, values = [], []
    time = None
    for line in (here/"log.foamRun").read_text().splitlines():
        if found := re.fullmatch(r"Time = (\S+)", line):
            time = float(found[1])
        elif found := re.search(r"acceleration (\S+) m/s2", line):
            if times and times[-1] == time:
                values[-1] = float(found[1])
            else:
                times.append(time)
                values.append(float(found[1]))

    figure, ax = plt.subplots(figsize=(7, 3.5))
    ax.plot(times, values, label="with grains")
    ax.axhline(3*0.05, color="k", linestyle=":", label="without")
    ax.set(xlabel="t [s]", ylabel="-dp/dx over density [m/s²]",
           ylim=(0, 1.2*max(values[len(values)//20:])))
    ax.legend()
    gp.save(figure, here/"plots/drive.png")


train(gp.readMotion(here))
drive()
