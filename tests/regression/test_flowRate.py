# SPDX-License-Identifier: GPL-3.0-or-later
"""Periodic flow at a given flow rate."""

import math
import re

import numpy as np
import pytest

from foamCase import FoamError
from periodicBox import periodic_case
from periodicTube import FLOW_RATE, direct_pressure, periodic_tube

NU = 0.5
FREE = """
    disc
    {{
        shape       {{ type disc; radius 0.2; }}
        densityRatio 2;
        position    ({x:.15g} 0.15 0);
        velocity    (1 0 0);
    }}
"""
FIXED = """
    disc
    {{
        shape       {{ type disc; radius {radius:.15g}; }}
        position    {position};
        motion      {{ type fixed; }}
    }}
"""


def acceleration(log):
    """Of all outer iterations [m/s2]."""
    return np.array(re.findall(r"acceleration (\S+) m/s2", log), dtype=float)


def end_speed(case, time):
    """Flow rate through an end over its area [m/s]."""
    text = (case.path / time / "phi").read_text().split("left", 1)[1]
    text = re.search(r"\(\n(.*?)\n\)", text, re.DOTALL).group(1)
    return -np.array(text.split(), dtype=float).sum()/0.1


def test_plane_flow(tmp_path):
    """-dp/dx = 12 nu U/H^2. The body is beside the tube, with its band just
    in it, where nothing is left of it."""
    case = periodic_tube(tmp_path, "plane", 16, speed=1.5)
    y = 0.5 - 0.5/16 + 4.4/16 + 0.13
    case.bodies(FIXED.format(radius=0.13, position=f"(1 {y} 0)"))
    case.controls(endTime="3", deltaT="0.05")
    values = acceleration(case.solve())
    # With the error of the mesh, N cells across
    exact = 12*NU*1.5/(1 + 2/16**2)
    assert values[-1] == pytest.approx(exact, rel=1e-4)
    assert values[-1] == pytest.approx(values[-5], rel=1e-6)


def test_the_rate_is_held_around_a_free_disc(tmp_path):
    """While it crosses the ends."""
    case = periodic_tube(tmp_path, "free", 12, speed=1.5)
    case.bodies(FREE.format(x=1.8))
    case.controls(
        endTime="0.6", deltaT="0.02", writeControl="timeStep",
        writeInterval="10", writeFormat="ascii", writePrecision="15",
    )
    log = case.solve()
    assert "repeated" not in log
    for time in case.times()[1:]:
        assert end_speed(case, time) == pytest.approx(1.5, rel=1e-10)
        # Of the cells less exactly: at the disc the flux is the rigid motion's
        assert case.field("U", time)[:, 0].mean() == pytest.approx(
            1.5, rel=5e-3
        )
    assert case.table("motion")["unwrapped_x"][-1] > 2


@pytest.mark.parametrize("concentration, drag", [(0.1, 24.83), (0.2, 51.53)])
def test_a_square_array(concentration, drag, tmp_path):
    """-dp/dx of the drag F/(mu U) per length of Sangani & Acrivos (1982), Int.
    J. Multiphase Flow 8, 193; the disc in a corner of the cell."""
    case = periodic_case(tmp_path, "array", 32, 2, 0, True)
    direct_pressure(case)
    (case.path / "constant/fvOptions").write_text(FLOW_RATE.format(speed=1))
    case.replace(
        "system/fvSchemes", "div(phi,U)          Gauss linear",
        "div(phi,U)          none",
    )
    radius = math.sqrt(concentration/math.pi)
    case.bodies(FIXED.format(radius=radius, position="(0.01 0.02 0)"))
    case.controls(endTime="1.2", deltaT="0.02")
    values = acceleration(case.solve())
    assert values[-1] == pytest.approx(NU*drag, rel=5e-3)
    # It balances the drag; per depth of the mesh
    assert case.table("forces")["fluidForce_x"][-1] == pytest.approx(
        0.1*values[-1], rel=1e-4
    )


def test_without_bodies_it_is_refused(tmp_path):
    case = periodic_tube(tmp_path, "none", 8, speed=1.5)
    case.bodies("")
    with pytest.raises(FoamError, match="use meanVelocityForce"):
        case.solve()


def test_walls_across_are_refused(tmp_path):
    case = periodic_tube(tmp_path, "across", 8, speed=1.5)
    case.replace("constant/fvOptions", "(1 0 0)", "(1 1 0)")
    case.bodies(FREE.format(x=1))
    with pytest.raises(FoamError, match="not parallel to the patch 'walls'"):
        case.solve()


def test_no_flux_where_discs_settle(tmp_path):
    """A box without walls, in which the force balances the weight of the
    bodies. They are a square array, turned by 45 degrees, with the drag of
    Sangani & Acrivos at a concentration of 0.2."""
    ratio, g = 3, 20
    case = periodic_case(tmp_path, "settling", 32, 2, 0, True)
    direct_pressure(case)
    case.replace("0/U", "uniform (1 0 0)", "uniform (0 0 0)")
    case.replace(
        "system/fvSchemes", "div(phi,U)          Gauss linear",
        "div(phi,U)          none",
    )
    (case.path / "constant/fvOptions").write_text(FLOW_RATE.format(speed=0))
    case.gravity(g)
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius {math.sqrt(0.1/math.pi):.15g}; }}
            densityRatio {ratio};
            positions   ((0.31 0.27 0) (0.81 0.77 0));
            velocity    (0 0 0);
            angularVelocity (0 0 0);
        }}
    """)
    case.controls(endTime="1", deltaT="0.02")
    values = acceleration(case.solve())
    weight = 0.1*(ratio - 1)*g
    assert values[-1] == pytest.approx(-2*weight, rel=2e-3)
    speed = case.table("motion")["velocity_x"]
    assert speed[-1] == pytest.approx(weight/(NU*51.53), rel=5e-3)
    # Through a section, over that of the bodies: 0.1 is the depth
    flux = case.read_dat("postProcessing/flowRate/0/surfaceFieldValue.dat")
    assert abs(flux[:, 1]/0.1).max() < 1e-10*speed[-1]
