# SPDX-License-Identifier: GPL-3.0-or-later
"""A part of the map of pairs of discs in a tube: pairs at rest, stability."""

import importlib.util
import math
from pathlib import Path

import numpy as np

from grainfoam.study import analysis
from measure import Result
from stokesCase import DRIVE, periodic_stokes_tube, solve
from stokesModes.benchmark import CELLS, MIRRORS, places, times

# Half distance of the pair across the tube at rest, by finite elements
REST = 0.541
ACROSS = math.pi/2
# Half distances of the scan across the tube, about its zeros
SCAN = np.linspace(0.3, 0.72, 8)
# Steps of half distance, height, angle for derivatives
STEPS = np.diag((0.02, 0.02, 0.04))


def tutorial():
    """The module of the tutorial maps/pair, which has the rates."""
    file = Path(__file__).parents[3]/"tutorials/maps/pair/pairMap.py"
    spec = importlib.util.spec_from_file_location("tutorialPairs", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def compute(folder, name, cells, states):
    """Rates (of a, yp, theta) at the states, at Re = 0 and to first order;
    seconds of the run, images of other states."""
    case = periodic_stokes_tube(folder, name, CELLS[cells], places(*states[0]))
    columns = solve(
        case, [places(*s) for s in states], drive=DRIVE, mirrors=MIRRORS,
    )
    log = (case.path/"log.stokesModes").read_text()
    images = log.count(": mirror image of")
    return np.array(tutorial().rates(columns, states)), sum(times(case)), images


def at_rest(folder, cells):
    """The pair at rest across the tube, and how its neighbours move."""
    states = [(a, 0, ACROSS) for a in SCAN]
    found, first_cpu, _ = compute(folder, f"scan_{cells}", cells, states)
    (zero,) = [z for z in analysis.zeros(SCAN, found[1, :, 0]) if z.slope < 0]
    middle = np.array((zero.x, 0, ACROSS))
    near = [tuple(middle + sign*step) for step in STEPS for sign in (1, -1)]
    found, cpu, _ = compute(folder, f"near_{cells}", cells, near)
    zeroth, first = (
        np.stack([(r[2*i] - r[2*i + 1])/(2*STEPS[i, i]) for i in range(3)], 1)
        for r in found
    )
    result = Result(
        "across the tube", cells, 3*CELLS[cells]**2, cpu=first_cpu + cpu,
    )
    yield result.row("a at rest", zero.x, REST)
    yield result.row("slope of the rate of a", first[0, 0])
    # yp and theta grow together at Re = 0 already
    growth = np.linalg.eigvals(zeroth).real.max()
    yield result.row("growth rate at Re 0", growth)
    yield result.row("rate of yp by theta", zeroth[1, 2])
    yield result.row("rate of theta by yp", zeroth[2, 1])


def part(folder, n):
    """n^3 pairs, yp and theta either side of zero: what images give, and what
    is zero at Re = 0."""
    states = [
        (a, yp, angle)
        for a in np.linspace(0.1, 0.6, n)
        for yp in 0.6*np.linspace(-1, 1, n)
        for angle in ACROSS*np.linspace(-1, 1, n)
    ]
    found, cpu, images = compute(folder, f"part_{n}", 8, states)
    good = np.isfinite(found[0, :, 0])
    result = Result(f"map of {n}^3 pairs", 8, 3*CELLS[8]**2, cpu=cpu)
    yield result.row("states with flows", good.sum())
    yield result.row("images of others", images)
    yield result.row("seconds per state with flow", cpu/good.sum())
    middle = good & (np.array(states)[:, 1] == 0)
    # A pair about the middle turned by half a turn is itself, and the flow
    # turned round: its half distance stays at Re = 0
    yield result.row(
        "largest rate of a at yp 0, Re 0", np.abs(found[0, middle, 0]).max(),
    )


def rows(folder, quick):
    for cells in (8,) if quick else (8, 16):
        yield from at_rest(folder, cells)
    yield from part(folder, 3 if quick else 9)
