# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact of bodies that each rank has its own of: the same on any number of
ranks."""

import re

import numpy as np
import pytest

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform
from contactCase import box2d, discs
from spreadCrowd import (
    FILMS, PROJECTIONS, WIDTH, check_ranks, crowd, state_of,
)
from spreadRuns import motions, write_twice


@pytest.mark.parametrize("model", [
    pytest.param("inelastic", marks=pytest.mark.nightly), "viscous",
])
def test_projection(model, tmp_path):
    """Contact of all at once, of bodies of several ranks as well."""
    one, several = check_ranks(
        crowd(tmp_path, (1, 1), contact=PROJECTIONS[model]), tmp_path
    )
    force, as_much = (
        np.abs(case.columns("forces")["contactForce_x"])
        for case in (one, several)
    )
    assert (force[-200:] > 0).sum() > 20
    assert as_much == pytest.approx(force, abs=1e-6*force.max())


def heap(folder, contact):
    """Discs in three layers, which fall onto each other and the floor of a long
    box with a light fluid."""
    half, radius = 16, 0.245
    case = box2d(folder, 20)
    boxMesh.write(
        case, uniform(-half, half, 20*half), uniform(-1, 1, 20), None,
        {"walls": "x- x+ y- y+"},
    )
    case.run("blockMesh")
    case.gravity(y=-10)
    places = [
        (i/2 + 0.25*(1 + layer % 2) - half, -0.74 + 0.47*layer)
        for layer in range(3) for i in range(4*half - 1)
    ]
    case.bodies(
        discs(places, radius, ratio=1000), f"contact {{ type {contact} }}"
    )
    write_twice(case, 0.005, 40)
    return case


def test_films(tmp_path):
    """Of fluid in the gaps, one after the other from rank to rank, also where
    bodies touch walls."""
    one, several = check_ranks(
        crowd(tmp_path, (1, 1), FILMS, walls=True), tmp_path, number=240
    )
    losses, as_much = (
        float(re.search(
            "contactLosses .*", state_of(case, part)
        )[0].rstrip(");").split()[-1])
        for case, part in ((one, "."), (several, "processor0"))
    )
    assert losses > 0 and as_much == pytest.approx(losses, rel=1e-6)


@pytest.mark.parametrize("model", [
    "inelastic", pytest.param("viscous", marks=pytest.mark.nightly),
])
def test_projected_heap(model, tmp_path):
    """As many contacts at once, found by each rank for its own discs, move them
    as they do where all ranks have all, in the same flow."""
    spread = heap(tmp_path, PROJECTIONS[model])
    together = BodyCase(spread, tmp_path, "together")
    together.replace(
        "constant/immersedBodyProperties", "contact {",
        "coupling { spread no; } contact {",
    )
    log, _ = (case.solve(4, (4, 1, 1)) for case in (spread, together))
    assert "Bodies are spread over the ranks: 189" in log
    assert "complementarity" not in log

    one, several = (motions(case)[:, -189:] for case in (together, spread))
    force = np.abs(spread.columns("forces")["contactForce_y"][-189:])
    assert (force > 0).mean() > 0.9
    largest = np.maximum(np.abs(one).max(axis=1, keepdims=True), 1e-6)
    assert np.max(np.abs(several - one)/largest) < 1e-6


@pytest.mark.nightly
def test_walls(tmp_path):
    """Rough ones; a rank finds those beside its bodies, among them walls of
    other ranks, and knows how often a body has met them. A plane of symmetry,
    on which bodies are that are in no cell."""
    one, several = check_ranks(
        crowd(tmp_path, (1, 1), walls=True), tmp_path, number=240
    )
    y, v = (
        one.columns("motion")[name].reshape(2, -1)
        for name in ("position_y", "velocity_y")
    )
    assert ((y[-1] > WIDTH - 1) & (v[-1] < -0.05)).sum() > 10
    impacts, as_many = (
        re.findall("wallImpacts +([0-9]+);", state_of(case, part))
        for case, part in ((one, "."), (several, "processor0"))
    )
    assert len(impacts) >= 10 and as_many == impacts
