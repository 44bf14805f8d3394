# SPDX-License-Identifier: GPL-3.0-or-later
"""Windows that follow in two directions."""

import numpy as np
import pytest

from bodyCase import BodyCase
from periodicBox import periodic_case

DIAGONAL = "window { type comoving; directions ((1 1 0) (0 1 0)); }"


def test_a_body_that_moves_diagonally_stays_in_its_window(tmp_path):
    """As in a fixed mesh, which it crosses."""
    box = periodic_case(tmp_path, "box", 24, 2, 0, True)
    box.controls(endTime="0.2", deltaT="0.01")
    tables = {}
    for name, window in {"fixed": "", "window": DIAGONAL}.items():
        case = BodyCase(box, tmp_path, name)
        case.bodies("""
            disc
            {
                shape       { type disc; radius 0.2; }
                position    (0.51 0.48 0);
                motion      { type prescribed; velocity (1.2 -1.6 0);
                              angularVelocity (0 0 1); }
            }
        """, window)
        case.solve()
        tables[name] = {**case.table("motion"), **case.table("forces")}

    fixed, window = tables["fixed"], tables["window"]
    t = window["time"]
    assert window["windowPosition_x"] == pytest.approx(0.51, abs=1e-12)
    assert window["windowPosition_y"] == pytest.approx(0.48, abs=1e-12)
    assert window["unwrapped_x"] == pytest.approx(0.51 + 1.2*t, abs=1e-12)
    assert window["unwrapped_y"] == pytest.approx(0.48 - 1.6*t, abs=1e-12)
    assert fixed["unwrapped_y"] == pytest.approx(0.48 - 1.6*t, abs=1e-12)

    # After the sudden start
    late = t > 0.115
    for column in ("fluidForce_x", "fluidForce_y"):
        scale = np.abs(fixed["fluidForce_y"][late]).max()
        assert window[column][late] == pytest.approx(
            fixed[column][late], abs=0.05*scale
        ), column
