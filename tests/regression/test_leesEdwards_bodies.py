# SPDX-License-Identifier: GPL-3.0-or-later
"""Boxes that slide (Lees & Edwards): bodies, contact and grains across the
pair."""

import math

import numpy as np
import pytest

from slidingBox import (
    TIGHT, N, centres, disc, eddies, prepare, set_stress, set_velocity,
    sliding_box, stress,
)


def test_passes(tmp_path):
    """A body that passes the pair goes on with the velocity of what is
    beyond."""
    case = prepare(
        tmp_path, "passes", velocity=eddies((N, N), 1, size=0), end=0.3,
        dt=0.01, shear="shearRate 1;", shift=0.4,
    )
    case.bodies(disc(0.31, 0.95, 0.45).replace("(0.45 0", "(0.45 0.5"), TIGHT)
    case.solve()
    motion = case.table("motion")
    y, u = motion["position_y"], motion["velocity_x"]
    step = int(np.argmax(np.diff(y) < -0.5)) + 1
    assert y[step - 1] - y[step] == pytest.approx(1, abs=0.02)
    assert u[step - 1] - u[step] == pytest.approx(1, abs=0.02)
    # Otherwise smooth
    change = np.abs(np.delete(np.diff(u), step - 1))
    assert change.max() < 0.03


@pytest.mark.parametrize("height", [0.5, 0.9])
def test_square_array(height, tmp_path):
    """A free disc in Stokes flow: viscosity and spin of a square array, area
    fraction 0.24, shifted by a quarter; exact 1.5194296 and -0.4870028. Wherever
    the disc is."""
    n, R, nu = 29, math.sqrt(0.24/math.pi), 200
    case = prepare(
        tmp_path, "array", cells=(n, n), velocity=eddies((n, n), 1, size=0),
        shift=0.15, end=0.1, dt=0.005, nu=nu,
    )
    case.replace(
        "system/fvSchemes", "div(phi,U)          Gauss linear",
        "div(phi,U)          none",
    )
    set_stress(case)
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius {R:.12g}; }}
            densityRatio 1;
            position    (0.51 {height + 0.01:.12g} 0);
            velocity    ({height - 0.49:.12g} 0 0);
            angularVelocity (0 0 -0.5);
        }}
    """)
    case.solve()
    assert stress(case)["viscosity"][-1]/nu == pytest.approx(1.5194, rel=1e-3)
    spin = case.table("motion")["angularVelocity_z"][-1]
    assert spin == pytest.approx(-0.4870, rel=2e-3)


def test_spheres(tmp_path):
    """In three dimensions, off the middle of the box, as in the middle."""
    spins = []
    for height in (0.5, 0.9):
        n = 12
        case = sliding_box(tmp_path, f"at{height}", (n, n, n), (1, 1, 1))
        x = centres((n, n, n), (1, 1, 1))
        velocity = 0*x
        velocity[:, 0] = x[:, 1] - 0.5
        set_velocity(case, velocity)
        case.controls(endTime=0.1, deltaT=0.01)
        case.bodies(f"""
            sphere
            {{
                shape       {{ type sphere; radius 0.25; }}
                densityRatio 1;
                position    (0.52 {height + 0.02:.12g} 0.52);
                velocity    ({height - 0.48:.12g} 0 0);
                angularVelocity (0 0 -0.5);
            }}
        """)
        case.solve()
        spins.append(case.table("motion")["angularVelocity_z"][-1])
    assert spins[0] == pytest.approx(spins[1], rel=3e-3)
    assert spins[0] == pytest.approx(-0.5, rel=0.03)


def pair_case(folder, move, contact):
    """Two discs that shear and a push bring together, moved up by `move`."""
    case = prepare(
        folder, f"moved{move:g}", velocity=eddies((N, N), 1, size=0), nu=1, end=0.2,
        dt=0.005,
    )
    text = ""
    for name, x, y in (("a", 0.35, 0.56), ("b", 0.64, 0.44)):
        up = y + move
        above = up > 1
        text += f"""
            {name}
            {{
                shape       {{ type disc; radius 0.14; }}
                densityRatio 1;
                position    ({x} {up - above:.15g} 0);
                velocity    ({up - above - 0.5:.15g} 0 0);
                restraints
                {{
                    push
                    {{
                        type externalForce;
                        force ({3 if name == "a" else -3} 0 0);
                    }}
                }}
            }}
        """
    case.bodies(text, f"rho 1;\n{TIGHT}\n{contact}")
    case.solve()
    return case


@pytest.mark.parametrize(
    "contact",
    [
        pytest.param(
            "contact { type softSphere; }", marks=pytest.mark.nightly
        ),
        "contact { type softSphere; } lubrication { type leadingOrder; }",
        "contact { type inelastic; }",
    ],
)
def test_contact_across(contact, tmp_path):
    """Two that collide across the pair of patches, as two in the middle."""
    apart = []
    for move in (0, 0.5):
        case = pair_case(tmp_path, move, contact)
        a, b = case.table("motion", 0), case.table("motion", 1)
        x = b["position_x"] - a["position_x"]
        y = b["position_y"] - a["position_y"]
        above = np.round(y)
        x, y = x - above*a["time"], y - above
        x -= np.round(x)
        apart.append(np.hypot(x, y))
    # Films keep them apart
    assert apart[0].min() < (0.295 if "lubrication" in contact else 0.285)
    assert np.abs(apart[1] - apart[0]).max() < 1e-3


def test_unresolved_across(tmp_path):
    """A grain that moves with a uniform shear goes on with it, wherever the
    pair cuts its kernel."""
    n = 10
    case = sliding_box(tmp_path, "grain", (n, n, n), (1, 1, 1), shift=0.37)
    velocity = np.zeros((n**3, 3))
    velocity[:, 0] = centres((n, n, n), (1, 1, 1))[:, 1] - 0.5
    set_velocity(case, velocity)
    case.controls(endTime=0.2, deltaT=0.01)
    case.bodies("""
        grain
        {
            shape       { type sphere; radius 0.002; }
            densityRatio 5;
            position    (0.9 0.97 0.5);
            velocity    (0.47 0 0);
            angularVelocity (0 0 -0.5);
            coupling    unresolved;
        }
    """)
    case.solve()
    motion = case.table("motion")
    assert np.abs(motion["velocity_x"] - 0.47).max() < 1e-9
    assert np.abs(motion["velocity_y"]).max() < 1e-9
    assert np.abs(motion["angularVelocity_z"] + 0.5).max() < 1e-8
