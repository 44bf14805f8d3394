# SPDX-License-Identifier: GPL-3.0-or-later
"""Fluid and bodies are of second order in time, of first with Euler."""

import math

import pytest

from drivenBodies import changes, disc_case, ellipsoid_case, motion

TIGHT = "coupling { nOuterCorrectors 15; tolerance 1e-6; }"


def orders(folder, make, scheme, coarsest):
    """By quantity: the order from three time steps, each half the last."""
    found = []
    for steps in (coarsest, 2*coarsest, 4*coarsest):
        case, *_ = make(folder, f"{scheme}_{steps}", steps, TIGHT, scheme)
        case.solve()
        found.append(motion(case, steps//coarsest))
    return {
        quantity: math.log2(coarse/fine)
        for quantity, (coarse, fine) in changes(found).items()
    }


@pytest.mark.parametrize(
    "make, steps", [(disc_case, 20), (ellipsoid_case, 10)]
)
def test_backward_is_of_second_order(make, steps, tmp_path):
    found = orders(tmp_path, make, "backward", steps)
    assert all(1.8 < order < 2.3 for order in found.values()), found


def test_euler_is_of_first_order(tmp_path):
    # 0.92 to 1.05; with twice as many steps 0.96 to 1.03
    found = orders(tmp_path, disc_case, "Euler", 20)
    assert all(0.85 < order < 1.1 for order in found.values()), found
