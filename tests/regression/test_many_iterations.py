# SPDX-License-Identifier: GPL-3.0-or-later
"""Time steps whose outer iterations would not end by themselves: bodies released
from rest, two with a film between them, one that falls on a wall."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))

from measure import Run  # noqa: E402
from report import Report  # noqa: E402

kissing = Report.load(Path(__file__).parents[1] / "benchmarks/kissing")
crowd = Report.load(Path(__file__).parents[1] / "benchmarks/crowd")
wetBounce = Report.load(Path(__file__).parents[1] / "benchmarks/wetBounce")
lightBodies = Report.load(
    Path(__file__).parents[1] / "benchmarks/lightBodies"
)


def all_converge(case, run):
    assert run.converged == run.steps
    assert "repeated with deltaT" not in (case.path/"log.foamRun").read_text()


@pytest.mark.parametrize("shape, ratio, most", [
    ("disc", 0.01, 9), ("disc", 0.5, 7), ("disc", 1.01, 6), ("disc", 2, 6),
    ("sphere", 0.01, 8), ("sphere", 0.5, 7), ("sphere", 1.01, 5),
])
def test_release(shape, ratio, most, tmp_path, monkeypatch):
    """Not within 30 iterations where they are not combined; 58 at ratio 2. Without
    added mass in the Newton step 22 at ratio 1.01. With that of a disc alone, and
    layers that respond by a tenth at least, 19 at ratio 0.5, 7 at 1.01 and 2. Where
    the pressure in the layers is not found ahead 26 at ratio 0.01, where it is
    found within a tenth only 15."""
    monkeypatch.setattr(kissing, "RELEASED", 3)
    case, run = kissing.release(tmp_path, shape, ratio)
    all_converge(case, run)
    assert run.steps == 3
    assert max(run.outers) <= most


def test_film(tmp_path):
    """A heavy disc meets the one before it. Each iteration by itself turns their
    relative velocity round: 45 steps had to be repeated, 20 did not converge."""
    case, run = kissing.pair(tmp_path, 1.01, 7.5)
    all_converge(case, run)

    one, other = (case.table("motion", body)["position_y"] for body in (0, 1))
    assert abs(one - other).min() < 1.01
    assert run.steps == 125

    # From rest 20 and 21 without added mass, 3.5 in the mean
    assert max(run.outers) <= 7
    assert sum(run.outers)/run.steps < 3


def test_impact(tmp_path):
    """A sphere that a wall stops at once, without a film: 22 and 10 iterations where
    they are to find a speed of zero to the tolerance of itself."""
    case, _ = wetBounce.make_case(
        tmp_path, "impact", 50, 8, contact="inelastic;", film="none;", ratio=2
    )
    run = Run(case, "impact", 8, 1)
    all_converge(case, run)

    # It has hit the wall, and stays there
    x = case.table("motion")["position_x"]
    assert 0.49 < x[-1] < 0.51
    assert max(run.outers) <= 8


def test_squeeze(tmp_path):
    """Two discs that are driven together: 38 iterations, 11 in the mean, where
    the pressure in the gap between their layers falls by a tenth in each."""
    case, run = kissing.pair(tmp_path, 1, 1.5)
    all_converge(case, run)
    assert max(run.outers) <= 30
    assert sum(run.outers)/run.steps < 8


def test_light_group_in_a_channel(tmp_path):
    """Five discs of a hundredth of the fluid's density that it sweeps along:
    with the added mass of one alone changes grow, and steps were repeated."""
    run = lightBodies.run_case(
        *lightBodies.prepare(tmp_path, 2), tmp_path, 2, 1000, 0.01, 0.5
    )
    assert not run.reason and run.repeats == 0
    assert run.converged == len(run.outers) == lightBodies.STEPS


def test_crowd_from_rest_and_in_contact(tmp_path):
    """Spheres that begin to settle, and touch: 25 and up to 20 iterations, ten in
    the mean, where the layers between them wait for the projection."""
    run, _, _ = crowd.solve(tmp_path, 18, 32, 8, 48)
    assert run.converged == run.steps
    assert max(run.outers) <= 10
    assert run.outers[0] <= 6
    assert sum(run.outers[24:])/24 < 4.5
