# SPDX-License-Identifier: GPL-3.0-or-later
"""What all codes of the league are given: three scenes in numbers."""

import math
from typing import NamedTuple

import numpy as np

from settlingBox import random_centres

# Cells and steps of the crowds that are compared, over those asked for: the
# finest, ours, is what the others are compared with
FINENESS = (2, 1, 0.75, 0.5)
FEWEST = 4                  # cells per diameter

# Of a crowd, over D: gap between spheres at the start, and that to the two
# sides of the box which no sphere may cross
GAP, CLEAR = 0.05, 0.25


class Settling(NamedTuple):
    """A sphere that settles in a closed box [SI]: name E1 to E4, densities of
    fluid and sphere, viscosity, largest velocity measured, end time; cells
    per diameter; lengths; gravity."""

    name: str
    rho: float
    rho_s: float
    mu: float
    fastest: float
    end: float
    cells: int
    diameter: float
    gap: float
    width: float
    height: float
    gravity: float


class Crowd(NamedTuple):
    """Spheres of diameter and velocity scale 1 in a periodic cube without net
    volume flux, from rest, gravity along x. centres: (n, 3); box: cells a
    side; cells: per diameter."""

    centres: np.ndarray
    box: int
    cells: int
    steps: int
    dt: float
    nu: float
    gravity: float
    ratio: float

    @property
    def side(self):
        return self.box/self.cells

    @property
    def name(self):
        number = len(self.centres)
        fraction = number*math.pi/6/self.side**3
        spheres = "sphere" if number == 1 else "spheres"
        return f"{number} {spheres}, {self.box}^3, fraction {fraction:.3f}"


class Fluid(NamedTuple):
    """Vortices in a closed cube of n cells of size 1 a side, speed 1."""

    n: int
    steps: int
    dt: float = 0.5
    nu: float = 0.2


def settling(module, name, cells):
    """A case of the benchmark tenCate, which is the module."""
    return Settling(
        name, *module.CASES[name], cells, module.DIAMETER, module.GAP,
        module.WIDTH, module.HEIGHT, module.GRAVITY,
    )


def fineness(box, cells, steps):
    """Those of FINENESS that leave whole numbers."""
    return [
        part for part in FINENESS
        if part*cells >= FEWEST
        and not any(part*n % 1 for n in (box, cells, steps))
    ]


def crowd(module, number, box, cells, steps, refined=1):
    """One of the benchmark crowd, which is the module, but clear of two sides:
    CP3d has no images of spheres across them. refined: the same spheres and
    time on cells of 1/refined."""
    side = box/cells
    centres = random_centres(number, side, GAP, 1, clear=0.5 + CLEAR)
    box, cells, steps = (round(n*refined) for n in (box, cells, steps))
    return Crowd(
        centres, box, cells, steps, module.COURANT/(0.5*cells),
        1/module.GALILEI, 1/(module.RATIO - 1), module.RATIO,
    )
