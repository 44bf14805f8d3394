# SPDX-License-Identifier: GPL-3.0-or-later
"""Windows that follow in two directions, and the flux that is absolute."""

import numpy as np
import pytest

from bodyCase import BodyCase
from boxMesh import uniform
from periodicBox import periodic_case

DIAGONAL = "window { type comoving; directions ((1 1 0) (0 1 0)); }"
ALONG = "window { type comoving; direction (1 0 0); }"
RATES = """functions
{
    absoluteFlux
    {
        type            absoluteFlux;
        libs            (immersedBodyFunctionObjects);
    }
    inletRate
    {
        type            surfaceFieldValue;
        libs            (fieldFunctionObjects);
        regionType      patch;
        name            inlet;
        operation       sum;
        fields          (phi phiAbs);
        writeFields     no;
        log             no;
        writeControl    timeStep;
        writePrecision  15;
    }
    outletRate { $inletRate; name outlet; }
"""


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


def test_absolute_flux_in_a_window_is_that_of_the_tube(tmp_path):
    tube = BodyCase("tube", tmp_path)
    tube.mesh(uniform(-2, 2, 40), uniform(-1, 1, 20))
    tube.controls(endTime="0.06")
    tube.replace("system/controlDict", "functions\n{", RATES)
    rates = {}
    for name, window in {"fixed": "", "window": ALONG}.items():
        case = BodyCase(tube, tmp_path, name)
        case.bodies("""
            disc
            {
                shape       { type disc; radius 0.25; }
                position    (-0.53 -0.3 0);
                densityRatio 2;
                velocity    ambient;
            }
        """, window)
        case.solve()
        for patch in ("inlet", "outlet"):
            table = case.read_dat(
                f"postProcessing/{patch}Rate/0/surfaceFieldValue.dat"
            )
            rates[name, patch] = table[:, 1], table[:, 2]
        speed = case.table("motion")["velocity_x"]

    section = 0.2
    for patch, sign in (("inlet", -1), ("outlet", 1)):
        relative, absolute = rates["window", patch]
        there, also = rates["fixed", patch]
        assert len(relative) == 3
        assert (there == also).all()
        assert absolute == pytest.approx(there, abs=1e-12)
        assert absolute == pytest.approx(sign*section, rel=0.01)
        assert relative == pytest.approx(
            absolute - sign*section*speed, abs=1e-12
        )
    assert speed.min() > 0.5
