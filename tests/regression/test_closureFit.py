# SPDX-License-Identifier: GPL-3.0-or-later
"""The function object closureFit: drag and added mass of an array of spheres in
an oscillating flow, against theory and between frames of reference."""

import sys
from pathlib import Path

import numpy as np
import pytest

from foamCase import tables

sys.path.insert(0, str(Path(__file__).parents[1]/"benchmarks"))

import potentialFlow
from measure import driving_force
from oscillatingArray import NU, Array, fitted

ARRAY = Array(0.2, 8, 0.1)
COEFFICIENTS = ("drag", "addedMass", "errorOf_drag", "errorOf_addedMass")


def run(folder, moves, steps, entries=""):
    case = ARRAY.case(folder, moves, steps, entries)
    case.solve()
    return case


def test_conductivity_around_insulators():
    """Against the series of Sangani & Acrivos (1983) and, dilute, Maxwell and a
    single sphere."""
    for fraction in (0.05, 0.1, 0.2):
        s, _ = potentialFlow.solve(fraction)
        assert s == pytest.approx(
            potentialFlow.sangani_acrivos(fraction), rel=2e-7)

    fraction = 1e-3
    s, length = potentialFlow.solve(fraction)
    radius = (3*fraction/(4*np.pi))**(1/3)
    eps = 1 - fraction
    assert s == pytest.approx(eps/(1 + 0.5*fraction), rel=1e-8)
    assert length == pytest.approx(1/(3*np.pi*radius**2), rel=3e-3)


@pytest.fixture(scope="module")
def fluid(tmp_path_factory):
    """Fluid that oscillates, in 80 and 160 steps per period: the force on
    spheres at rest is of first order in time."""
    return [run(tmp_path_factory.mktemp("fluid"), "fluid", steps)
            for steps in (80, 160)]


def test_it_does_not_matter_which_phase_is_accelerated(fluid, tmp_path):
    coarse, fine = (fitted(case) for case in fluid)
    spheres = fitted(run(tmp_path, "spheres", 80))
    for name in ("drag", "addedMass"):
        limit = 2*fine[name] - coarse[name]
        assert spheres[name] == pytest.approx(limit, rel=0.02), name

    # Eight cells per diameter; at 32 the theory of thin layers is 6 % too high
    _, _, mass = ARRAY.potential()
    for row, samples in ((coarse, 81), (fine, 161), (spheres, 81)):
        assert 0.85*mass < row["addedMass"] < 0.96*mass
        assert row["unexplained"] < 1e-4
        assert row["samples"] == samples
        assert 0 < row["errorOf_addedMass"] < 0.005*row["addedMass"]
        assert row["bodyFraction"] == pytest.approx(0.2, rel=1e-9)


def test_interaction_is_what_the_pressure_gradient_leaves(fluid):
    """M = eps (G - d<U>_f/dt), G being what drives the flow, to first order in
    time."""
    errors = []
    for case, steps in zip(fluid, (80, 160)):
        table = tables.run_columns(case.path, "closure", "closureFit")
        # As the spheres are at rest
        A = table["slipAcceleration_x"][-steps:]
        M = table["interaction_x"][-steps:]
        G = driving_force(case)[-steps:]
        errors.append(np.abs(M - 0.8*(G - A)).max()/np.abs(M).max())
    assert errors[1] < 0.07
    assert errors[0]/errors[1] == pytest.approx(2, abs=0.3)


def test_restart(tmp_path):
    once = ARRAY.case(tmp_path/"once", "spheres", 20)
    # The sums of fastPoisson may differ in the last bit from run to run
    once.replace("system/fvSolution", "fastPoisson", "PCG; preconditioner DIC")
    parts = once.copy(tmp_path, "parts")
    once.solve()
    for periods in (2.35, 3):
        end = round(20*periods)*ARRAY.period/20
        parts.controls(endTime=f"{end:.15g}", writeControl="timeStep",
                       writeInterval=1000, stopAt="endTime")
        parts.replace("system/controlDict", "writeInterval   1000",
                      f"writeInterval   {47 if periods < 3 else 13}")
        parts.solve()
    rows = [fitted(case) for case in (once, parts)]
    for name in COEFFICIENTS:
        assert rows[0][name] == rows[1][name], name
    assert rows[0]["samples"] == 21


def test_ranks(tmp_path):
    rows = []
    for ranks, n in ((1, None), (2, None), (4, (2, 2, 1))):
        case = ARRAY.case(tmp_path/str(ranks), "fluid", 20)
        case.replace("system/controlDict", "start           ", "start 0; //")
        case.controls(endTime=f"{0.5*ARRAY.period:.15g}")
        for old, new in (("1e-9;", "1e-13;"), ("1e-3;", "0;")):
            case.replace("system/fvSolution", old, new)
        case.solve(ranks, n)
        rows.append(fitted(case))
    for row in rows[1:]:
        for name in ("drag", "addedMass", "unexplained"):
            assert row[name] == pytest.approx(rows[0][name], rel=1e-8), name


def test_layers(tmp_path):
    """Of a layer without bodies there are no samples, and the fractions of all
    make up that of the box."""
    case = run(tmp_path, "spheres", 20, "layers 11; flow (2 0 0);")
    rows = [fitted(case, layer) for layer in range(12)]
    fractions = [row["bodyFraction"] for row in rows[1:]]

    assert np.mean(fractions) == pytest.approx(0.2, rel=1e-9)
    assert rows[1]["position"] == pytest.approx(0.5/11)
    assert rows[6]["samples"] == 0 and np.isnan(rows[6]["addedMass"])
    assert fractions[5] == 0
    for row in rows[:4]:
        assert row["samples"] == 21
        assert row["addedMass"] > 0 and row["drag"] > 0
        assert row["slip_y"] == 0
    assert NU*20 < rows[0]["drag"] < NU*60
