# SPDX-License-Identifier: GPL-3.0-or-later
"""Time steps that do not converge: a disc of a hundredth of the fluid's density,
thrown into a flow of little viscosity, Courant numbers of 2.1 and 6."""

import re

import numpy as np
import pytest

from bodyCase import BodyCase
from boxMesh import uniform
from foamCase import FoamError


@pytest.fixture(scope="module")
def tube(tmp_path_factory):
    case = BodyCase("tube", tmp_path_factory.mktemp("steps"))
    case.mesh(uniform(-1, 1, 40), uniform(-1, 1, 40))
    case.replace("constant/transportProperties", "0.5;", "1e-3;")
    return case


def prepare(tube, folder, n_outer, deltaT):
    case = BodyCase(tube, folder, "case")
    case.bodies("""
        disc
        {
            shape       { type disc; radius 0.2; }
            densityRatio 0.01;
            position    (0.013 -0.3 0);
            velocity    (0.2 0.3 0);
            angularVelocity (0 0 2);
        }
    """, f"coupling {{ nOuterCorrectors {n_outer}; }}")
    case.controls(endTime=6*deltaT, deltaT=deltaT)
    return case


def test_a_step_is_repeated_with_half_its_length(tube, tmp_path):
    deltaT = 0.07
    case = prepare(tube, tmp_path, 3, deltaT)
    log = case.solve()
    repeats = re.findall(r"Time = (\S+), repeated with deltaT = (\S+)", log)
    assert len(repeats) == 1
    end, half = map(float, repeats[0])
    assert half == pytest.approx(deltaT/2)

    # The pieces end where the step was to end, and the others are whole
    motion = case.table("motion")
    times = motion["time"]
    whole = deltaT*np.arange(1, 7)
    assert np.abs(end + half - whole).min() < 1e-9
    assert times == pytest.approx(np.sort(np.append(whole, end)), abs=1e-9)
    assert np.abs(motion["velocity_x"]).max() < 3


def test_a_run_that_cannot_go_on_stops_with_its_state(tube, tmp_path):
    deltaT = 0.2
    case = prepare(tube, tmp_path, 3, deltaT)
    with pytest.raises(FoamError, match="however short it is made"):
        case.solve()

    # What has been written is the end of the last good step
    end = case.latest_time()
    assert float(end) == pytest.approx(case.table("motion")["time"][-1])
    assert (case.path / end / "uniform/immersedBodies").is_file()

    # It can be read again
    case.run("foamRun", "-check")
