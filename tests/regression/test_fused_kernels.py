# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators in one pass over the mesh equal the plain ones."""

import numpy as np
import pytest

from bodyCase import BodyCase
from boxMesh import graded, uniform

PLAIN = "OptimisationSwitches { fusedKernels 0; }"
DISC = """
    disc
    {
        shape       { type disc; radius 0.25; }
        densityRatio 2;
        position    (-0.03 -0.3 0);
        velocity    ambient;
    }
"""


@pytest.mark.parametrize("U", [
    "PBiCGStab;\n        preconditioner  DILU;",
    # The one whose plain form goes component by component
    "smoothSolver; smoother symGaussSeidel;",
])
def test_fields_and_motions_are_the_same(U, tmp_path):
    """A free disc between graded cells, to the errors of linear solvers that
    are set to rounding."""
    case = BodyCase("tube", tmp_path, "fused")
    case.mesh(graded(-2, 2, (-0.5, 0.5), 0.1), uniform(-1, 1, 20))
    case.replace("constant/transportProperties", "0.5;", "0.05;")
    for old, new in (
        ("1e-8;\n        relTol          0.01", "1e-14; relTol 0"),
        ("1e-9;\n        relTol          1e-3", "1e-14; relTol 0"),
        ("PBiCGStab;\n        preconditioner  DILU;", U),
    ):
        case.replace("system/fvSolution", old, new)
    case.bodies(DISC, "coupling { tolerance 1e-10; nOuterCorrectors 50; }")
    case.controls(
        endTime="0.1", writeInterval="0.1", writeFormat="ascii",
        writePrecision="16",
    )
    plain = BodyCase(case, tmp_path, "plain")
    plain.replace(
        "system/controlDict", "functions\n{", f"{PLAIN}\n\nfunctions\n{{"
    )
    case.solve()
    log = plain.solve()
    assert "fusedKernels" in log

    for field in ("U", "p"):
        expected = plain.field(field)
        error = np.abs(case.field(field) - expected).max()
        assert error < 1e-8*np.abs(expected).max(), field
    # Rounding tells that it is another way
    assert (case.field("U") != plain.field("U")).any()

    for table, column in (
        ("motion", "velocity_x"), ("motion", "velocity_y"),
        ("motion", "angularVelocity_z"), ("forces", "fluidForce_x"),
    ):
        expected = plain.table(table)[column]
        assert case.table(table)[column] == pytest.approx(
            expected, rel=1e-8, abs=1e-8*np.abs(expected).max()
        ), column
