# SPDX-License-Identifier: GPL-3.0-or-later
"""The optical sensor on bodies whose passages are known exactly."""

import math

import numpy as np
import pytest

from bodyCase import BodyCase
from boxMesh import uniform
from openTube import DISC, DT, LENGTH, open_tube, passage
from periodicTube import periodic_tube
from sensorCase import add_sensor, passages, table

# x = -2 + t + t^2, y = 0.5 - t/4
ACCELERATED = """
    shape { type disc; radius 0.2; }
    motion
    {
        type        prescribed;
        velocity    table ((0 (1 -0.25 0)) (10 (21 -0.25 0)));
    }
"""
PLANES = """
    first  { point (-1.9 0 0); normal (1 0 0); radius 1; }
    second { point (-1.5 0.1 0); normal (1 0 0); radius 1; }
    turned { point (-1.5 0.1 0); normal (-2 0 0); radius 0.35; }
    askew  { point (-1 0 0); normal (1 1 0); axis (1 0 0); }
"""


@pytest.fixture(scope="module")
def tube(tmp_path_factory):
    case = BodyCase("tube", tmp_path_factory.mktemp("sensor"))
    case.mesh(uniform(-3, 3, 60), uniform(-1, 1, 20))
    case.controls(endTime="0.9", deltaT="0.05", writePrecision="12")
    return case


def reaches(x):
    """When the accelerated body is at x."""
    return math.sqrt(0.25 + x + 2) - 0.5


@pytest.mark.parametrize("ranks", [1, 2, 4])
def test_passages_are_exact(ranks, tube, tmp_path):
    case = BodyCase(tube, tmp_path)
    case.bodies(f"""
        ahead {{ {ACCELERATED} position (-2 0.5 0); }}
        behind {{ {ACCELERATED} position (-2.45 -0.4 0); }}
    """)
    add_sensor(case, PLANES, "rate 4; nRadii 4;")
    if ranks == 4:
        # Sends few messages: there may be fewer cores than ranks
        case.replace("system/fvSolution", "GAMG;", "PCG;")
        case.replace(
            "system/fvSolution", "smoother        GaussSeidel",
            "preconditioner  DIC",
        )
    case.solve(ranks, {4: (2, 2, 1)}.get(ranks))

    times = {
        "first": (reaches(-1.9), reaches(-1.45)),
        "second": (reaches(-1.5), reaches(-1.05)),
        "turned": (reaches(-1.5), reaches(-1.05)),
    }
    rows = passages(case)
    assert [r.time for r in rows] == sorted(r.time for r in rows)

    for plane, normal, y0 in (
        ("first", 1, 0), ("second", 1, 0.1), ("turned", -1, 0.1),
    ):
        found = passages(case, plane)
        # The second body is further than the radius from the axis
        n = 1 if plane == "turned" else 2
        assert [r.name for r in found] == ["ahead", "behind"][:n]
        assert [r.body for r in found] == [0, 1][:n]
        t = np.array(times[plane][:n])
        assert [r.time for r in found] == pytest.approx(t, abs=1e-12)
        assert [r.direction for r in found] == n*[normal]
        y = np.array([0.5, -0.4])[:n] - 0.25*t - y0
        for r, ti, yi in zip(found, t, y):
            assert r.velocity == pytest.approx([1 + 2*ti, -0.25, 0], abs=1e-12)
            assert r.axial == pytest.approx(normal*(1 + 2*ti), abs=1e-12)
            assert r.radius == pytest.approx(abs(yi), abs=1e-12)
            assert r.angle == (0 if yi > 0 else 180)
        assert math.isnan(found[0].interval)
        assert math.isnan(found[0].spacing)
        if n == 2:
            assert found[1].interval == pytest.approx(t[1] - t[0], abs=1e-11)
            assert found[1].spacing == pytest.approx(
                (t[1] - t[0])*(1 + 2*t[1]), abs=1e-11
            )

    # x + 1 + y = 0: the roots of t^2 + 3/4 t - 1/2
    askew = passages(case, "askew")[0]
    assert askew.time == pytest.approx(
        (-0.75 + math.sqrt(0.5625 + 2))/2, abs=1e-12
    )
    assert askew.axial == pytest.approx(1 + 2*askew.time, abs=1e-12)

    # Statistics, at the end
    summary = table(case, "0.9", "summary")
    assert list(summary["name"]) == ["first", "second", "turned", "askew"]
    assert list(summary["grains"][:3]) == [2, 2, 1]
    assert list(summary["backward"][:3]) == [0, 0, 1]
    assert summary["rate"][0] == pytest.approx(2/0.9)
    interval = np.diff(times["first"])[0]
    assert summary["meanInterval"][0] == pytest.approx(interval)
    assert summary["misses"][0] == (interval*4 > 1.5)
    assert summary["missRate"][0] == pytest.approx(
        (interval*4 > 1.5)/0.9
    )
    radii = table(case, "0.9", "radii")
    one = radii["plane"] == 0
    assert list(radii["grains"][one]) == [0, 2, 0, 0]
    # Of the mean of 2 in the area of 2 x 0.1
    area = 2*0.25*0.1
    assert radii["density"][one] == pytest.approx(radii["grains"][one]/area)
    assert radii["densityOverMean"][one].mean() == pytest.approx(1)


