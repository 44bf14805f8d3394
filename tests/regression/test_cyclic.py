# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies on cyclic patches, their images listed."""

import pytest

from foamCase import FoamError
from periodicBox import periodic_case, superficial_speed

FIXED = "constraints { translate (0 0 0); rotate (0 0 0); }"
CELLS = 16


def solve(folder, name, positions, ranks=1, by_force=False):
    """Flow rate through an array of discs, one per box."""
    case = periodic_case(folder, name, CELLS, 2, 30, by_force)
    case.replace(
        "system/fvSchemes", "div(phi,U)          Gauss linear",
        "div(phi,U)          none",
    )
    case.bodies(f"""
        disc
        {{
            shape {{ type disc; radius 0.2; }}
            positions ({positions});
            {FIXED}
        }}
    """)
    case.controls(endTime="80", deltaT="0.05")
    # Cut so that the patch of the flow rate stays whole
    case.solve(ranks, (1, ranks, 1))
    return superficial_speed(case, 0.1)[-1]


def test_a_body_on_a_cyclic_patch(tmp_path):
    """The same as in the middle, on one processor and on two."""
    x, y = 0.3/CELLS, 0.4/CELLS
    middle = solve(tmp_path, "middle", f"({0.5 + x} {0.5 + y} 0)")
    corners = " ".join(
        f"({x + i} {y + j} 0)" for i in (0, 1) for j in (0, 1)
    )
    assert solve(tmp_path, "corner", corners) == pytest.approx(
        middle, rel=1e-4
    )
    assert solve(tmp_path, "ranks", corners, ranks=2) == pytest.approx(
        middle, rel=1e-4
    )


def test_a_body_force_is_a_pressure_gradient(tmp_path):
    """fvOptions: their force acts on the layer as the gradient would."""
    middle = "(0.52 0.53 0)"
    assert solve(tmp_path, "force", middle, by_force=True) == pytest.approx(
        solve(tmp_path, "gradient", middle), rel=1e-3
    )


def test_a_fixed_body_outside_the_mesh(tmp_path):
    with pytest.raises(FoamError, match="outside the mesh"):
        solve(tmp_path, "outside", "(2 0.5 0)")
