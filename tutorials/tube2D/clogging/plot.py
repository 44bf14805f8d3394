# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the table of flow rates, and the flows with the highest and the lowest:
plots/{flowRate,free,held}.png"""

import os
import pathlib
import sys

import numpy as np

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
root = os.environ.get("GRAINFOAM_DIR", here/"../../..")
sys.path[:0] = [f"{root}/tutorials/plotting", str(here)]

import grainPlots as gp  # source etc/bashrc of grainFoam
import flowRates
from grainfoam.study import analysis
from grainPlots import plt

R = 0.065

# Of the empty tube by body-fitted finite elements
EMPTY = 0.042754


def scatter():
    """Flow rate against how near the walls the grains are, and how often."""
    figure, axes = plt.subplots(2, 2, figsize=(9, 6), width_ratios=(3, 1))

    for (ax, side), kind in zip(axes, flowRates.KINDS):
        table = flowRates.read(kind)
        share = table["Q"]/EMPTY
        ax.plot(table["height"], share, "o", markersize=4)
        ax.set(xlabel="mean |y| of the grains [m]",
               ylabel="flow rate over that\nof the empty tube",
               title=f"{kind} grains")
        side.hist(share, bins=max(8, len(share)//20),
                  orientation="horizontal")
        side.set(xlabel="draws", ylim=ax.get_ylim())

    gp.save(figure, here/"plots/flowRate.png")


def flow(table, kind):
    """Speed and grains of the best and the worst draws."""
    draws = flowRates.extremes(table)
    figure, axes = plt.subplots(3, 2, figsize=(11, 6), sharex=True,
                                sharey=True)
    x, y = np.linspace(-3.97, 3.97, 800), np.linspace(-0.99, 0.99, 200)
    speeds = {}
    for draw in draws:
        case = here/f"extremes/kind{kind}_draw{draw}"
        points, U = gp.readPlane(case, "U", gp.planeTimes(case)[-1])
        speeds[draw] = gp.resample(points, np.hypot(*U.T[:2]), x, y)
    largest = max(speed.max() for speed in speeds.values())

    for ax, draw in zip(axes.T.flat, draws):
        image = gp.drawField(ax, x, y, speeds[draw], (0, largest), "viridis")
        for centre in flowRates.centres(draw):
            gp.drawGrain(ax, centre, R, linewidth=0.6)
        Q = table["Q"][table["draw"] == draw][0]
        ax.set_title(f"draw {draw}: Q = {Q:.5f} m²/s")
        ax.axhline(-1, color="k", linewidth=2)
        ax.axhline(1, color="k", linewidth=2)
        ax.set(xlim=(-4, 4), ylim=(-1.05, 1.05))

    figure.suptitle(f"{kind} grains: the highest flow rates (left), the lowest "
                    "(right)")
    gp.colourBar(figure, image, axes, "speed [m/s]")
    gp.save(figure, here/f"plots/{kind}.png")


def main():
    scatter()
    for kind in flowRates.KINDS:
        table = flowRates.read(kind)
        flow(table, kind)
        Q, change = table["Q"], table["change"]
        slope = np.corrcoef(table["height"], Q)[0, 1]
        _, low, high = analysis.mean_interval(Q)
        print(f"{kind}: Q {Q.min():.5f} to {Q.max():.5f}, mean {Q.mean():.5f} "
              f"({low:.5f} to {high:.5f} with 95 %), "
              f"standard deviation {Q.std(ddof=1):.5f} m2/s; correlation with "
              f"mean |y| {slope:.2f}; largest change in the last quarter of "
              f"the time {100*np.abs(change).max():.2f} %")


main()
