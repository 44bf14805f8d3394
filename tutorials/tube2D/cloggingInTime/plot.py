# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws flow rates against time and the grains at the end:
plots/{flowRate,grains}.png; prints the figures of the README."""

import os
import pathlib
import sys

import numpy as np

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
root = os.environ.get("GRAINFOAM_DIR", here/"../../..")
sys.path.insert(0, f"{root}/tutorials/plotting")

import grainPlots as gp  # source etc/bashrc of grainFoam
from grainfoam import tables
from grainfoam.study import results
from grainPlots import plt

GRAIN, DEPTH = 0.1, 0.1

# Where the posts are
POSTS = 1

# What an average over time leaves out: the grains reach the posts
START = 10


def read():
    """Of each opening the draws that have finished: {opening: [(seed, times,
    flow rates, motion)]}."""
    table = results.read_table(here/"postProcessing/study.csv")
    found = {}
    for i in np.flatnonzero(table["status"] == "finished"):
        case = here/"states"/str(table["state"][i])
        flow = tables.run_columns(case, "flowRate")
        found.setdefault(table["opening"][i], []).append((
            int(table["seed"][i]), flow["time"], flow["sum(phi)"]/DEPTH,
            gp.readMotion(case)))
    return found


def grains(motion):
    """Those of a run, without posts."""
    return [body for name, body in motion.items() if name.startswith("grain")]


def passages(motion):
    """Times at which grains pass the middle of the posts, the first ones
    first."""
    times = []
    for grain in grains(motion):
        beyond = grain["position_x"] > POSTS
        if beyond.any():
            times.append(grain["time"][beyond][0])
    return np.sort(times)


def last(motion):
    """The last time of the table, which has not every time step."""
    return max(grain["time"][-1] for grain in grains(motion))


def curves(found):
    """Each draw, their mean and its band of one standard deviation."""
    figure, axes = plt.subplots(2, len(found), figsize=(10, 6), sharex=True,
                                sharey="row", squeeze=False)
    for (upper, lower), (opening, draws) in zip(axes.T, found.items()):
        # Time steps that were repeated were shorter
        time = np.linspace(0, draws[0][1][-1], 500)
        rates = np.array([np.interp(time, t, rate) for _, t, rate, _ in draws])
        mean = rates.mean(axis=0)
        deviation = rates.std(axis=0, ddof=1)
        upper.fill_between(time, mean - deviation, mean + deviation,
                           color="0.85")
        for i, (seed, t, rate, motion) in enumerate(draws):
            upper.plot(t, rate, color=f"C{i}", linewidth=0.7)
            times = passages(motion)
            lower.step([0, *times, last(motion)],
                       [*range(len(times) + 1), len(times)], color=f"C{i}",
                       linewidth=1, where="post", label=f"draw {seed}")
        upper.plot(time, mean, "k", label="mean, band: standard deviation")
        upper.set(title=f"opening {opening/(2*GRAIN):g} grains wide")
        lower.set(xlabel="time [s]")
    axes[0, 0].set(ylabel="flow rate [m²/s]", ylim=(0, None))
    axes[1, 0].set(ylabel="grains that have passed", ylim=(0, None))
    axes[0, 0].legend(fontsize=8)
    axes[1, 0].legend(fontsize=8)
    gp.save(figure, here/"plots/flowRate.png")


def pictures(found):
    """Grains of each draw at its end."""
    rows = max(map(len, found.values()))
    figure, axes = plt.subplots(rows, len(found), figsize=(10, 1.8*rows),
                                sharex=True, sharey=True, squeeze=False)
    for column, (opening, draws) in zip(axes.T, found.items()):
        for ax, (seed, _, rate, motion) in zip(column, draws):
            for side in (-1, 1):
                post = plt.Circle((POSTS, side), 1 - opening/2, color="0.6")
                ax.add_patch(post)
            for grain in grains(motion):
                if grain["time"][-1] >= last(motion):
                    centre = [grain[f"position_{k}"][-1] for k in "xy"]
                    gp.drawGrain(ax, centre, GRAIN, linewidth=0.6)
            ax.set(xlim=(-3, 3), ylim=(-1, 1), aspect="equal")
            ax.set_title(f"opening {opening:g} m, draw {seed}: "
                         f"{rate[-1]:.4f} m²/s", fontsize=9)
            ax.grid(False)
    gp.save(figure, here/"plots/grains.png")


def summary(found):
    """Flow rates over time and draws, grains that are left."""
    for opening, draws in found.items():
        for seed, time, rate, motion in draws:
            late = rate[time >= START]
            print(f"opening {opening:g}, draw {seed}: Q {late.mean():.4f}"
                  f" ({late.min():.4f} to {late.max():.4f}), at the end "
                  f"{rate[-1]:.4f} m2/s; {len(passages(motion))} of "
                  f"{len(grains(motion))} grains have passed")


def main():
    found = read()
    curves(found)
    pictures(found)
    summary(found)


main()
