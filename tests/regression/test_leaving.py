# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that leave the mesh, by each of the rules."""

import numpy as np
import pytest

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform
from foamCase import FoamError
from openTube import DISC, DT, H, LENGTH, RADIUS, open_tube, passage, flow_rate

REMOVE = 'leaving { "out.*" { type remove; } }'
ONE = f"disc {{ {DISC} position (3.3 0.3 0); velocity ambient; }}"
NOTHING = f"""injection
{{
    none {{ {DISC} times (1e3); position (1 0 0); }}
}}"""


@pytest.fixture(scope="module")
def tubes(tmp_path_factory):
    folder = tmp_path_factory.mktemp("leaving")
    return {
        driven: open_tube(folder, driven, driven)
        for driven in ("rate", "pressure")
    }


def run(tube, folder, bodies, before, end, name="case"):
    case = BodyCase(tube, folder, name)
    case.bodies(bodies, before)
    case.controls(
        endTime=str(end), writeInterval=str(end),
        writeFormat="ascii", writePrecision="12",
    )
    case.log = case.solve()
    return case


def test_a_row_leaves_one_by_one(tubes, tmp_path):
    """The flow goes on without a jump, and without bodies as if there had
    been none."""
    case = run(tubes["pressure"], tmp_path, f"""
        row
        {{
            {DISC}
            positions ((1.9 0.2 0) (2.6 0.2 0) (3.3 0.2 0));
            velocity ambient;
        }}
    """, REMOVE, 6)
    events = passage(case)

    assert [(e.name, e.what, e.where) for e in events] == [
        (f"row{i}", "leaves", "outlet") for i in (3, 2, 1)
    ]
    assert [e.number for e in events] == [2, 1, 0]
    for e in events:
        assert case.log.count(f"Body {e.name} leaves: outlet") == 1
        assert LENGTH + RADIUS - H < e.position[0] < LENGTH + RADIUS + H
        assert 1.2 < e.velocity[0] < 1.5

        # As long as it is there it has rows, and with the velocities that it
        # had when it touched the outlet
        motion = case.table("motion", e.number)
        assert motion["time"][-1] == pytest.approx(e.time - DT)
        passing = motion["position_x"] > LENGTH - RADIUS + 2*H
        assert np.ptp(motion["velocity_x"][passing]) < 1e-12
        assert motion["velocity_x"][-1] == pytest.approx(e.velocity[0])

    # Steps in the flow rate [of 2] are those of bodies that move
    time, rate = flow_rate(case)
    steps = np.abs(np.diff(rate[2:]))/rate[2:-1]
    assert time[-1] == pytest.approx(6)
    assert steps.max() < 2e-3

    empty = run(tubes["pressure"], tmp_path, "", NOTHING, 6, "empty")
    assert "Immersed bodies: 0 2D" in empty.log
    assert rate[-1] == pytest.approx(flow_rate(empty)[1][-1], rel=1e-3)
    U, undisturbed = case.field("U"), empty.field("U")
    assert np.abs(U - undisturbed).max() < 2e-3*undisturbed.max()


def test_the_last_body_is_gone_for_good(tubes, tmp_path):
    """Restarted after it has left, and with a window that it would lead."""
    case = run(tubes["rate"], tmp_path, ONE, REMOVE + """
        window { type comoving; direction (1 0 0); follow disc; velocity 0; }
    """, 1)
    (event,) = passage(case)

    case.controls(endTime="1.1")
    log = case.solve()
    assert "Immersed bodies: 0 2D" in log and "Time = 1.1\n" in log
    after = case.table_files("motion")[-1].read_text().splitlines()
    assert all(line.startswith("#") for line in after)
    assert case.log.count("leaves") == 1 and event.name == "disc"


def test_held_bodies_stay_in_the_fluid(tubes, tmp_path):
    case = run(
        tubes["rate"], tmp_path, ONE, "leaving { default { type hold; } }", 1
    )
    (event,) = passage(case)
    assert (event.what, event.where) == ("held", "outlet")

    motion = case.table("motion")
    after = motion["time"] > event.time - 1e-9
    assert set(motion["position_x"][after]) == {motion["position_x"][-1]}
    assert not motion["velocity_x"][after].any()
    assert motion["velocity_x"][~after].min() > 1.2
    assert LENGTH - RADIUS < motion["position_x"][-1] < LENGTH - RADIUS + 0.5*H

    # The flow pushes it as it does a fixed body
    assert case.table("forces")["fluidForce_x"][-1] > 0.5