def test_tables_before_anything_has_passed(tube, tmp_path):
    """Floating-point exceptions are trapped: nothing is divided by zero."""
    case = BodyCase(tube, tmp_path)
    case.bodies(f"ahead {{ {ACCELERATED} position (-2 0.5 0); }}")
    add_sensor(
        case, PLANES,
        "rate 4; start 0.2; writeControl timeStep; outlets (first second);",
    )
    case.controls(endTime="0.25")
    case.solve()

    for time in ("0.05", "0.2", "0.25"):
        summary = table(case, time, "summary")
        assert list(summary["grains"]) == 4*[0]
        assert np.isnan(summary["rate"]).all() == (time != "0.25")
        assert list(table(case, time, "outlets")["share"]) == [0, 0]
    assert list(summary["rate"]) == 4*[0]


def test_tubes_in_any_direction(tmp_path):
    """A sphere that goes straight along (1 2 2)/3 in 3D, 0.1 beside the axis
    of a tube; one plane across it, one askew, one with another tube's axis."""
    along, across = np.array([1, 2, 2])/3, np.array([2, 1, -2])/3
    start = -0.4*along + 0.1*across
    case = BodyCase("box", tmp_path)
    case.mesh(*3*[uniform(-1, 1, 20)])
    case.bodies(f"""
        sphere
        {{
            shape       {{ type sphere; radius 0.25; }}
            position    ({" ".join(map(repr, start.tolist()))});
            motion      {{ type prescribed; velocity (1 2 2); }}
        }}
    """)
    tube = "axis (1 2 2); centre (0 0 0); zeroAngle (2 1 -2);"
    add_sensor(case, f"""
        straight {{ point (0 0 0); normal (1 2 2); {tube} radius 0.2; }}
        turned   {{ point (0 0 0); normal (1 2 2); {tube}
                    zeroAngle (2 -2 1); }}
        askew    {{ point (0 0 0); normal (0 0 1); {tube} }}
        beside   {{ point (0 0 0); normal (1 2 2); centre (1 -1 0.5);
                    radius 0.5; }}
    """)
    case.controls(endTime="0.3", deltaT="0.03")
    case.solve()

    rows = {r.plane: r for r in passages(case)}
    assert sorted(rows) == ["askew", "straight", "turned"]
    for plane, time, angle in (
        ("straight", 0.4/3, 0), ("turned", 0.4/3, 90),
        ("askew", -start[2]/2, 0),
    ):
        r = rows[plane]
        assert r.time == pytest.approx(time, abs=1e-12)
        assert r.radius == pytest.approx(0.1, abs=1e-12)
        assert abs(r.angle) == pytest.approx(angle, abs=1e-6)
        assert r.axial == pytest.approx(3, abs=1e-12)
        assert r.velocity == pytest.approx([1, 2, 2], abs=1e-12)


