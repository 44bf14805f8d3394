# SPDX-License-Identifier: GPL-3.0-or-later
"""Walls that move along themselves and are of different materials, in a fluid
so light that closed forms hold."""

import numpy as np
import pytest

import boxMesh
import refusals
import roundTube
from bodyCase import BodyCase
from boxMesh import uniform
from contactCase import conditions

RATIO = 1e6
SIDES = {"wallBelt": "y-", "walls": "x- x+ y+ z- z+"}


def box(folder, belt, name=None):
    """A box whose bottom is the belt."""
    case = BodyCase("box", folder, name)
    side = uniform(-0.75, 0.75, 12)
    boxMesh.write(case, side, side, side, SIDES)
    conditions(case, {"wallBelt": belt, "walls": "type noSlip;"})
    case.run("blockMesh")
    return case


def ball(**entries):
    """Entry of a sphere."""
    given = {
        "shape": "{ type sphere; radius 0.25; }", "densityRatio": RATIO,
        **entries,
    }
    text = " ".join(
        f"{key} {value}" + ("" if "{" in str(value) else ";")
        for key, value in given.items()
    )
    return f"ball {{ {text} }}"


BELTS = {
    "fixedValue": "type fixedValue; value uniform (0.3 0 0);",
    "uniformFixedValue": "type uniformFixedValue;"
                         " uniformValue constant (0.3 0 0);",
    "robinVelocity": "type robinVelocity; slipLength 0.1;"
                     " wallVelocity uniform (0.3 0 0);",
}


@pytest.mark.parametrize("kind, ranks", [
    ("fixedValue", 1), ("fixedValue", 2), ("uniformFixedValue", 1),
    ("robinVelocity", 1),
])
def test_ball_on_a_belt_slides_until_it_rolls(kind, ranks, tmp_path):
    case = box(tmp_path, BELTS[kind])
    case.gravity(y=-10)
    case.bodies(
        ball(position="(0 -0.5 0)"),
        "contact { type softSphere; restitution 0.5; friction 0.3;"
        " collisionTime 0.004; }",
    )
    # It sticks after 2/7 V/(mu g)
    sticks = 2/7*0.3/(0.3*10)
    case.controls(endTime=2*sticks, deltaT=sticks/10)
    if ranks > 1:
        case.decompose(ranks)
    case.solve(ranks)

    motion = case.table("motion")
    sliding = motion["velocity_x"][4]
    assert sliding == pytest.approx(0.3*10*motion["time"][4], rel=0.01)
    assert motion["velocity_x"][-1] == pytest.approx(2/7*0.3, rel=0.01)
    assert motion["angularVelocity_z"][-1]*0.25 == pytest.approx(
        5/7*0.3, rel=0.01
    )


def test_restart_on_a_belt_is_exact(tmp_path):
    def start(name, **entries):
        case = box(tmp_path, BELTS["robinVelocity"], name)
        case.bodies(
            ball(velocity="(0 -5 0.5)", position="(0 -0.48 0)",
                 material="grain"),
            MATERIALS.replace("friction 0;", "friction 0.3;"),
        )
        case.controls(
            deltaT=0.0025, writeControl="timeStep", writeInterval=4,
            writePrecision=17, timePrecision=15, **entries
        )
        return case

    case = start("once", endTime=0.03)
    case.solve()
    parts = start("parts", endTime=0.01)
    parts.solve()
    state = (parts.path/"0.01/uniform/immersedBodies").read_text()
    assert "springContacts ( (" in " ".join(state.split())
    parts.controls(endTime=0.03)
    parts.solve()

    for file in ("U", "p", "uniform/immersedBodies"):
        expected = (case.path/case.latest_time()/file).read_bytes()
        assert (parts.path/parts.latest_time()/file).read_bytes() == expected


def test_impact_on_the_wall_of_a_drum(tmp_path):
    case = BodyCase("tube", tmp_path)
    roundTube.write(case, uniform(-0.6, 0.6, 8), 0.15)
    conditions(case, {
        ".*": "type noSlip;",
        "walls?": "type rotatingWallVelocity; origin (0 0 0); axis (1 0 0);"
                  " omega constant 5;",
    })
    case.run("blockMesh")
    # In the middle of one of the 32 faces round the tube
    out = np.array([0, np.cos(np.pi/32), np.sin(np.pi/32)])
    along = np.array([0, -out[2], out[1]])
    radius, e, mu, dt = 0.3, 0.88, 0.25, 0.002
    case.bodies(
        f"ball {{ shape {{ type sphere; radius {radius}; }} densityRatio"
        f" {RATIO}; position (0 {0.68*out[1]} {0.68*out[2]});"
        f" velocity (0 {out[1]} {out[2]}); }}",
        f"contact {{ type softSphere; restitution {e}; friction {mu};"
        " collisionTime 0.004; }",
    )
    case.controls(endTime=15*dt, deltaT=dt)
    case.solve()

    motion = case.table("motion")
    end = np.array([motion[f"velocity_{c}"][-1] for c in "xyz"])
    slid = mu*(1 + e)
    assert end @ out == pytest.approx(-e, rel=0.01)
    assert end @ along == pytest.approx(slid, rel=0.01)
    assert motion["angularVelocity_x"][-1] == pytest.approx(
        2.5*slid/radius, rel=0.01
    )


