# SPDX-License-Identifier: GPL-3.0-or-later
"""place.py NUMBER: centres of grains at random for draws 1 to NUMBER, in
draws/<draw>/grainPositions; a draw is the same in any number of them."""

import pathlib
import sys

import numpy as np

here = pathlib.Path(__file__).resolve().parent

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


for draw in range(1, int(sys.argv[1]) + 1):
    folder = here/f"draws/{draw}"
    folder.mkdir(parents=True, exist_ok=True)
    lines = [f"({x:.6f} {y:.6f} 0)" for x, y in
             place(np.random.default_rng(draw))]
    text = "\n    ".join(lines)
    (folder/"grainPositions").write_text(f"{GRAINS}\n(\n    {text}\n)\n")
