# SPDX-License-Identifier: GPL-3.0-or-later
"""A body that a plane of symmetry cuts moves as the whole one does."""

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
    """)
    case.controls(endTime="0.2", deltaT="0.02")
    case.solve(ranks)
    return case.table("motion")["velocity_x"][-1]


def test_half_a_body(tmp_path):
    half = speed(tmp_path, True)
    assert half == pytest.approx(speed(tmp_path, False), rel=2e-4)
    assert half == pytest.approx(speed(tmp_path, True, ranks=2), rel=1e-5)


def test_a_body_that_would_leave_the_plane(tmp_path):
    with pytest.raises(FoamError, match="cut by a plane of symmetry"):
        speed(tmp_path, True, across=0.3)
