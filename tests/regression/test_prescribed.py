# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that are fixed or move as prescribed."""

import re

import numpy as np
import pytest

from bodyCase import BodyCase
from boxMesh import uniform

LOCKED = "constraints { translate (0 0 0); rotate (0 0 0); }"
VELOCITY = "(0.5 -0.2 0)"
SPIN = "(0 0 0.7)"
SINE = """motion
    {
        type        prescribed;
        velocity    { type sine; amplitude 2; frequency 5; scale (1 0.5 0);
                      level (0 0 0); }
    }"""


@pytest.fixture(scope="module")
def tube(tmp_path_factory):
    """Coarse tube with one disc, D/h = 5, meshed."""
    case = BodyCase("tube", tmp_path_factory.mktemp("prescribed"))
    case.mesh(uniform(-3, 3, 60), uniform(-1, 1, 20))
    return case


def run(tube, tmp_path, name, motion, before=""):
    """The case with the motion of its disc, after its run, and its log."""
    case = BodyCase(tube, tmp_path, name)
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius 0.25; }}
            position    (-0.53 -0.3 0);
            {motion}
        }}
    """, before)
    case.controls(endTime="0.2")
    return case, case.solve()


def same(one, other):
    """Are both tables of two runs the same to the last digit?"""
    return all(
        np.array_equal(one.table(table)[column], other.table(table)[column])
        for table in ("motion", "forces") for column in one.table(table)
    )


def test_fixed_is_locked_at_rest(tube, tmp_path):
    locked, _ = run(tube, tmp_path, "locked", LOCKED)
    fixed, log = run(tube, tmp_path, "fixed", "motion { type fixed; }")

    assert same(fixed, locked)
    assert "motion: 0 free, 1 fixed, 0 prescribed" in log
    assert set(re.findall(r"outer iterations (\d+)", log)) == {"1"}


def test_constant_velocities_are_those_of_a_locked_body(tube, tmp_path):
    locked, _ = run(
        tube, tmp_path, "locked",
        f"{LOCKED} velocity {VELOCITY}; angularVelocity {SPIN};",
    )
    prescribed, log = run(
        tube, tmp_path, "prescribed",
        "motion { type prescribed;"
        f" velocity {VELOCITY}; angularVelocity constant {SPIN}; }}",
    )

    assert same(prescribed, locked)
    assert "motion: 0 free, 0 fixed, 1 prescribed" in log


def test_free_across_is_a_free_body_with_a_locked_velocity(tube, tmp_path):
    across = "densityRatio 2; constraints { translate (0 1 0); rotate (0 0 0); }"
    free, _ = run(tube, tmp_path, "free", f"{across} velocity (0.5 0 0);")
    towed, log = run(
        tube, tmp_path, "towed",
        f"{across} motion {{ type prescribed; velocity (0.5 0 0); }}",
    )

    assert same(towed, free)
    assert "motion: 1 free, 0 fixed, 0 prescribed" in log
    assert np.abs(free.table("motion")["velocity_y"]).max() > 1e-4


def test_least_number_of_iterations(tube, tmp_path):
    case, log = run(
        tube, tmp_path, "four", SINE,
        "coupling { minOuterCorrectors 4; tolerance 10; }"
    )
    assert "at most 50 iterations, tolerance 10, at least 4" in log
    assert set(re.findall(r"outer iterations (\d+)", log)) == {"4"}


def test_position_and_iterations_of_a_body_that_starts_from_rest(
    tube, tmp_path
):
    case, log = run(tube, tmp_path, "sine", SINE)

    motion = case.table("motion")
    t, dt = motion["time"], 0.02
    speed = 2*np.sin(2*np.pi*5*t)
    assert motion["velocity_x"] == pytest.approx(speed, abs=1e-12)
    assert motion["velocity_y"] == pytest.approx(0.5*speed, abs=1e-12)

    # The trapezoidal rule from rest
    moved = dt*(np.cumsum(speed) - 0.5*speed)
    assert motion["position_x"] == pytest.approx(-0.53 + moved, abs=1e-12)
    assert motion["position_y"] == pytest.approx(-0.3 + 0.5*moved, abs=1e-12)

    # Its load is waited for, from the first step on
    assert set(re.findall(r"outer iterations (\d+)", log)) == {"4"}
    assert "not converged" not in log


def test_window_follows_a_prescribed_body(tube, tmp_path):
    case, _ = run(
        tube, tmp_path, "window", SINE.replace("0.5 0)", "0 0)"),
        "window { type comoving; direction (1 0 0); }",
    )

    motion = case.table("motion")
    assert motion["windowPosition_x"] == pytest.approx(-0.53, abs=1e-12)
    assert abs(motion["position_x"] + 0.53).max() > 0.01
