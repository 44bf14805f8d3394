# SPDX-License-Identifier: GPL-3.0-or-later
"""So many grains that ranks share their contacts and the forces of the fluid on
them: the same on any number of ranks, and after a restart in the middle of
impacts."""

import re

import numpy as np
import pytest

from bodyCase import BodyCase
from denseBox import column, grains, write_positions
from spreadRuns import motions

DIAMETER, CELL, WIDTH, LAYERS = 1e-3, 2e-3, 6, 18
ACROSS = 11
COUPLING = {
    "dense": "voidFraction yes; dragModel { type Gidaspow; }",
    "loads": "lift { type SaffmanMei; }",
}


def falling_bed(folder, name="bed", coupling="dense"):
    """2178 grains, closely packed across a periodic column of air: the upper
    half falls onto the lower one."""
    case = column(folder, name, WIDTH, 16, CELL, 0.4, 1.5e-5)
    pitch = WIDTH*CELL/ACROSS
    i, k = (np.arange(ACROSS) + 0.5)*pitch, (np.arange(LAYERS) + 4)*pitch
    places = np.array([(x, y, z) for z in k for y in i for x in i])
    room = 0.45*(pitch - DIAMETER)
    places += np.random.default_rng(4).uniform(-room, room, places.shape)
    half = len(places)//2
    write_positions(case, places[:half])
    write_positions(case, places[half:], "upper")
    upper = grains(DIAMETER/2, 1000, "free", "upper").replace(
        "motion", "velocity (0.2 0.1 -0.7); motion"
    )
    case.bodies(
        grains(DIAMETER/2, 1200, "free") + upper,
        "contact { type softSphere; collisionTime 4e-4; friction 0.4; }"
        f" coupling {{ type unresolved; {COUPLING[coupling]} }}",
    )
    case.gravity(0, 0, -9.81)
    case.controls(
        deltaT=2e-4, endTime=2.4e-3, writeControl="timeStep",
        writeInterval=12, writeFormat="ascii", writePrecision=17,
        timePrecision=15,
    )
    return case


@pytest.mark.parametrize("coupling", COUPLING)
def test_same_on_several_ranks(coupling, tmp_path):
    one = falling_bed(tmp_path, coupling=coupling)
    several = {
        ranks: BodyCase(one, tmp_path, f"ranks{ranks}") for ranks in (2, 4)
    }
    one.solve()
    expected = motions(one)

    # Grains hit each other: they turn
    spins = one.columns("motion")["angularVelocity_x"].reshape(12, -1)
    assert (np.abs(spins[-1]) > 10).mean() > 0.1

    for ranks, parts in ((2, (1, 1, 2)), (4, (2, 2, 1))):
        several[ranks].solve(ranks, parts)
        scale = np.abs(expected).max(axis=1, keepdims=True)
        assert motions(several[ranks])/scale == pytest.approx(
            expected/scale, abs=1e-9
        )


@pytest.mark.parametrize("ranks, coupling", [
    (2, "dense"), pytest.param(4, "loads", marks=pytest.mark.nightly),
])
def test_restart_is_exact(ranks, coupling, tmp_path):
    at_once = falling_bed(tmp_path, coupling=coupling)
    at_once.controls(writeInterval=6)
    at_once.decompose(ranks)
    parts = BodyCase(at_once, tmp_path, "parts")
    at_once.solve(ranks)
    for end in (1.2e-3, 2.4e-3):
        parts.controls(endTime=end)
        parts.solve(ranks)

    for name in ("U", "p", "uniform/immersedBodies"):
        a, b = (
            (
                case.path/"processor0"/case.latest_time("processor0")/name
            ).read_bytes() for case in (at_once, parts)
        )
        assert a == b, name
    assert re.search(rb"springContacts\s+\(\s*\(", a)
