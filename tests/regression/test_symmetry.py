# SPDX-License-Identifier: GPL-3.0-or-later
"""A body that a plane of symmetry cuts is like the whole one."""

import pytest

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform
from foamCase import FoamError

PATCHES = {
    False: {"inlet": "x-", "outlet": "x+", "walls": "y- y+"},
    True: {"inlet": "x-", "outlet": "x+", "walls": "y+", "middle": "y-"},
}


def speed(folder, half, ranks=1, across=0):
    """Speed of a free disc on the centre line of a tube, or of half of it."""
    case = BodyCase("tube", folder, f"half{half}{ranks}")
    y = uniform(0, 1, 20) if half else uniform(-1, 1, 40)
    boxMesh.write(case, uniform(-1, 1, 40), y, None, PATCHES[half])
    if half:
        case.set_symmetry("middle")
    # The slowest part of what outer iterations change takes hundreds of them
    case.replace(
        "system/fvSolution", "GAMG;\n        smoother        GaussSeidel",
        "fastPoisson",
    )
    case.replace("system/fvSolution", "relTol          1e-3", "relTol 1e-6")
    case.run("blockMesh")
    case.run("setExprFields")
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius 0.2; }}
            densityRatio 2;
            position    (-0.2 0 0);
            velocity    (0.5 {across} 0);
            angularVelocity (0 0 0);
        }}
    """, "coupling { nOuterCorrectors 300; tolerance 1e-9; }")
    case.controls(endTime="0.1", deltaT="0.02")
    case.solve(ranks)
    return case.table("motion")["velocity_x"][-1]


def test_half_a_body(tmp_path):
    half = speed(tmp_path, True)
    assert half == pytest.approx(speed(tmp_path, False), rel=5e-5)
    assert half == pytest.approx(speed(tmp_path, True, ranks=2), rel=1e-5)


def test_a_body_that_would_leave_the_plane(tmp_path):
    with pytest.raises(FoamError, match="cut by a plane of symmetry"):
        speed(tmp_path, True, across=0.3)


def held(folder, half, angle=45):
    """Tables of the loads on a held square, and the log, to a steady state."""
    case = BodyCase("tube", folder, f"held{half}{angle}")
    y = uniform(0, 1, 10) if half else uniform(-1, 1, 20)
    boxMesh.write(case, uniform(-1, 1, 20), y, None, PATCHES[half])
    if half:
        case.set_symmetry("middle")
    case.run("blockMesh")
    case.run("setExprFields")
    case.bodies(f"""
        square
        {{
            shape       {{ type box; size (0.4 0.4 1); }}
            orientation {{ type axisAngle; axis (0 0 1); angle {angle}; }}
            position    (-0.2 0 0);
            motion      {{ type fixed; }}
        }}
    """, "steady {}")
    case.controls(endTime="50", deltaT="0.1")
    log = case.solve()
    return case.table("forces"), log


def test_loads_are_those_of_the_whole_body(tmp_path):
    half, log = held(tmp_path, True)
    whole, _ = held(tmp_path, False)

    # The pressure on the cells of one half is no load across the plane
    assert "\nSteady after" in log
    assert abs(half["fluidForce_y"]).max() == 0
    assert abs(half["fluidTorque_z"]).max() == 0
    assert half["fluidForce_x"][-1] == pytest.approx(
        whole["fluidForce_x"][-1], rel=2e-4
    )


def test_a_body_that_is_not_symmetric(tmp_path):
    with pytest.raises(FoamError, match="not symmetric .* 'orientation'"):
        held(tmp_path, True, angle=30)
