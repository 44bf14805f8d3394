# SPDX-License-Identifier: GPL-3.0-or-later
"""Resistance, free motion and first order of inertia of discs in a tube."""

import math
import re

import numpy as np

from boxMesh import around, graded
from measure import Result, set_viscosity
from roughWalls.benchmark import REFERENCES as ROUGH
from stokesCase import (
    DRIVE, RADIUS, periodic_stokes_tube, solve, stokes_tube,
)

MIRRORS = "((0 1 0) (1 0 0))"

CELLS = {8: 123, 16: 246}       # across the tube, by D/h
HEIGHT = -0.3

# Re = 0; the first order by parabolas of Re through lateral velocities at Re 2
# and 10, -3.191569e-4 and -1.337800e-3
ONE = {
    "A_x0_x0": 6.626786, "A_y0_y0": 6.357214, "A_rz0_rz0": 0.0533790,
    "A_x0_rz0": -0.0094848, "V_x0": 1.361306, "V_rz0": -0.448684,
    "V1_y0": -1.6066e-4,
}

# a, yp, angle: of both discs
PAIRS = {
    (0.3, 0, math.pi/4): {
        "V_x0": 1.426699303, "V_y0": -1.936253282e-3,
        "V_rz0": -3.177311769e-1, "V1_y0": -1.684288545e-4,
        "V1_rz0": 1.682581722e-4, "C_x0": -1.895140653e-4,
        "C_y0": -1.143441144e-3, "C_rz0": 5.985904674e-6,
    },
    (0.2, -0.64, 0.5): {
        "V_x0": 6.819567082e-1, "V_rz0": -1.058935066,
        "V_x1": 1.031813449, "V_y1": -2.977180160e-3,
        "V_rz1": -7.888956142e-1, "V1_y0": 2.590978619e-4,
        "V1_y1": 3.497383762e-4, "C_y0": 3.216819596e-3,
        "C_y1": 2.891492489e-3,
    },
}


def places(a, yp, angle):
    """Centres of a pair."""
    dx, dy = a*math.cos(angle), a*math.sin(angle)
    return [(-dx, yp - dy), (dx, yp + dy)]


def times(case):
    """Seconds that each state took."""
    log = (case.path/"log.stokesModes").read_text()
    return [float(t) for t in re.findall(r"took (\S+) s", log)]


def compare(columns, references, result, row=0):
    for name, reference in references.items():
        yield result.row(name, columns[name][row], reference)
    n = sum(name.startswith("V_") for name in columns)
    A = [columns[name][row] for name in columns if name.startswith("A_")]
    yield result.row(
        "asymmetry over largest", columns["asymmetry"][row]/np.abs(A).max()
    )
    assert len(A) == n*n


def direct(folder, cells):
    """One disc and the pairs in periodic tubes."""
    n = CELLS[cells]
    states = {"one": [[(0, HEIGHT)]], "pair": [places(*p) for p in PAIRS]}
    for name, some in states.items():
        case = periodic_stokes_tube(folder, f"{name}_{cells}", n, some[0])
        columns = solve(case, some, drive=DRIVE)
        references = [ONE] if name == "one" else list(PAIRS.values())
        for i, seconds in enumerate(times(case)):
            settings = f"{name} {i + 1}, direct"
            result = Result(settings, cells, 3*n*n, cpu=seconds)
            yield from compare(columns, references[i], result, i)


def iterative(folder, cells):
    """The same disc and pair between ends with the undisturbed profile."""
    h = 2*RADIUS/cells
    core = 6.4*RADIUS
    some = {
        "one": ([(0, HEIGHT)], around(HEIGHT, core, h), around(0, core, h)),
        "pair": (places(0.3, 0, math.pi/4),) + 2*(around(0, core + 0.2, h),),
    }
    for name, (centres, y, x) in some.items():
        case = stokes_tube(
            folder, f"{name}_ends_{cells}", graded(-3, 3, x, h, 1.04),
            graded(-1, 1, y, h, 1.04), centres,
        )
        columns = solve(case)
        log = case.run("checkMesh")
        n = int(re.search(r"cells: +(\d+)", log)[1])
        result = Result(f"{name} 1, iterative", cells, n, cpu=times(case)[0])
        references = ONE if name == "one" else next(iter(PAIRS.values()))
        yield from compare(columns, references, result)


def rough(folder, cells):
    """Robin walls: speed, spin, and lateral velocity to first order."""
    for a in (1, 100):
        speed, spin, lift = ROUGH[a, HEIGHT]
        case = periodic_stokes_tube(
            folder, f"rough{a}_{cells}", CELLS[cells], [(0, HEIGHT)],
        )
        case.controls(libs="(grainFvPatchFields)")
        case.replace("0/U", "noSlip", f"robinVelocity; a {a}")
        set_viscosity(case, 0.5)
        columns = solve(case, drive=DRIVE)
        n = CELLS[cells]
        result = Result(f"rough {a}, direct", cells, 3*n*n, cpu=times(case)[0])
        yield result.row("V_x0", columns["V_x0"][0], speed)
        yield result.row("V_rz0", columns["V_rz0"][0], spin)
        # At Re = 2; lift in viscous units
        value = 2*columns["V1_y0"][0]*columns["A_y0_y0"][0]
        yield result.row("lift by V1", value, lift)


def pair_map(folder, n):
    """A map of n^3 pairs; time of a state."""
    grid = [
        (a, yp, angle)
        for a in np.linspace(0.1, 0.6, n)
        for yp in 0.8*np.linspace(-1, 1, n)
        for angle in np.pi*np.arange(n)/n
    ]
    states = [places(*p) for p in grid]
    case = periodic_stokes_tube(folder, "map", CELLS[8], states[n*n*n//2])
    columns = solve(case, states, drive=DRIVE, mirrors=MIRRORS)
    good = np.isfinite(columns["V_x0"])
    seconds = times(case)
    log = (case.path/"log.stokesModes").read_text()
    result = Result(
        f"map of {n}^3 pairs, direct", 8, 3*CELLS[8]**2, cpu=sum(seconds)
    )
    yield result.row("states with flows", good.sum())
    yield result.row("images of others", log.count(": mirror image of"))
    yield result.row("seconds per state with flow", sum(seconds)/good.sum())
    yield result.row("least eigenvalue", columns["leastEigenvalue"][good].min())
    largest = columns["asymmetry"][good]/columns["A_y0_y0"][good]
    yield result.row("largest asymmetry over A_y0_y0", largest.max())


def rows(folder, quick):
    for cells in (8,) if quick else (8, 16):
        yield from direct(folder, cells)
    yield from iterative(folder, 8)
    for cells in (8,) if quick else (8, 16):
        yield from rough(folder, cells)
    yield from pair_map(folder, 3 if quick else 9)
