# SPDX-License-Identifier: GPL-3.0-or-later
"""The map of a pair of discs: half distance a, height yp of its middle, and
angle theta with the tube, from the slices that have been computed.

Discs are at (0, yp) -+ a (cos(theta), sin(theta)). Only yp >= 0 and theta >= 0 are
computed. Mirrored at y = 0, which is (yp, theta) -> (-yp, -theta), the rates of
yp and theta change their signs. Mirrored along the tube, theta -> -theta, and with
the flow turned round: those of a and yp at Re = 0, which are linear in the
flow, that of theta to first order in Re."""

import pathlib

import numpy as np

from grainfoam import tables  # source etc/bashrc of grainFoam

here = pathlib.Path(__file__).resolve().parent

RADIUS = 0.065
A = np.linspace(0.07, 0.93, 27)
YP = np.linspace(-0.93, 0.93, 27)
THETA = np.linspace(-0.5*np.pi, 0.5*np.pi, 27)

# States (a, yp, theta) at the start of the runs in time
STARTS = ((0.25, 0.1, 1.2), (0.3, -0.3, 0.6))


def places(a, yp, theta):
    """Centres of the two, (x, y) each."""
    along = a*np.cos(theta), a*np.sin(theta)
    return (-along[0], yp - along[1]), (along[0], yp + along[1])


def write_states(states, folder="."):
    """Write system/stokesModesDict for states (a, yp, theta)."""
    rows = "\n".join(
        "    (" + " ".join(f"({x:.12g} {y:.12g} 0)" for x, y in places(*state))
        + ")" for state in states)
    (pathlib.Path(folder)/"system/stokesModesDict").write_text(
        "FoamFile\n{\n    version     2.0;\n    format      ascii;\n"
        "    class       dictionary;\n    object      stokesModesDict;\n}\n\n"
        f"states\n(\n{rows}\n);\n\n"
        "drive { direction (1 0 0); meanVelocity 1; }\n")


def rates(columns, states):
    """Rates of a, yp and theta: at Re = 0, and to first order in Re. Two arrays
    (number of states, 3); nan where the discs overlap each other or a wall."""
    a, _, theta = np.array(states).T
    found = []
    for name in "V", "V1":
        u, v = (
            (columns[f"{name}_{axis}1"] - columns[f"{name}_{axis}0"])/2
            for axis in "xy")
        middle = (columns[f"{name}_y0"] + columns[f"{name}_y1"])/2
        found.append(np.stack([
            u*np.cos(theta) + v*np.sin(theta), middle,
            (v*np.cos(theta) - u*np.sin(theta))/a], axis=1))
    return found


def fits(a, yp, theta):
    """Are the two apart from each other and from the walls?"""
    return a > RADIUS and abs(yp) + abs(a*np.sin(theta)) < 1 - RADIUS


def slice_states(yp):
    """Indices (of a, of theta) and states of a slice that are computed."""
    found = [((i, j), (a, yp, theta)) for i, a in enumerate(A)
             for j, theta in enumerate(THETA[13:]) if fits(a, yp, theta)]
    return tuple(zip(*found)) if found else ((), ())


def read():
    """Rates at Re = 0 and to first order in all states: two arrays
    (a, yp, theta, 3), nan where the discs do not fit."""
    maps = np.full((2, len(A), len(YP), len(THETA), 3), np.nan)
    for i in range(14):
        yp = YP[13 + i]
        (folder,) = [f for f in here.glob("states/yp*")
                     if abs(float(f.name[2:]) - yp) < 1e-4]
        places, states = slice_states(yp)
        if not states:
            continue
        both = rates(tables.run_columns(folder, "stokesModes"), states)
        ai, ti = np.array(places).T
        for mirror_y in 1, -1:
            for mirror_x in 1, -1:
                sign = np.ones((2, 3))
                if mirror_y < 0:
                    sign[:, 1:] *= -1
                if mirror_x < 0:
                    sign[0, :2] *= -1
                    sign[1, 2] *= -1
                for order in 0, 1:
                    maps[order, ai, 13 + mirror_y*i,
                         13 + mirror_y*mirror_x*ti] = both[order]*sign[order]
    return maps