@pytest.mark.parametrize("rule, start, speed", [
    ("shift (-3.2 0 0);", 1.05, None),
    ("position (1 -0.2 0); velocity ambient;", 1, 1.4),
])
def test_bodies_enter_again(rule, start, speed, tubes, tmp_path):
    case = run(
        tubes["rate"], tmp_path, ONE,
        f"leaving {{ outlet {{ type reinject; {rule} }} }}", 1.2,
    )
    left, entered = passage(case)
    assert [left.what, entered.what] == ["leaves", "enters"]
    assert entered.time == left.time
    assert entered.number == left.number == 0
    assert entered.position[0] == pytest.approx(start, abs=0.1)
    assert entered.velocity[0] == pytest.approx(
        speed or left.velocity[0], rel=0.02
    )

    # One table row per step throughout
    motion = case.table("motion")
    assert len(motion["time"]) == 60
    assert motion["position_x"][-1] > entered.position[0] + 0.3


def test_a_body_waits_until_there_is_room(tubes, tmp_path):
    """Another one has to pass the place first."""
    case = run(
        tubes["rate"], tmp_path,
        ONE + f"other {{ {DISC} position (0.6 0 0); velocity ambient; }}",
        "leaving { outlet { type reinject; position (1.6 0 0); } }", 1.4,
    )
    left, entered = passage(case)
    assert left.name == entered.name == "disc"
    assert entered.time > left.time + 5*DT
    other = case.table("motion", 1)
    x = other["position_x"][np.searchsorted(other["time"], entered.time - 1e-9)]
    assert 2*RADIUS + H <= x - 1.6 < 2*RADIUS + H + 1.5*DT


@pytest.mark.parametrize("leaving", ["", "leaving { outlet { type stop; } }"])
@pytest.mark.parametrize("ratio", [2, 1000])
def test_no_body_leaves_silently(ratio, leaving, tubes, tmp_path):
    with pytest.raises(FoamError, match="a body has left the mesh"):
        run(
            tubes["rate"], tmp_path,
            ONE.replace("Ratio 2", f"Ratio {ratio}"), leaving, 1,
        )
    assert not list((tmp_path / "case").glob("postProcessing/immersedBodies"))


def test_bodies_leave_a_window_at_both_ends(tubes, tmp_path):
    case = run(tubes["rate"], tmp_path, f"""
        fast {{ {DISC} position (3.7 0 0); velocity ambient; }}
        slow {{ {DISC} position (0.4 0.6 0); velocity ambient; }}
    """, """
        leaving { ".*let" { type remove; } }
        window { type comoving; direction (1 0 0); velocity 1.2; }
    """, 3)
    slow, fast = passage(case)
    assert (slow.name, slow.where) == ("slow", "inlet")
    assert (fast.name, fast.where) == ("fast", "outlet")

    # Positions are those of the laboratory
    assert fast.position[0] == pytest.approx(
        LENGTH + RADIUS + 1.2*fast.time, abs=H
    )
    assert slow.position[0] == pytest.approx(
        -RADIUS + 1.2*slow.time, abs=H
    )


def test_an_unresolved_grain_feels_walls_until_it_has_left(tmp_path):
    """It touches the outlet, along which it moves from wall to wall."""
    case = BodyCase("box", tmp_path)
    case.conditions(
        "walls { type noSlip; } outlet { type zeroGradient; }",
        "walls { type zeroGradient; } "
        "outlet { type fixedValue; value uniform 0; }",
    )
    boxMesh.write(
        case, uniform(0, 1, 5), uniform(0, 1, 5), uniform(0, 1, 5),
        {"outlet": "x+", "walls": "x- y- y+ z- z+"},
    )
    case.run("blockMesh")
    case.bodies("""
        grain
        {
            shape { type sphere; radius 0.02; }
            densityRatio 1e5;
            position (0.985 0.5 0.5);
            velocity (0.01 1 0);
        }
    """, REMOVE + """
        coupling { type unresolved; }
        contact { type softSphere; restitution 1; friction 0; }
    """)
    case.controls(endTime=2)
    case.solve()

    (event,) = passage(case)
    assert (event.what, event.where) == ("leaves", "outlet")
    assert 1 < event.position[0] < 1.001
    assert event.time == pytest.approx(1.5, abs=0.1)

    # Up, back, and up again
    y = case.table("motion")["position_y"]
    assert y.max() == pytest.approx(0.98, abs=0.01)
    assert y.min() == pytest.approx(0.02, abs=0.01)
