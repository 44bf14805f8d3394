# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the map of the pair: plots/{along,across,trajectories}.png"""

import os
import pathlib
import sys

import numpy as np

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
root = os.environ.get("GRAINFOAM_DIR", here/"../../..")
sys.path[:0] = [f"{root}/tutorials/plotting", str(here)]

import grainPlots as gp  # source etc/bashrc of grainFoam
import equilibrium
import pairMap
from grainPlots import plt

# Of the runs in time
RE = 1


def at(maps, state):
    """Rates at a state, linear between those of the map; nan out of it."""
    if not np.isfinite(state).all():
        return np.full(3, np.nan)
    # Turned by half a turn the two have changed places
    state = np.r_[state[:2], (state[2] + 0.5*np.pi) % np.pi - 0.5*np.pi]
    index, weight = [], []
    for value, axis in zip(state, (pairMap.A, pairMap.YP, pairMap.THETA)):
        x = (value - axis[0])/(axis[1] - axis[0])
        i = int(np.clip(np.floor(x), 0, len(axis) - 2))
        index.append(i)
        weight.append(x - i)
    rates = np.zeros(3)
    for corner in np.ndindex(2, 2, 2):
        part = np.prod([w if c else 1 - w for c, w in zip(corner, weight)])
        if part:
            i, j, k = (n + c for n, c in zip(index, corner))
            rates += part*(maps[0, i, j, k] + RE*maps[1, i, j, k])
    return rates


def trajectory(maps, start, end, dt=0.02):
    """States by time, by Runge and Kutta's scheme of fourth order; ends where
    the map does."""
    states = [np.array(start)]
    for _ in range(round(end/dt)):
        s = states[-1]
        k1 = at(maps, s)
        k2 = at(maps, s + 0.5*dt*k1)
        k3 = at(maps, s + 0.5*dt*k2)
        k4 = at(maps, s + dt*k3)
        following = s + dt*(k1 + 2*k2 + 2*k3 + k4)/6
        if not np.isfinite(following).all() or following[0] > pairMap.A[-1]:
            break
        states.append(following)
    return dt*np.arange(len(states)), np.array(states)


def run(number):
    """Times and states of a run in time."""
    one, other = gp.readMotion(here/f"runs/start{number}").values()
    apart = np.array([other[f"position_{x}"] - one[f"position_{x}"]
                      for x in "xy"])
    # The tube goes on after 6; bodies have begun less than half of it apart
    apart[0] -= 6*np.round(apart[0]/6)
    states = np.stack([
        0.5*np.hypot(*apart), 0.5*(one["position_y"] + other["position_y"]),
        np.unwrap(2*np.arctan2(apart[1], apart[0]))/2], axis=1)
    # As far as the map goes
    n = np.argmax(np.r_[states[:, 0] > pairMap.A[-1], True])
    return one["time"][:n], states[:n]


def arrows(figure, ax, x, y, u, v, label):
    """Directions of (u, v), coloured by size."""
    size = np.hypot(u, v)
    with np.errstate(invalid="ignore", divide="ignore"):
        drawn = ax.quiver(x, y, u/size, v/size, np.log10(size), pivot="mid",
                          width=0.003)
    gp.colourBar(figure, drawn, ax, f"log10 of {label}")


def along(maps):
    """At Re = 0: rate of the height of pairs in the middle, where those of a and
    theta are zero; rates of a and theta of pairs aside."""
    figure, axes = plt.subplots(1, 2, figsize=(10, 4), sharey=True)
    a, theta = np.meshgrid(pairMap.A, pairMap.THETA)
    rise = maps[0, :, 13, :, 1].T
    largest = np.nanmax(np.abs(rise))
    axes[0].grid(False)
    image = axes[0].pcolormesh(a, theta, rise, cmap="RdBu_r", vmin=-largest,
                               vmax=largest, shading="nearest")
    gp.colourBar(figure, image, axes[0], "rate of the height [m/s]")
    axes[0].set_title("middle at y = 0")
    j = 4
    u, v = (maps[0, :, j, :, i].T for i in (0, 2))
    arrows(figure, axes[1], a, theta, u, a*v, "the speed [m/s]")
    axes[1].set_title(f"middle at y = {pairMap.YP[j]:.2f}: a and angle")
    for ax in axes:
        ax.set_xlabel("half distance a [m]")
    axes[0].set_ylabel("angle with the tube [rad]")
    gp.save(figure, here/"plots/along.png")


def across(maps, zero):
    """Rates of a and yp, to first order in Re, of pairs along and across."""
    figure, axes = plt.subplots(1, 2, figsize=(10, 4), sharey=True)
    a, yp = np.meshgrid(pairMap.A, pairMap.YP)
    for ax, k, name in zip(axes, (13, 26), ("along the tube", "across it")):
        u, v = (maps[1, :, :, k, i].T for i in (0, 1))
        arrows(figure, ax, a, yp, u, v, "the speed over Re [m/s]")
        ax.set(xlabel="half distance a [m]", title=f"pairs {name}")
    axes[1].plot(zero.x, 0, "ro", label=f"at rest, a = {zero.x:.3f}")
    axes[1].legend()
    axes[0].set_ylabel("height of the middle [m]")
    gp.save(figure, here/"plots/across.png")


def trajectories(maps):
    """From the starts of the runs, by the map and in time."""
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.6))
    for number, start in enumerate(pairMap.STARTS):
        t, states = run(number)
        tm, mapped = trajectory(maps, start, t[-1])
        for i, ax in enumerate(axes):
            ax.plot(t, states[:, i], f"C{number}")
            ax.plot(tm, mapped[:, i], "k--", linewidth=1)
        n = min(len(tm), np.searchsorted(tm, t[-1]))
        there = [np.interp(tm[:n], t, states[:, i]) for i in range(3)]
        apart = np.abs(np.transpose(there) - mapped[:n]).max(axis=0)
        print(f"start {number} {start}: largest difference of map and run to"
              f" t = {tm[n - 1]:.1f}: a {apart[0]:.4f}, yp {apart[1]:.4f},"
              f" theta {apart[2]:.3f}")
    for ax, name in zip(axes, ("half distance a [m]", "height of the middle [m]",
                               "angle with the tube [rad]")):
        ax.set(xlabel="time [s]", ylabel=name)
    axes[0].plot([], [], "k--", linewidth=1, label="by the map")
    axes[0].legend()
    gp.save(figure, here/"plots/trajectories.png")


def main():
    maps = pairMap.read()
    known = np.isfinite(maps[0, ..., 0])
    still = np.nanmax(np.abs(maps[0, :, 13, :, ::2]))
    print(f"largest rates of a and theta of pairs in the middle: {still:.1e}")
    print(f"states: {maps[0, ..., 0].size}, of which the discs fit into"
          f" {known.sum()}")
    (start,) = [z for z in equilibrium.of_map(maps) if z.slope < 0]
    zero, at_rest, first = equilibrium.refined(start.x)
    print(f"pair across the tube at rest: a = {zero.x:.4f}, slope"
          f" {zero.slope:.3e} Re, {zero.stability} in a")
    print(f"rate of yp by theta {at_rest[1, 2]:.4f}, of theta by yp"
          f" {at_rest[2, 1]:.4f} at Re = 0")
    print(f"eigenvalues of (a, yp, theta) at Re = {RE}:",
          *(f"{value:.4g}" for value in np.linalg.eigvals(at_rest + RE*first)))
    along(maps)
    across(maps, zero)
    trajectories(maps)


main()
