# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes constant/places: spheres that have come to rest at the bottom, at
random, without flow. Unit: the diameter."""

import pathlib

import numpy as np

# Solid fraction 0.6 of a bed of this height; periodic along x and z
LENGTH, WIDTH, HEIGHT, FRACTION = 8, 3, 3.5, 0.6
NUMBER = round(FRACTION*LENGTH*WIDTH*HEIGHT/(np.pi/6))
# Steps of the way down, largest step, and number of steps
WEIGHT, LARGEST, STEPS = 1e-3, 0.05, 20000
# Gap that is left
GAP = 1e-3


def push(x):
    """Repulsion of those that overlap, each and the bottom."""
    d = x[:, None] - x
    d[..., 0] -= LENGTH*np.round(d[..., 0]/LENGTH)
    d[..., 2] -= WIDTH*np.round(d[..., 2]/WIDTH)
    distance = np.linalg.norm(d, axis=2) + 2*np.eye(len(x))
    overlap = np.maximum(1 + GAP - distance, 0)
    force = (d*(overlap/distance)[..., None]).sum(axis=1)
    force[:, 1] += np.maximum(0.5 + GAP - x[:, 1], 0)
    return force, overlap.max()


def settle():
    """Centres, sliding down without friction; weights fade in the end."""
    random = np.random.default_rng(1)
    x = random.uniform((0, 0.5, 0), (LENGTH, 2*HEIGHT, WIDTH), (NUMBER, 3))
    for step in range(STEPS):
        force, overlap = push(x)
        force[:, 1] -= WEIGHT*max(1 - 1.25*step/STEPS, 0)
        x += 0.4*np.clip(force, -LARGEST, LARGEST)
    x[:, 0] %= LENGTH
    x[:, 2] %= WIDTH
    return x, overlap


x, overlap = settle()
rows = "\n".join("({:.6f} {:.6f} {:.6f})".format(*place) for place in x)
file = pathlib.Path(__file__).resolve().parent/"constant/places"
file.write_text(f"(\n{rows}\n)\n")
print(f"{NUMBER} spheres, highest centre {x[:, 1].max():.3f}, largest overlap"
      f" {max(overlap - GAP, 0):.1g}")
