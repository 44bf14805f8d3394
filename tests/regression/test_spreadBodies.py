# SPDX-License-Identifier: GPL-3.0-or-later
"""So many bodies that each rank holds only those near to it, which the mesh
resolves: the same on any number of ranks, while they hit each other and go from
rank to rank."""

import re
import shutil

import numpy as np
import pytest

from bodyCase import BodyCase
from spreadCrowd import (
    FILMS, PROJECTIONS, SPRINGS, STEP, STEPS, WIDTH, WINDOW, check_ranks,
    crowd, sheared_crowd, state_of,
)
from spreadRuns import SURFACES, motions, run_in_parts, surfaces


@pytest.mark.parametrize("shares", [
    (12, 0, 1), pytest.param((1, 1), marks=pytest.mark.nightly), (1, 1, 0, 1),
])
def test_same_on_several_ranks(shares, tmp_path):
    """With some that are towed, and without: then later iterations are those of
    few. With some on springs: the master, which writes their anchors, has got
    most of them from other ranks."""
    runs = check_ranks(crowd(tmp_path, shares), tmp_path)
    state, as_good = map(state_of, runs, (".", "processor0"))
    assert "crowd " in state
    anchors = re.findall("startPosition .*", state)
    assert len(anchors) == (66 if len(shares) == 4 else 0)
    assert re.findall("startPosition .*", as_good) == anchors


def test_window(tmp_path):
    """It follows all of them."""
    runs = check_ranks(
        crowd(tmp_path, (1, 1), WINDOW), tmp_path, "windowPosition"
    )
    way, as_far = (
        case.columns("motion")["position_x"]
        - case.columns("motion")["windowPosition_x"] for case in runs
    )
    assert np.ptp(way[-200:]) < 1e-9 and abs(way[-1]) > 0.01
    assert as_far == pytest.approx(way, abs=1e-8)


def test_files(tmp_path):
    """State, tables and surfaces have all bodies in the order of their numbers,
    and the master alone writes them; it is told of some at a time."""
    case = crowd(tmp_path, (1, 1))
    case.replace("system/controlDict", "functions\n{", SURFACES)
    case.controls(endTime=STEP, writeInterval=1)
    one, several = (BodyCase(case, tmp_path, name) for name in ("one", "four"))
    one.solve(1)
    assert "Bodies are spread over the ranks" in several.solve(4, (4, 1, 1))

    table, same = (case.columns("motion") for case in (one, several))
    times = np.unique(table["time"])
    numbers = len(times)*list(range(200))
    assert list(same["body"]) == list(table["body"]) == numbers
    assert same["position_x"] == pytest.approx(table["position_x"], rel=1e-6)

    arrays, as_many = surfaces(one), surfaces(several)
    assert len(arrays) == len(as_many) == 10*(1 + len(times))
    for array, same in zip(arrays, as_many):
        assert same == pytest.approx(array, rel=1e-4, abs=1e-4)

    states = [state_of(several, f"processor{rank}") for rank in range(4)]
    assert [state.count("number ") for state in states] == [200, 0, 0, 0]
    names = re.findall(r"\n    (kind\S+)\n", state_of(one, "."))
    assert len(names) == 200
    assert re.findall(r"\n    (kind\S+)\n", states[0]) == names


def test_ambient(tmp_path):
    """They begin with the velocity of the flow at their centres."""
    case = sheared_crowd(tmp_path)
    case.replace(
        "constant/immersedBodyProperties", "velocity (1 0.3 0);",
        "velocity ambient;",
    )
    one, _ = check_ranks(case, tmp_path, parts=(2, 2))
    first = {name: one.columns("motion")[name][:100] for name in (
        "position_y", "velocity_x"
    )}
    flow = 0.1*(first["position_y"] - WIDTH/2)
    assert np.corrcoef(first["velocity_x"], flow)[0, 1] > 0.9


def test_sliding_sides(tmp_path):
    """Some pass the sides that slide."""
    one, _ = check_ranks(sheared_crowd(tmp_path), tmp_path, parts=(2, 2))
    y = one.columns("motion")["position_y"].reshape(2, -1)
    assert (np.abs(y[1] - y[0]) > WIDTH/2).any()


@pytest.mark.parametrize("ranks", [
    pytest.param(1, marks=pytest.mark.nightly), 2,
])
def test_goes_on_on_other_ranks(ranks, tmp_path):
    """What four ranks have written together is what one or two go on from."""
    case = crowd(tmp_path, (1, 1))
    half = BodyCase(case, tmp_path, "half")
    half.controls(endTime=STEP*STEPS/2)
    assert "Bodies are spread over the ranks" in half.solve(4, (4, 1, 1))
    half.run("reconstructPar")
    for folder in half.path.glob("processor*"):
        shutil.rmtree(folder)
    half.replace("system/decomposeParDict", "Subdomains 4", "Subdomains 2")
    half.replace("system/decomposeParDict", "(4 1 1)", "(2 1 1)")
    case.solve()
    motion = motions(case)[:, -200:]
    largest = np.maximum(np.abs(motion).max(axis=1, keepdims=True), 1e-6)
    other = BodyCase(half, tmp_path, "other")
    other.controls(endTime=STEP*STEPS)
    if ranks > 1:
        other.run("decomposePar", "-latestTime")
    other.solve(ranks)
    difference = motions(other)[:, -200:] - motion
    assert np.max(np.abs(difference)/largest) < 1e-6


def test_goes_on_together(tmp_path):
    """All ranks have all that a spread run has written, with its contacts."""
    case = crowd(tmp_path, (1, 1))
    parts = BodyCase(case, tmp_path, "parts")
    case.solve()
    parts.controls(endTime=STEP*STEPS/2)
    assert "Bodies are spread over the ranks" in parts.solve(4, (4, 1, 1))
    parts.controls(endTime=STEP*STEPS)
    parts.replace(
        "constant/immersedBodyProperties", "coupling {", "coupling { spread no;"
    )
    assert "Bodies are spread" not in parts.solve(4)
    motion = motions(case)[:, -200:]
    largest = np.maximum(np.abs(motion).max(axis=1, keepdims=True), 1e-6)
    difference = motions(parts)[:, -200:] - motion
    assert np.max(np.abs(difference)/largest) < 1e-6


@pytest.mark.parametrize("more, contact", [
    ("", SPRINGS),
    pytest.param("", PROJECTIONS["viscous"], marks=pytest.mark.nightly),
    pytest.param(FILMS, SPRINGS, marks=pytest.mark.nightly),
])
def test_restart_is_exact(more, contact, tmp_path):
    at_once = crowd(tmp_path, (12, 0, 1), more, contact=contact)
    parts = run_in_parts(at_once, tmp_path, STEP, STEPS, (4, 1, 1))

    # The sums of fastPoisson may differ in the last bit from run to run
    a, b = motions(at_once), motions(parts)
    assert a.shape == b.shape
    assert np.max(np.abs(a - b)) < 1e-10
