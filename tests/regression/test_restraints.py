# SPDX-License-Identifier: GPL-3.0-or-later
"""Forces, springs and dampers on bodies, beside the fluid."""

import math
import re

import numpy as np
import pytest

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform

RADIUS, DEPTH, DT = 0.25, 0.1, 0.02
VOLUME = math.pi*RADIUS**2*DEPTH
G = 0.3, -0.5
FREE_ACROSS = "constraints { translate (0 1 0); rotate (0 0 0); }"


@pytest.fixture(scope="module")
def square(tmp_path_factory):
    """A square of two by two with walls, the fluid at rest; D/h = 5."""
    case = BodyCase("box", tmp_path_factory.mktemp("restraints"))
    side = uniform(-1, 1, 20)
    boxMesh.write(case, side, side, None, {"walls": "x- x+ y- y+"})
    for field in ("U", "p"):
        case.replace(
            f"0/{field}", "boundaryField\n{",
            "boundaryField\n{\n    frontAndBack { type empty; }",
        )
    case.run("blockMesh")
    return case


def run(square, tmp_path, name, entries, *, steps=10, g=False, rho=1):
    """Table of the motion of the disc, and the log."""
    case = BodyCase(square, tmp_path, name)
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius {RADIUS}; }}
            position    (-0.13 -0.3 0);
            {entries}
        }}
    """, f"rho {rho};")
    case.gravity(*(G if g else ()))
    case.controls(endTime=f"{steps*DT:.6g}", deltaT=str(DT))
    log = case.solve()
    return case.table("motion"), log


def discrete(steps, frequency, offset):
    """What the scheme makes of an oscillator that starts from rest: backward
    after one step of Euler, the position by the trapezoidal rule."""
    x, u, u0 = offset, 0.0, 0.0
    positions = []
    for step in range(steps):
        c, c0, c00 = (1.5, 2, 0.5) if step else (1, 1, 0)
        rest = (c0*u - c00*u0)/DT - frequency**2*(x + 0.5*DT*u)
        u0, u = u, rest/(c/DT + 0.5*DT*frequency**2)
        x += 0.5*DT*(u + u0)
        positions.append(x)
    return np.array(positions)


def test_a_mass_on_a_spring(square, tmp_path):
    """So heavy that the fluid does not matter."""
    frequency, rho = 2*math.pi/0.8, 800
    k = (1e6 - 1)*rho*VOLUME*frequency**2
    motion, _ = run(
        square, tmp_path, "spring", f"""
            densityRatio 1e6;
            {FREE_ACROSS}
            restraints
            {{
                spring
                {{
                    type        linearSpring;
                    anchor      (-0.13 -0.2 0);
                    stiffness   (0 {k:.15g} 0);
                }}
            }}
        """, steps=40, rho=rho,
    )

    moved = motion["position_y"] + 0.2
    assert moved == pytest.approx(discrete(40, frequency, -0.1), abs=3e-6)
    assert moved[-1] == pytest.approx(-0.1, rel=0.02)
    assert np.ptp(motion["position_x"]) == 0


def test_a_constant_force_is_as_gravity(square, tmp_path):
    rho, ratio = 700, 2.5
    force = (ratio - 1)*rho*VOLUME
    falls, _ = run(
        square, tmp_path, "gravity", f"densityRatio {ratio};", g=True, rho=rho
    )
    pushed, _ = run(
        square, tmp_path, "force", f"""
            densityRatio {ratio};
            restraints
            {{
                weight
                {{
                    type    externalForce;
                    force   ({0.3*force:.17g} {-0.5*force:.17g} 0);
                }}
            }}
        """, rho=rho,
    )

    assert np.abs(falls["velocity_y"]).max() > 0.01
    for column in falls:
        assert pushed[column] == pytest.approx(
            falls[column], rel=1e-10, abs=1e-10
        ), column


def test_a_spring_hangs_through(square, tmp_path):
    """Weight over stiffness, at rest in the fluid."""
    ratio, k = 3, 2.0
    motion, _ = run(
        square, tmp_path, "sag", f"""
            densityRatio {ratio};
            {FREE_ACROSS}
            restraints
            {{
                spring
                {{
                    type        linearSpring;
                    stiffness   (0 {k} 0);
                    damping     (0 0.5 0);
                }}
            }}
        """, steps=500, g=True,
    )

    sag = -(ratio - 1)*VOLUME*0.5/k
    assert motion["position_y"][-1] == pytest.approx(-0.3 + sag, rel=1e-6)
    assert abs(motion["velocity_y"][-1]) < 1e-6


def test_a_stiff_spring_converges(square, tmp_path):
    """Far stiffer than the time step resolves: it holds the body, but for
    what rings without a damper."""
    spring = """
        restraints { spring { type linearSpring; stiffness (1e6 1e6 0);
                              rotationalStiffness (0 0 1e6); } }
    """
    held, log = run(
        square, tmp_path, "stiff", f"densityRatio 2; {spring}", steps=20, g=True
    )

    assert np.ptp(held["position_y"]) < 1e-7
    assert "not converged" not in log
    assert max(map(int, re.findall(r"outer iterations (\d+)", log))) <= 4
