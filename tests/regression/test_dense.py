# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains whose volume is part of the equations of the fluid: volume, momentum,
pressure drop of beds, fluidisation, settling, limits, ranks, restart."""

import numpy as np
import pytest

from denseBox import bed, ergun, gidaspow
from periodicBox import superficial_speed


@pytest.mark.parametrize("phi, nu, drag, K", [
    (0.45, 0.5, "Ergun", ergun), (0.6, 0.0005, "Ergun", ergun),
    (0.1, 0.005, "Gidaspow", gidaspow),
])
def test_bed_has_the_pressure_gradient_of_its_drag_law(
    phi, nu, drag, K, tmp_path
):
    case = bed(tmp_path, phi, nu, K, drag)
    case.controls(endTime=0.6, deltaT=0.02)
    case.solve()
    assert superficial_speed(case)[-1] == pytest.approx(1, abs=1e-6)
