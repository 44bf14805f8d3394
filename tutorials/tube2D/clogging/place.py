# SPDX-License-Identifier: GPL-3.0-or-later
"""place.py DRAW: centres of grains at random for this draw, in
constant/grainPositions; a draw is the same in any number of them."""

import sys

import numpy as np

GRAINS, RADIUS = 20, 0.065

# Least distance from each other and to the walls, where they may be
GAP, HALF_LENGTH, HALF_WIDTH = 0.03, 3, 1


def place(random):
    """Centres, one after the other where there is room."""
    reach = np.array((HALF_LENGTH - RADIUS, HALF_WIDTH - RADIUS - GAP))
    centres = np.empty((0, 2))

    while len(centres) < GRAINS:
        centre = random.uniform(-reach, reach)
        distances = np.hypot(*(centres - centre).T)
        if np.all(distances >= 2*RADIUS + GAP):
            centres = np.vstack((centres, centre))

    return centres


lines = [f"({x:.6f} {y:.6f} 0)" for x, y in
         place(np.random.default_rng(int(sys.argv[1])))]
text = "\n    ".join(lines)
with open("constant/grainPositions", "w") as file:
    file.write(f"{GRAINS}\n(\n    {text}\n)\n")
