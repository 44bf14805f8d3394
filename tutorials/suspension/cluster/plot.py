# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the two runs: plots/{clusters,distances}.png"""

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

R, BOX, RATE = 0.05, 1.0, 1.0
CONTACTS = "viscous", "inelastic"
# Of a gap, over the radius, with which two touch: a cell is 0.42
TOUCH = 0.1


def positions(case):
    """Times, and positions [time, sphere, 3] in the box."""
    motion = gp.readMotion(case).values()
    x = np.array([
        np.stack([m[f"position_{k}"] for k in "xyz"], axis=1) for m in motion
    ])
    return next(iter(gp.readMotion(case).values()))["time"], x.swapaxes(0, 1)


def distances(time, x):
    """Between all pairs, nearest images: [time, pair]."""
    i, j = np.triu_indices(x.shape[1], 1)
    d = x[:, j] - x[:, i]
    above = np.round(d[:, :, 1]/BOX)
    d[:, :, 1] -= BOX*above
    d[:, :, 0] -= above*(RATE*BOX*time[:, None])
    for k in (0, 2):
        d[:, :, k] -= BOX*np.round(d[:, :, k]/BOX)
    return np.linalg.norm(d, axis=2)


def clusters(runs):
    """The spheres from the side, at the start and later."""
    times = 0, 5, 15, 35
    figure, axes = plt.subplots(
        len(runs), len(times), figsize=(10, 5.4), sharex=True, sharey=True
    )
    for row, (contact, (time, x)) in zip(axes, runs.items()):
        for ax, t in zip(row, times):
            step = int(np.abs(time - t).argmin())
            order = np.argsort(x[step, :, 2])
            for sphere in order:
                colour = plt.cm.viridis(sphere/x.shape[1])
                centre = x[step, sphere]
                for dx in (-BOX, 0, BOX):
                    gp.drawGrain(
                        ax, (centre[0] + dx, centre[1]), R,
                        facecolor=colour, edgecolor="k", linewidth=0.5,
                    )
            ax.set(
                xlim=(0, BOX), ylim=(0, BOX), aspect="equal",
                title=f"{contact}, t = {time[step]:.3g}",
            )
    gp.save(figure, here/"plots/clusters.png")


def history(runs):
    """Pairs that touch, and the mean distance of the pairs, over time."""
    figure, axes = plt.subplots(2, 1, figsize=(8, 6), sharex=True)
    for contact, (time, x) in runs.items():
        d = distances(time, x)
        touching = (d < (2 + TOUCH)*R).sum(axis=1)
        axes[0].plot(time, touching, label=contact)
        axes[1].plot(time, d.mean(axis=1)/R, label=contact)
        at_start = d[:, d[0] < (2 + TOUCH)*R]
        print(
            f"{contact}: of {at_start.shape[1]} pairs that touched"
            f" {(at_start[-1] < (2 + TOUCH)*R).sum()} do at the end; largest"
            f" gap ever of these {at_start.max()/R - 2:.3g} R, smallest of all"
            f" {d.min()/R - 2:.2g} R"
        )
    axes[0].set(ylabel=f"pairs with gaps < {TOUCH} R")
    axes[1].set(ylabel="mean distance / R", xlabel="t")
    axes[0].legend()
    gp.save(figure, here/"plots/distances.png")


runs = {contact: positions(here/contact) for contact in CONTACTS}
clusters(runs)
history(runs)
