# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that move through more cells in a time step than the fluid can follow:
the step is halved, or the run stops with a reason, whatever solves for U."""

import pytest

from bodyCase import BodyCase
from boxMesh import uniform
from foamCase import FoamError

SMOOTH = "smoothSolver;\n        smoother        symGaussSeidel"
BODY = """
    disc
    {
        shape       { type disc; radius 0.25; }
        position    (-1.5 0 0);
        motion      { type prescribed; %s }
    }
"""


@pytest.fixture(params=["PBiCGStab", "smoothSolver"])
def tube(request, tmp_path):
    case = BodyCase("tube", tmp_path)
    case.mesh(uniform(-3, 3, 60), uniform(-1, 1, 20))
    case.controls(endTime="0.04")
    if request.param == "smoothSolver":
        case.replace("system/fvSolution",
                     "PBiCGStab;\n        preconditioner  DILU", SMOOTH)
    return case


@pytest.mark.parametrize(
    "motion", ["velocity (80 0 0);", "angularVelocity (0 0 1000);"]
)
def test_the_step_is_halved(motion, tube):
    tube.bodies(BODY % motion)
    tube.controls(endTime="0.02")

    log = tube.solve()

    assert "times as far as it may" in log
    assert "repeated with deltaT" in log
    assert "\nTime = 0.02" in log


@pytest.mark.parametrize(
    "motion", ["velocity (1e5 0 0);", "angularVelocity (0 0 1e6);"]
)
def test_no_step_is_short_enough(motion, tube):
    tube.bodies(BODY % motion)

    with pytest.raises(FoamError) as error:
        tube.solve()

    message = str(error.value)
    assert "moves through too many cells" in message
    assert "'deltaT' in system/controlDict" in message
    assert "sigFpe" not in message
    # What it began from is left as it was
    assert "written" not in message
    assert not (tube.path / "0/uniform").exists()
