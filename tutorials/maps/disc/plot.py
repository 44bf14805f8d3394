# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws where a disc goes: plots/{velocities,lateral,migration}.png"""

import os
import pathlib
import sys

import numpy as np

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
root = os.environ.get("GRAINFOAM_DIR", here/"../../..")
sys.path[:0] = [f"{root}/tutorials/plotting", str(here)]

import grainPlots as gp  # source etc/bashrc of grainFoam
import discMap
from grainfoam.study import analysis
from grainPlots import plt

# Stable height |y| by body-fitted finite elements, by Re
REFERENCE = {0: 0.48566, 2: 0.48561, 10: 0.48401, 20: 0.47670, 40: 0.43042}

# Of the runs in time
RE = 10


def whole(y, values):
    """Odd in y: with the other half of the tube, and zero in the middle."""
    return np.r_[y, 0, -y[::-1]], np.r_[values, 0, -values[::-1]]


def velocities():
    """Speed and spin at Re = 0, beside the fluid without the disc."""
    columns = discMap.modes()
    y = columns["py0"]
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.6))
    axes[0].plot(y, 1.5*(1 - y**2), "k--", label="undisturbed flow")
    axes[0].plot(y, columns["V_x0"], label="disc")
    axes[0].set(xlabel="y [m]", ylabel="axial velocity [m/s]")
    axes[0].legend()
    axes[1].plot(y, 1.5*y, "k--")
    axes[1].plot(y, columns["V_rz0"])
    axes[1].set(xlabel="y [m]", ylabel="spin [rad/s]")
    gp.save(figure, here/"plots/velocities.png")
    print(f"largest lateral velocity at Re = 0: "
          f"{np.abs(columns['V_y0']).max():.1e} m/s")


def lateral(found):
    """Lateral velocity over Re, its zeros and their stability."""
    figure, ax = plt.subplots(figsize=(7, 4))
    ax.axhline(0, color="0.6", linewidth=0.8)
    for i, (Re, (y, values)) in enumerate(found.items()):
        ax.plot(y, values, f"C{i}", marker="" if Re == 0 else "o",
                markersize=3, label=f"Re = {Re:g}" if Re else "Re → 0, modes")
        for zero in analysis.zeros(*whole(y, values)):
            if zero.x < -1e-9:
                ax.plot(zero.x, 0, f"C{i}o", zorder=3)
            if zero.x < 1e-9:
                print(f"Re {Re:g}: lateral velocity zero at y = {zero.x:.5f},"
                      f" slope over Re {zero.slope:.4e}, {zero.stability}"
                      + (f"; finite elements {-REFERENCE[Re]:.5f}"
                         if zero.x < -0.1 else ""))
    arrivals(ax, list(found))
    ax.set(xlabel="height y [m]", ylabel="lateral velocity over Re [m/s]")
    ax.legend()
    gp.save(figure, here/"plots/lateral.png")


def arrivals(ax, colours):
    """Velocities of free discs in time, and where a cubic has its zero."""
    for Re, (y, values) in discMap.arrivals().items():
        curve = np.polynomial.Polynomial.fit(y, values, 3)
        there = np.linspace(y.min(), y.max(), 200)
        ax.plot(there, curve(there), f"C{colours.index(Re)}--",
                label=f"Re = {Re:g}, free, in time")
        for zero in analysis.zeros(there, curve(there)):
            print(f"Re {Re:g}, free discs in time: at rest at y ="
                  f" {zero.x:.5f}, slope over Re {zero.slope:.4e}")


def migration(found):
    """Heights by time: from many starts by the map, and three runs."""
    y, values = whole(*found[RE])
    figure, ax = plt.subplots(figsize=(7, 4))
    dt, n = 0.5, 800
    for start in np.linspace(-0.85, 0.85, 18):
        heights = [start]
        for _ in range(n):
            middle = heights[-1] + 0.5*dt*RE*np.interp(heights[-1], y, values)
            heights.append(heights[-1] + dt*RE*np.interp(middle, y, values))
        ax.plot(dt*np.arange(n + 1), heights, "0.6", linewidth=1)
    for i, case in enumerate(sorted((here/"window/free").glob("y*"))):
        disc, = gp.readMotion(case).values()
        t, there = disc["time"], disc["position_y"]
        ax.plot(t, there, f"C{i}", label=f"run from y = {there[0]:.2f}")
        mapped = [there[0]]
        for now, following in zip(t, t[1:]):
            step = RE*(following - now)
            middle = mapped[-1] + 0.5*step*np.interp(mapped[-1], y, values)
            mapped.append(mapped[-1] + step*np.interp(middle, y, values))
        print(f"Re {RE}: from y = {there[0]:.2f} to {there[-1]:.4f} at t ="
              f" {t[-1]:g}, by the map to {mapped[-1]:.4f}; largest difference"
              f" {np.abs(there - mapped).max():.4f}")
    ax.plot([], [], "0.6", label="by the map")
    ax.set(xlabel="time [s]", ylabel="height y [m]", title=f"Re = {RE}")
    ax.legend()
    gp.save(figure, here/"plots/migration.png")


def main():
    found = discMap.lateral()
    velocities()
    lateral(found)
    migration(found)


main()
