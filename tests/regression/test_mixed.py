# SPDX-License-Identifier: GPL-3.0-or-later
"""Unresolved grains beside a body that the mesh resolves: in the iterations that
it needs near itself the fluid leaves the grains as they are, but not contact."""

import numpy as np
import pytest

from bodyCase import BodyCase
from unresolvedBox import entries, grain_box, momentum, velocities

# Density ratio, radius, position, velocity: one that is resolved, one that hits
# it, and two that hit each other
BODIES = (
    (2, 0.2, (0.5, 0.5, 0.5), (1, 0, 0)),
    (10, 0.03, (0.8, 0.5, 0.5), (-2, 0, 0)),
    (1, 0.03, (0.95, 0.95, 0.95), (-2, 0, 0)),
    (3, 0.03, (1.015, 0.96, 0.95), (-2, 0, 0)),
)


@pytest.fixture(scope="module")
def box(tmp_path_factory):
    case = grain_box(tmp_path_factory.mktemp("mixed"), nu=0.05)
    case.bodies(
        entries(BODIES).replace("grain0 {", "grain0 { coupling resolved;"),
        "coupling { type unresolved; tolerance 1e-6; nOuterCorrectors 5; }"
        "contact { type softSphere; restitution 0.8; }",
    )
    case.controls(endTime=0.2, deltaT=0.01)
    two = BodyCase(case, case.path.parent, "two")
    return case, case.solve(), two


def test_grains_wait_while_bands_are_solved(box):
    case, log, _ = box
    steps = log.split("\nTime = ")[3:]
    assert all("in the bands of bodies" in step for step in steps)
    assert all(step.count("Solving for Ux") == 2 for step in steps)


def test_momentum_is_conserved(box):
    """As far as five iterations have the impulses of contact converge, and
    bands the flow around the resolved body."""
    case, _, _ = box
    total = momentum(case, BODIES)
    change = [
        (ratio - 1)*4/3*np.pi*radius**3*np.ptp(velocities(case, i)[:, 0])
        for i, (ratio, radius, _, _) in enumerate(BODIES)
    ]
    assert min(change[0], change[1], change[3]) > 2e-4
    assert np.abs(total - total[0]).max() < 1.5e-5


def test_contact_is_that_of_the_grains(box):
    case, _, _ = box
    hit, other = velocities(case, 1), velocities(case, 0)
    # The ball is slowed down, and the grain turned back
    assert other[-1, 0] < 0.99
    assert hit[:, 0].max() > 0.98


def test_same_on_two_ranks(box):
    case, _, two = box
    two.solve(2, (2, 1, 1))
    for i in range(len(BODIES)):
        a, b = case.table("motion", i), two.table("motion", i)
        for column in a:
            assert b[column] == pytest.approx(a[column], abs=1e-5)
