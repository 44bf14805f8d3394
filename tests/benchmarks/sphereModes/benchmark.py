# SPDX-License-Identifier: GPL-3.0-or-later
"""Stokes modes of a sphere in a round tube, and the radius that it goes to."""

import math

import numpy as np

from grainfoam.study import analysis
from measure import Result, number_of_cells, set_viscosity
from segreSilberberg.benchmark import RADIUS, tube
from stokesCase import solve
from stokesModes.benchmark import times

# On the axis it takes 6 pi mu a K1 U to move a sphere of RADIUS, and
# 6 pi mu a K2 U_max to hold it
K1, K2 = 1.4465722, 1.424892
# Speed on the axis, of mean speed 1
FASTEST = 2
# Distances from the axis at which lateral velocities are found
PLACES = (0.5, 0.57, 0.64)


def make(folder, cells):
    """The sphere in the tube."""
    case = tube(folder, f"D{cells}", 2*RADIUS/cells)
    set_viscosity(case, 1)
    case.bodies(
        f"sphere {{ shape {{ type sphere; radius {RADIUS}; }}"
        " position (0 0 0); }"
    )
    return case


def rows(folder, quick):
    for cells in (6,) if quick else (6, 8):
        case = make(folder, cells)
        columns = solve(
            case, [[(0, y)] for y in (0, *PLACES)], tolerance="1e-5",
        )
        seconds = times(case)

        def result(settings, cpu):
            return Result(settings, cells, number_of_cells(case), cpu=cpu)

        axis = result("on the axis", seconds[0])
        stokes = 6*math.pi*RADIUS
        for name in ("A_x0_x0", "A_y0_y0"):
            known = stokes*K1 if name == "A_x0_x0" else None
            yield axis.row(name, columns[name][0], known)
        yield axis.row("B_x0", columns["B_x0"][0], stokes*K2*FASTEST)
        yield axis.row("V_x0", columns["V_x0"][0], FASTEST*K2/K1)

        for i, y in enumerate(PLACES, start=1):
            place = result(f"r/R {y:g}", seconds[i])
            for name in ("V_x0", "V_rz0", "V1_y0"):
                yield place.row(name, columns[name][i])
            yield place.row("V_y0 over V1_y0",
                            columns["V_y0"][i]/columns["V1_y0"][i])
        largest = np.abs(columns["A_x0_x0"])
        yield axis.row("asymmetry over A_x0_x0",
                       (columns["asymmetry"]/largest).max())

        (zero,) = analysis.zeros(PLACES, columns["V1_y0"][1:])
        end = result("Re to 0", sum(seconds[1:]))
        yield end.row("r/R without lift", zero.x)
        yield end.row("slope of V1_y0", zero.slope)
