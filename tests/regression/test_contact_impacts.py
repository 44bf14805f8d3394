# SPDX-License-Identifier: GPL-3.0-or-later
"""Impacts of grains: coefficients by the speed, rough walls, rolling friction,
of resolved and unresolved grains."""

import numpy as np
import pytest

import restarts
from bodyCase import BodyCase
from boxMesh import uniform

ROUGH = (
    "contact { type softSphere; restitution table ((0 0.95) (4 0.6));"
    " friction 0.2; rollingFriction 0.02; wallRoughness 5; seed 3; }"
)


def grains(folder, name="box", coupling="unresolved", more=ROUGH):
    """Four heavy grains that fly about in a closed box of two by two by two."""
    case = BodyCase("box", folder, name)
    case.mesh(*3*[uniform(-1, 1, 10)])
    bodies = "\n".join(
        f"grain{i} {{ shape {{ type sphere; radius 0.09; }} densityRatio 1000;"
        f" position ({0.3*i - 0.5} {0.2*i - 0.3} {0.1*i}); "
        f"velocity ({3 - i} {2*i - 3} {1 + i}); }}"
        for i in range(4)
    )
    case.bodies(bodies, f"coupling {{ type {coupling}; }} {more}")
    case.gravity(z=-9.81)
    case.replace(
        "system/fvSolution", "GAMG;\n        smoother        GaussSeidel",
        "fastPoisson",
    )
    for solver in ("(p|pFinal)", "(U|UFinal)"):
        for entry, value in (("tolerance", 1e-15), ("relTol", 0)):
            case.set(
                "system/fvSolution", f'solvers/"{solver}"/{entry}', value
            )
    case.controls(
        endTime=1.2, deltaT=0.01, writeControl="timeStep", writeInterval=60,
        writePrecision=17, timePrecision=15,
    )
    return case


def velocities(case):
    return np.array([
        [case.table("motion", i)[f"velocity_{k}"] for k in "xyz"]
        for i in range(4)
    ])


def test_rough_walls_on_several_ranks(tmp_path):
    one = grains(tmp_path)
    two = BodyCase(one, tmp_path, "two")
    smooth = grains(tmp_path, "smooth", more=ROUGH.replace(
        "wallRoughness 5;", ""
    ))
    one.solve()
    two.solve(ranks=2)
    smooth.solve()

    state = (one.path/"1.2/uniform/immersedBodies").read_text()
    assert "wallImpacts" in state
    assert velocities(two) == pytest.approx(velocities(one), abs=1e-6)
    assert np.abs(velocities(smooth) - velocities(one)).max() > 0.3


def test_rough_walls_restart_exactly(tmp_path):
    restarts.check_exact(grains(tmp_path), tmp_path, 0.6, 1.2)


@pytest.mark.parametrize("speed, e", [(1, 0.8), (4, 0.5)])
@pytest.mark.parametrize("coupling", ["resolved", "unresolved"])
def test_rebound_by_the_speed(coupling, speed, e, tmp_path):
    case = BodyCase("box", tmp_path)
    case.mesh(*3*[uniform(-0.75, 0.75, 12)])
    case.bodies(
        "ball { shape { type sphere; radius 0.25; } densityRatio 1e4;"
        f" position (0.4 0.03 0.02); velocity ({speed} 0 0); }}",
        f"coupling {{ type {coupling}; }} contact {{ type softSphere;"
        " restitution table ((0 0.9) (4 0.5)); friction 0; }",
    )
    case.controls(endTime=0.4/speed, deltaT=0.02/speed)
    case.solve()
    rebound = case.table("motion")["velocity_x"][-1]
    assert rebound == pytest.approx(-e*speed, rel=0.01)


@pytest.mark.parametrize("coupling", ["resolved", "unresolved"])
def test_a_ball_rolls_until_it_stops(coupling, tmp_path):
    """After 7 V^2/(10 m g)."""
    V, m, g = 0.6, 0.2, 10
    case = BodyCase("box", tmp_path)
    case.mesh(*3*[uniform(-0.75, 0.75, 12)])
    case.bodies(
        "ball { shape { type sphere; radius 0.25; } densityRatio 1e4;"
        f" position (-0.4 0 -0.5); velocity ({V} 0 0);"
        f" angularVelocity (0 {V/0.25} 0); }}",
        f"coupling {{ type {coupling}; }} contact {{ type softSphere;"
        f" collisionTime 0.01; friction 0.5; rollingFriction {m}; }}",
    )
    case.gravity(z=-g)
    case.controls(endTime=0.8, deltaT=0.01)
    case.solve()
    motion = case.table("motion")
    way = motion["position_x"][-1] + 0.4
    assert way == pytest.approx(7*V**2/(10*m*g), rel=0.01)
    assert abs(motion["velocity_x"][-1]) < 1e-3*V
