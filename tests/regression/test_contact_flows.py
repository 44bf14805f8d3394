# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact together with the rest: films, light bodies, steps that are repeated,
a window that moves, bodies that leave and enter."""

import re

import numpy as np
import pytest

from bodyCase import BodyCase
from boxMesh import uniform
from contactCase import box2d, contact, discs
from openTube import open_tube

HEAVY = 1e4


def parting(case, first, second):
    """Speed at which the second leaves the first at the end."""
    a, b = (case.table("motion", i)["velocity_x"] for i in (first, second))
    return b[-1] - a[-1]


@pytest.fixture(scope="module")
def film(tmp_path_factory):
    """A disc that falls onto a wall and on another disc, with films."""
    case = box2d(tmp_path_factory.mktemp("film"), 20, "film")
    case.gravity(y=-5)
    case.replace("constant/transportProperties", "0.1;", "0.05;")
    case.bodies(
        discs(
            [(-0.3, -0.6), (0.35, -0.4), (-0.25, 0.05)], ratio=4,
            velocities=[(0, -1), (0, -1), (0.2, -1.5)],
        ),
        f"{contact(e=0.7)} lubrication {{ type leadingOrder; }}"
        "coupling { tolerance 1e-4; }",
    )
    case.controls(
        endTime=0.24, deltaT=0.01, writeControl="timeStep", writeInterval=12,
        writePrecision=17, timePrecision=15,
    )
    whole = BodyCase(case, case.path.parent, "whole")
    whole.solve()
    return case, whole


def test_films_are_the_same_on_two_ranks(film, tmp_path):
    case, whole = film
    two = BodyCase(case, tmp_path, "two")
    two.solve(ranks=2)

    for body in range(3):
        a, b = (c.table("motion", body) for c in (whole, two))
        for column in ("position_y", "velocity_y", "angularVelocity_z"):
            # The linear solvers' errors, which films make larger: 3e-4
            assert b[column] == pytest.approx(a[column], abs=6e-4)
    # The wall slows it down before it touches
    speed = whole.table("motion", 0)["velocity_y"]
    assert speed[-1] > 0.3*speed[0]


def test_restart_with_films_is_exact(film, tmp_path):
    case, whole = film
    parts = BodyCase(case, tmp_path, "parts")
    parts.controls(endTime=0.12)
    parts.solve()
    parts.controls(endTime=0.24)
    parts.solve()

    for file in ("U", "p", "uniform/immersedBodies"):
        expected = (whole.path/whole.latest_time()/file).read_bytes()
        assert (parts.path/parts.latest_time()/file).read_bytes() == expected


def test_light_bodies_rise_to_a_wall(tmp_path):
    case = box2d(tmp_path, 20)
    case.gravity(y=-1)
    case.replace("constant/transportProperties", "0.1;", "0.02;")
    case.bodies(
        discs([(-0.3, 0.4), (0.35, 0.1)], ratio=0.1), contact(e=0.7)
    )
    case.controls(endTime=6, deltaT=0.02)
    log = case.solve()

    for body in (0, 1):
        motion = case.table("motion", body)
        speed = np.hypot(motion["velocity_x"], motion["velocity_y"])
        assert speed.max() > 0.1
        assert motion["velocity_y"][-25:] == pytest.approx(0, abs=0.01)
        assert motion["position_y"][-1] == pytest.approx(0.75, abs=0.01)
    assert log.count("not converged") < 0.1*log.count("Progress")


def test_a_repeated_step_undoes_its_contacts(tmp_path):
    # The light disc is that of test_steps, which makes a step be repeated
    case = BodyCase("tube", tmp_path)
    case.mesh(uniform(-1, 1, 40), uniform(-1, 1, 40))
    case.replace("constant/transportProperties", "0.5;", "1e-3;")
    light = """
        light
        {
            shape       { type disc; radius 0.2; }
            densityRatio 0.01;
            position    (0.013 -0.3 0);
            velocity    (0.2 0.3 0);
            angularVelocity (0 0 2);
        }
    """
    pair = discs(
        [(-0.49, 0.6), (0.1, 0.6)], radius=0.2, ratio=HEAVY,
        velocities=[(1, 0), (-0.2, 0)],
    )
    case.bodies(
        pair + light, f"coupling {{ nOuterCorrectors 3; }} {contact(e=0.8)}"
    )
    case.controls(endTime=0.3, deltaT=0.05)
    log = case.solve()

    # In that step they touch
    assert re.search(r"Time = 0\.175, repeated with deltaT", log)
    motion = case.table("motion", 0)
    before, after = np.interp(
        (0.15, 0.2), motion["time"], motion["velocity_x"]
    )
    assert before == pytest.approx(1, rel=0.01)
    assert after < 0
    assert parting(case, 0, 1) == pytest.approx(0.8*1.2, rel=0.02)


def test_in_a_window_that_moves(tmp_path):
    case = BodyCase("tube", tmp_path)
    case.mesh(uniform(-1, 1, 20), uniform(-1, 1, 20))
    case.bodies(
        discs(
            [(-0.35, 0), (0.3, 0.01)], ratio=HEAVY,
            velocities=[(3, 0), (1, 0)],
        ),
        f"window {{ type comoving; direction (1 0 0); }} {contact(e=0.8)}",
    )
    case.controls(endTime=0.3, deltaT=0.01)
    case.solve()
    assert parting(case, 0, 1) == pytest.approx(1.6, rel=0.02)

    # Their momentum is kept
    first, second = (case.table("motion", i) for i in (0, 1))
    x = first["position_x"] + second["position_x"]
    assert x == pytest.approx(-0.05 + 4*first["time"], abs=0.02)


@pytest.mark.parametrize("ranks", [1, 2])
def test_bodies_that_leave_and_enter(ranks, tmp_path):
    case = open_tube(tmp_path)
    case.bodies(
        discs(
            [(3.6, 0.5), (2.5, 0), (3.1, 0)], radius=0.2, ratio=HEAVY,
            velocities=[(4, 0), (4, 0), (2, 0)],
        ),
        f"{contact(e=0.8)} leaving {{ outlet {{ type remove; }} }}"
        " injection { grain { shape { type disc; radius 0.2; }"
        f" densityRatio {HEAVY}; velocity (6 0 0); position (0.4 0 0);"
        " times (0.05 0.3); } }",
    )
    case.controls(endTime=0.45, deltaT=0.01)
    case.solve(ranks=ranks)

    # 1 hits 2 while 0 passes the outlet; later 3 leaves 4 behind
    (table,) = case.path.glob("postProcessing/immersedBodies/0/passage.dat")
    text = table.read_text()
    assert len(re.findall(r"\benters\b|\bentered\b", text)) == 2
    assert case.table("motion", 0)["position_x"].max() > 3.9

    a, b = (case.table("motion", i) for i in (1, 2))
    n = min(len(a["time"]), len(b["time"]))
    apart = (b["velocity_x"][:n] - a["velocity_x"][:n])
    assert apart[0] == pytest.approx(-2, rel=0.01)
    assert apart[-1] == pytest.approx(1.6, rel=0.02)