def runs_round(folder, dt, ranks=1, parts=None):
    """Velocities of a grain that runs round in a tube of 16 sides."""
    case = BodyCase("tube", folder, f"tube{ranks}")
    roundTube.write(case, uniform(-1, 1, 4), 0.3)
    conditions(case, {".*": "type noSlip;"})
    case.run("blockMesh")
    case.bodies(
        f"grain {{ shape {{ type sphere; radius 0.06; }} densityRatio {RATIO};"
        " position (0.1 -0.9 0); velocity (0 0 1); }",
        "coupling { type unresolved; fluid frozen; } contact { type softSphere;"
        " restitution 0.9; friction 0; collisionTime 0.02; subSteps 20; }",
    )
    case.controls(endTime=20, deltaT=dt)
    case.solve(ranks, parts)
    motion = case.table("motion")
    return np.array([motion[f"velocity_{c}"] for c in "xyz"])


@pytest.mark.parametrize("dt", (0.05, 0.2))
def test_a_grain_that_runs_round_in_a_tube_of_few_sides(dt, tmp_path):
    # Half a side to one and a half in a time step: where the smooth wall is may
    # not depend on how far the grain goes
    speed = np.linalg.norm(runs_round(tmp_path, dt), axis=0)
    assert max(speed) < 1.002
    assert speed[-1] == pytest.approx(0.95, abs=0.05)


def test_a_tube_is_as_smooth_where_processors_meet(tmp_path):
    one = runs_round(tmp_path, 0.2)
    four = runs_round(tmp_path, 0.2, 4, (1, 2, 2))
    assert four == pytest.approx(one, abs=1e-6)


MATERIALS = (
    "contact { type softSphere; restitution 0.9; friction 0;"
    " pairs { grain-steel { restitution 0.5; } grain-rubber { restitution"
    " 0.3; } } walls { wallBelt steel; \"wall.*\" rubber; } }"
)


@pytest.mark.parametrize("material, direction, ranks, e", [
    ("grain", "(0 -5 0)", 1, 0.5), ("grain", "(0 5 0)", 1, 0.3),
    ("grain", "(0 5 0)", 2, 0.3), ("steel", "(0 -5 0)", 1, 0.9),
    (None, "(0 -5 0)", 1, 0.9),
])
def test_walls_have_materials(material, direction, ranks, e, tmp_path):
    case = box(tmp_path, "type noSlip;")
    own = {"material": material} if material else {}
    # Four of the cells' walls are on either rank
    case.bodies(ball(velocity=direction, position="(0 0 0)", **own), MATERIALS)
    case.controls(endTime=0.15, deltaT=0.005)
    if ranks > 1:
        case.decompose(ranks)
    case.solve(ranks)
    speed = abs(case.table("motion")["velocity_y"][-1])
    assert speed == pytest.approx(5*e, rel=0.02)


def test_a_slip_in_the_name_of_a_material_is_warned_of(tmp_path):
    log = {}
    for pair in ("grain-glass", "grain-rubbre", "grian-steel"):
        case = box(tmp_path, "type noSlip;", pair)
        case.bodies(
            ball(material="grain", position="(0 0 0)"),
            MATERIALS.replace("pairs {", f"pairs {{ {pair} {{ }}"),
        )
        log[pair] = case.run("foamRun", "-check")
    assert "No body and no wall is of" not in log["grain-glass"]
    for pair, (wrong, right) in {
        "grain-rubbre": ("rubbre", "rubber"), "grian-steel": ("grian", "grain"),
    }.items():
        assert log[pair].count("No body and no wall is of") == 1
        assert f"'{wrong}' in 'pairs': is it '{right}'?" in log[pair]
        assert "immersedBodyProperties" in log[pair]


WRONG = [
    ("material grain", "material grian", ["grian", "nearest", "'grain'"]),
    ("wallBelt steel", "wallBel steel",
     ["'walls wallBel'", "nearest", "'wallBelt'"]),
    ("wallBelt steel", "wallBelt stel", ["stel", "nearest", "'steel'"]),
]


@pytest.fixture(scope="module")
def refused(tmp_path_factory):
    folder = tmp_path_factory.mktemp("refused")
    case = box(folder, "type noSlip;", "right")
    case.bodies(ball(material="grain", position="(0 0 0)"), MATERIALS)
    return refusals.of_copies(case, folder, {
        new: lambda case, old=old, new=new: case.replace(
            "constant/immersedBodyProperties", old, new
        )
        for old, new, _ in WRONG
    })


@pytest.mark.fast
@pytest.mark.parametrize("new, expected", [wrong[1:] for wrong in WRONG])
def test_unknown_materials_are_refused(new, expected, refused):
    refused[new].names(*expected)
