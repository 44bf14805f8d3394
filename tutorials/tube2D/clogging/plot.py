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

# Of the empty tube by body-fitted finite elements
EMPTY = 0.042754

# Abscissa of the scatter
DECIDES = {"free": "square", "held": "chain"}
QUANTILES = 5, 25, 50, 75, 95


def scatter():
    """Flow rate against what says most of it, and how often."""
    figure, axes = plt.subplots(2, 2, figsize=(9, 6), width_ratios=(3, 1))

    for (ax, side), kind in zip(axes, flowRates.KINDS):
        table = flowRates.read(kind)
        share = table["Q"]/EMPTY
        x = DECIDES[kind]
        r, low, high = analysis.correlation_interval(table[x], share)
        ax.plot(table[x], share, "o", markersize=4)
        ax.set(xlabel=flowRates.MEASURES[x],
               ylabel="flow rate over that\nof the empty tube",
               title=f"{kind} grains, {len(share)} draws: correlation {r:.2f}"
                     f" ({low:.2f} to {high:.2f})")
        side.hist(share, bins=max(8, len(share)//20),
                  orientation="horizontal")
        _, low, high = analysis.mean_interval(share)
        side.axhspan(low, high, color="C1", alpha=0.5)
        side.set(xlabel="draws", ylim=ax.get_ylim())

    gp.save(figure, here/"plots/flowRate.png")


def summary(kind, table):
    """Distribution of Q, each figure with its 95 % interval, and what Q goes
    with."""
    Q = table["Q"]
    print(f"{kind}: {len(Q)} draws, Q {Q.min():.5f} to {Q.max():.5f} m2/s")
    statistics = {
        "mean": np.mean,
        "standard deviation": lambda values: values.std(ddof=1),
    }
    for share in QUANTILES:
        statistics[f"quantile {share} %"] = \
            lambda values, share=share: np.percentile(values, share)
    for name, statistic in statistics.items():
        value, low, high = analysis.interval(statistic, Q)
        print(f"    {name} {value:.5f} ({low:.5f} to {high:.5f})")
    for name, what in flowRates.MEASURES.items():
        r, low, high = analysis.correlation_interval(table[name], Q)
        print(f"    correlation with {what}: {r:.2f} ({low:.2f} to {high:.2f})")
    print("    largest change in the last quarter of the time "
          f"{100*np.abs(table['change']).max():.2f} %")


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
            gp.drawGrain(ax, centre, flowRates.RADIUS, linewidth=0.6)
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
        summary(kind, table)


main()
