# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes in a flow: those that are the same have the same motion."""

import numpy as np
import pytest

from bodyCase import BodyCase
from boxMesh import uniform

PAIRS = {
    "tube": (
        "type ellipse; semiAxes (0.3 0.2);",
        "type superellipse; semiAxes (0.3 0.2); exponent 2;",
        "type superellipse; semiAxes (0.3 0.2); exponent 8;",
    ),
    "box": (
        "type ellipsoid; semiAxes (0.3 0.2 0.25);",
        "type superellipsoid; semiAxes (0.3 0.2 0.25); exponents (2 2);",
        "type superellipsoid; semiAxes (0.3 0.2 0.25); exponents (8 4);",
    ),
}


def motion(mesh, tmp_path, name, shape, turned=""):
    """The motion table of a free body that starts with a spin."""
    case = BodyCase(mesh, tmp_path, name)
    case.bodies(f"""
        body
        {{
            shape       {{ {shape} }}
            {turned}
            densityRatio 2;
            position    (0.04 0.03 0.1);
            velocity    (0.3 0 0);
            angularVelocity (0 0 2);
        }}
    """)
    case.controls(endTime="0.1")
    case.solve()
    return case.table("motion")


@pytest.mark.parametrize("kind", PAIRS)
def test_superellipsoids_between_ellipsoids_and_boxes(kind, tmp_path):
    mesh = BodyCase(kind, tmp_path)
    if kind == "tube":
        mesh.mesh(uniform(-3, 3, 60), uniform(-1, 1, 20))
    else:
        mesh.mesh(*3*[uniform(-1, 1, 16)])

    names = ("ellipsoid", "exponents2", "blunt")
    ellipsoid, round_one, blunt = (
        motion(mesh, tmp_path, name, shape)
        for name, shape in zip(names, PAIRS[kind])
    )

    for column, values in ellipsoid.items():
        assert round_one[column] == pytest.approx(values, abs=1e-8), column
    for column, values in blunt.items():
        assert np.isfinite(values).all()
    assert abs(blunt["velocity_x"] - ellipsoid["velocity_x"]).max() > 1e-4


TURNED = {
    "tube": (
        "type box; size (0.6 0.4 1);", "type box; size (0.4 0.6 1);",
        "type axisAngle; axis (0 0 1); angle 90;",
    ),
    "box": (
        "type ellipsoid; semiAxes (0.3 0.2 0.25);",
        "type ellipsoid; semiAxes (0.25 0.3 0.2);",
        "type axes; e1 (0 1 0); e3 (1 0 0);",
    ),
}


@pytest.mark.parametrize("kind", TURNED)
def test_a_turned_body_is_the_one_with_the_axes_swapped(kind, tmp_path):
    mesh = BodyCase(kind, tmp_path)
    if kind == "tube":
        mesh.mesh(uniform(-3, 3, 60), uniform(-1, 1, 20))
    else:
        mesh.mesh(*3*[uniform(-1, 1, 16)])

    shape, swapped, rotation = TURNED[kind]
    turned = motion(
        mesh, tmp_path, "turned", shape, f"orientation {{ {rotation} }}"
    )
    expected = motion(mesh, tmp_path, "swapped", swapped)
    along = motion(mesh, tmp_path, "along", shape)

    for column, values in expected.items():
        if not column.startswith("q_"):
            assert turned[column] == pytest.approx(values, abs=1e-8), column
    assert abs(along["velocity_x"] - turned["velocity_x"]).max() > 1e-4