def test_a_comoving_window_sees_the_laboratory(tube, tmp_path):
    case = BodyCase(tube, tmp_path)
    case.bodies(
        f"disc {{ {ACCELERATED} position (-2 0.5 0); }}",
        "window { type comoving; direction (1 0 0); }",
    )
    add_sensor(case, PLANES)
    log = case.solve()

    assert "window: comoving" in log
    motion = case.table("motion")
    assert np.ptp(motion["windowPosition_x"]) < 0.01
    assert [(r.plane, r.time) for r in passages(case)] == [
        ("first", pytest.approx(reaches(-1.9), abs=1e-12)),
        ("second", pytest.approx(reaches(-1.5), abs=1e-12)),
        ("turned", pytest.approx(reaches(-1.5), abs=1e-12)),
        ("askew", pytest.approx((-0.75 + math.sqrt(2.5625))/2, abs=1e-12)),
    ]


@pytest.mark.parametrize("ranks", [1, 2])
def test_each_time_that_a_body_comes_round(ranks, tmp_path):
    """The period is 2: no plane is passed twice, nor when it is wrapped."""
    case = periodic_tube(tmp_path, "case", 10, speed=1)
    case.bodies("""
        disc
        {
            shape       { type disc; radius 0.2; }
            position    (1.33 0.1 0);
            motion      { type prescribed; velocity (-3 0 0); }
        }
    """)
    add_sensor(case, """
        ends   { point (0 0 0); normal (1 0 0); }
        again  { point (2 0 0); normal (1 0 0); }
        middle { point (0.7 0 0); normal (1 0 0); }
    """)
    case.controls(endTime="2", deltaT="0.04")
    case.solve(ranks)

    for plane, x in (("ends", 0), ("again", 0), ("middle", 0.7)):
        expected = np.arange((1.33 - x)/3, 2, 2/3)
        found = passages(case, plane)
        assert [r.time for r in found] == pytest.approx(expected, abs=1e-9)
        assert [r.radius for r in found] == pytest.approx(
            len(found)*[0.1], abs=1e-9
        )
        assert {r.direction for r in found} == {-1}
        assert {r.name for r in found} == {"disc"}


def test_the_last_step_of_a_body_counts_and_a_leap_does_not(tmp_path):
    """It is taken out in the step in which it has passed some of the planes,
    and begins again upstream of all of them."""
    planes = [LENGTH + 0.15 + 0.001*k for k in range(120)]
    case = open_tube(tmp_path)
    case.bodies(f"""
        disc
        {{
            {DISC}
            position    (3.6 0.3 0);
            motion      {{ type prescribed; velocity (1.5 0 0); }}
        }}
    """, "leaving { outlet { type reinject; shift (-3 0 0); } }")
    add_sensor(case, "upstream { point (2.5 0 0); normal (1 0 0); }" + "".join(
        f"x{k} {{ point ({x} 0 0); normal (1 0 0); }}\n"
        for k, x in enumerate(planes)
    ))
    case.controls(endTime="0.7")
    case.solve()

    leaves, enters = passage(case)
    assert (leaves.what, enters.what) == ("leaves", "enters")
    assert leaves.time == enters.time < 0.6
    end = leaves.position[0]
    before = end - 1.5*DT
    assert sum(before < x < end for x in planes) > 5

    rows = passages(case)
    expected = [x for x in planes if x < end]
    assert 5 < len(expected) < len(planes)
    assert [r.time for r in rows] == pytest.approx(
        [(x - 3.6)/1.5 for x in expected], abs=1e-9
    )
