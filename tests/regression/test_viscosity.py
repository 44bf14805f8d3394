# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies in fluids whose viscosity depends on the shear rate."""

import numpy as np
import pytest

from bodyCase import BodyCase
from boxMesh import graded, uniform

# Coefficients; drag coefficient of a fitted mesh (benchmark
# variableViscosity), and by how much it is missed at D/h 10. With the viscosity
# that the shear rate in the layer has it is 5 %.
FLUIDS = {
    "uniform": ("nu0 1e-3; nuInf 1e-3; k 1; n 1;", 5.5795, 0.003),
    "thinning": ("nu0 5e-3; nuInf 5e-4; k 1; n 0.5;", 9.359, 0.025),
    "thickening": ("nu0 5e-4; nuInf 0; k 1; n 1.5;", 6.629, 0.01),
}
TRANSPOSED = "    div((nuEff*dev2(T(grad(U))))) Gauss linear;\n"


def set_fluid(case, coefficients):
    case.replace(
        "constant/transportProperties", "Newtonian;",
        f"BirdCarreau;\nBirdCarreauCoeffs {{ {coefficients} }}\n",
    )
    case.replace(
        "system/fvSchemes", "    default             none;\n",
        f"    default             none;\n{TRANSPOSED}",
    )


def drag(folder, fluid, ranks=1, n=None):
    """Drag coefficient of a cylinder in a channel, at 0.2 m/s, D 0.1."""
    case = BodyCase("cylinder", folder, f"{fluid}{ranks}")
    case.mesh(
        graded(0, 2.2, (0.1, 0.5), 0.01, 1.05), uniform(0, 0.41, 41)
    )
    set_fluid(case, FLUIDS[fluid][0])
    case.controls(endTime="8", deltaT="0.04")
    case.solve(ranks, n)
    force = case.table("forces")["fluidForce_x"]
    assert force[-10] == pytest.approx(force[-1], rel=2e-3)
    return 2*force[-1]/(0.1*0.2**2*0.1)


@pytest.mark.parametrize("fluid", FLUIDS)
def test_drag(fluid, tmp_path):
    _, reference, tolerance = FLUIDS[fluid]
    assert drag(tmp_path, fluid) == pytest.approx(reference, rel=tolerance)


def test_ranks(tmp_path):
    # The processors meet in the cylinder
    assert drag(tmp_path, "thinning", 2, (1, 2, 1)) == pytest.approx(
        drag(tmp_path, "thinning"), rel=1e-5
    )


def test_free_bodies_in_a_fluid_that_thins(tmp_path):
    case = BodyCase("tube", tmp_path)
    case.mesh(uniform(-3, 3, 150), uniform(-1, 1, 50))
    set_fluid(case, "nu0 0.5; nuInf 0.05; k 1; n 0.5;")
    case.bodies("""
        disc
        {
            shape        { type disc; radius 0.16; }
            densityRatio 2;
            positions    ((-0.5 -0.3 0) (-0.5 0.12 0));
            velocity     ambient;
        }
    """)
    case.controls(endTime="0.4", deltaT="0.01")
    log = case.solve()
    assert "not converged" not in log
    for body in (0, 1):
        speed = case.table("motion", body)["velocity_x"][10:]
        assert np.abs(np.diff(speed, 2)).max() < 1e-3*speed[-1]
