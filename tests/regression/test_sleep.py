# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that have settled sleep, and wake when they must."""

import re
import shutil

import numpy as np
import pytest

import boxMesh
import refusals
from bodyCase import BodyCase
from boxMesh import uniform
from contactCase import box2d, conditions, contact, discs
from spreadRuns import run_in_parts, write_twice

G = 10
SLEEP = "sleep { speed 0.03; }"
EXACT = {
    "deltaT": 1/128, "writeControl": "timeStep", "writeInterval": 64,
    "writePrecision": 17, "timePrecision": 15,
}


def settling(folder, bodies, more=SLEEP, name=None, end=1, n=20):
    """Heavy bodies in a box, gravity downwards."""
    case = box2d(folder, n, name)
    case.gravity(y=-G)
    case.bodies(bodies, contact(e=0.3) + more)
    case.controls(endTime=end, deltaT=0.005)
    return case


def progress(case):
    """Bodies asleep and outer iterations of each step."""
    lines = re.findall(
        r"bodies \d+(?: \((\d+) asleep\))?, outer iterations (\d+)",
        (case.path/"log.foamRun").read_text(),
    )
    return [(int(asleep or 0), int(outer)) for asleep, outer in lines]


# Half the length of a box for many
LONG = 16


# Four side by side from wall to wall, and one on them
HEAP = discs(
    [(-0.75, -0.74), (-0.25, -0.74), (0.25, -0.74), (0.75, -0.74), (0, -0.3)],
    radius=0.249, ratio=1000,
)


@pytest.fixture(scope="module")
def heap(tmp_path_factory):
    """A heap that falls asleep."""
    case = settling(tmp_path_factory.mktemp("heap"), HEAP)
    case.controls(**EXACT)
    case.solve()
    return case


def fresh(case, folder):
    """A copy that has not been run."""
    copy = BodyCase(case, folder)
    for time in copy.path.glob("[0-9]*"):
        if time.name != "0":
            shutil.rmtree(time)
    shutil.rmtree(copy.path/"postProcessing")
    return copy


def test_heap_falls_asleep_where_it_is(heap, tmp_path):
    awake = fresh(heap, tmp_path)
    awake.replace("constant/immersedBodyProperties", SLEEP, "")
    awake.solve()

    asleep, outers = zip(*progress(heap))
    assert asleep[-1] == 5 and not progress(awake)[-1][0]
    assert outers[-1] == 1

    for body in range(5):
        for key in ("position_x", "position_y"):
            assert heap.table("motion", body)[key][-1] == pytest.approx(
                awake.table("motion", body)[key][-1], abs=2e-3*0.5
            )


def test_sleep_survives_a_restart(heap, tmp_path):
    parts = fresh(heap, tmp_path)
    assert progress(heap)[63][0] > 0
    parts.controls(endTime=0.5)
    parts.solve()
    parts.controls(endTime=1)
    parts.solve()

    for file in ("U", "p", "uniform/immersedBodies"):
        expected = (heap.path/heap.latest_time()/file).read_bytes()
        assert (parts.path/parts.latest_time()/file).read_bytes() == expected


def test_sleep_is_the_same_on_two_ranks(heap, tmp_path):
    ranks = fresh(heap, tmp_path)
    ranks.solve(ranks=2)

    assert progress(ranks)[-1] == progress(heap)[-1]
    for body in range(5):
        assert ranks.table("motion", body)["position_y"][-1] == pytest.approx(
            heap.table("motion", body)["position_y"][-1], abs=1e-4
        )


def long_heap(folder):
    """A row of discs from wall to wall, so many that they are spread over four
    ranks. Others lie on it, or fall on it when it sleeps."""
    case = settling(folder, HEAP)
    boxMesh.write(
        case, uniform(-LONG, LONG, 20*LONG), uniform(-1, 1, 20), None,
        {"walls": "x- x+ y- y+"},
    )
    case.run("blockMesh")
    places = [(i/2 + 0.25 - LONG, -0.74) for i in range(4*LONG)]
    places += [(4*i - LONG + 1, -0.3) for i in range(LONG//2)]
    at_rest = [(0, 0)]*len(places)
    places += [(4*i - LONG + 3.1, 0.7) for i in range(LONG//2)]
    case.bodies(
        discs(places, 0.249, at_rest + [(0, 3.5)]*(LONG//2), ratio=1000),
        contact(e=0.3) + SLEEP,
    )
    write_twice(case, 0.005, 240)
    return case


def test_sleep_is_the_same_where_bodies_are_spread(tmp_path):
    one = long_heap(tmp_path)
    four = BodyCase(one, tmp_path, "four")
    one.solve()
    assert "Bodies are spread over the ranks: 80" in four.solve(4, (4, 1, 1))

    asleep, on_four = (np.array(progress(case)) for case in (one, four))
    # Many wake, and sleep again
    assert asleep[:, 0].max() > 50
    assert (np.diff(asleep[:, 0]) < -1).any()
    assert (asleep[:, 0] == on_four[:, 0]).mean() > 0.99
    end, as_near = (
        case.columns("motion")["position_y"][-80:] for case in (one, four)
    )
    assert as_near == pytest.approx(end, abs=1e-4)


@pytest.mark.nightly
def test_restart_is_exact_where_bodies_are_spread(tmp_path):
    at_once = long_heap(tmp_path)
    parts = run_in_parts(at_once, tmp_path, 0.005, 240, (4, 1, 1))

    half = progress(at_once)[120:]
    assert max(asleep for asleep, _ in half) > 20
    assert progress(parts) == half
    a, b = (case.columns("motion")["position_y"] for case in (at_once, parts))
    assert np.max(np.abs(a - b)) < 1e-10


def test_what_falls_on_a_sleeper_wakes_it(tmp_path):
    # The upper one comes when the lower one sleeps, and hits its side
    bodies = discs(
        [(0, -0.75), (0.2, 0.7)], radius=0.25, ratio=1000,
        velocities=[(0, 0), (0, 2)],
    )
    case = settling(tmp_path, bodies)
    awake = BodyCase(case, tmp_path, "awake")
    awake.replace("constant/immersedBodyProperties", SLEEP, "")
    case.solve()
    awake.solve()

    asleep = [n for n, _ in progress(case)]
    woken = next(i for i, n in enumerate(asleep) if asleep[i - 1] and not n)
    gap = abs(
        case.table("motion", 1)["position_y"][woken]
        - case.table("motion", 0)["position_y"][woken]
    ) - 0.5
    assert max(asleep[:woken]) == 1 and gap < 0.3
    # Awake it has begun to roll before, in the flow ahead of the other
    spin, spin_awake = (
        run.table("motion", 0)["angularVelocity_z"] for run in (case, awake)
    )
    assert spin[woken + 20] == pytest.approx(
        spin_awake[woken + 20] - spin_awake[woken - 1], rel=0.01
    )


def test_sleeper_wakes_when_its_support_goes(tmp_path):
    plate = (
        "plate { shape { type box; size (1 0.5 1); } position (0 -0.5 0);"
        " motion { type prescribed; velocity"
        " table ((0 (0 0 0)) (0.4 (0 0 0)) (0.401 (1 0 0))); } }\n"
    )
    case = settling(
        tmp_path,
        plate + discs([(-0.1, 0.002)], radius=0.25, ratio=1000), end=0.6,
    )
    case.solve()

    asleep = [n for n, _ in progress(case)]
    steps = [i for i, n in enumerate(asleep) if n]
    assert steps and steps[-1] in (79, 80, 81)
    # Friction takes it along
    assert case.table("motion", 1)["velocity_x"][-1] > 0.05


@pytest.mark.parametrize("ranks", [1, 2])
def test_sleeper_wakes_when_its_belt_starts(ranks, tmp_path):
    case = settling(
        tmp_path, discs([(0.3, -0.748)], radius=0.25, ratio=1000), end=0.6
    )
    boxMesh.write(
        case, uniform(-1, 1, 20), uniform(-1, 1, 20), None,
        {"wallBelt": "y-", "walls": "x- x+ y+"},
    )
    conditions(case, {
        "wallBelt": "type uniformFixedValue; uniformValue"
                    " table ((0 (0 0 0)) (0.4 (0 0 0)) (0.401 (-1 0 0)));",
        "walls": "type noSlip;", "frontAndBack": "type empty;",
    })
    case.run("blockMesh")
    case.solve(ranks)

    asleep = [n for n, _ in progress(case)]
    steps = [i for i, n in enumerate(asleep) if n]
    assert steps and steps[-1] in (79, 80, 81)
    assert case.table("motion")["velocity_x"][-1] < -0.05


def test_sleeper_wakes_when_the_fluid_pushes(tmp_path):
    case = settling(
        tmp_path, discs([(0, -0.75)], radius=0.25, ratio=1.5), end=0.8
    )
    (case.path/"constant/fvOptions").write_text(
        "FoamFile { version 2.0; format ascii; class dictionary;"
        " object fvOptions; }\n"
        "push { type vectorSemiImplicitSource; timeStart 0.4; duration 9;"
        " selectionMode points; points ((-0.55 -0.75 0)); volumeMode absolute;"
        " injectionRateSuSp { U ((0.5 0 0) 0); } }\n"
    )
    case.solve()

    asleep = [n for n, _ in progress(case)]
    steps = [i for i, n in enumerate(asleep) if n]
    assert steps and 78 <= steps[-1] < 100
    assert case.table("motion")["velocity_x"][-1] > 0.01


WRONG = {
    "sleep { sped 0.03; }": ["'sleep' has no entry 'speed'", "'sped'"],
    "sleep { speed -1; }": ["'speed -1'", "greater than 0"],
    "sleep { speed 0.03; step 3; }": [
        "'step'", "nearest valid one is 'steps'"
    ],
    "contact { type none; } sleep { speed 0.03; }": [
        "'sleep'", "needs 'contact'"
    ],
}


@pytest.fixture(scope="module")
def refused(tmp_path_factory):
    folder = tmp_path_factory.mktemp("refused")
    disc = discs([(0, -0.5)], radius=0.25)

    def change(entries):
        own = "" if "contact" in entries else contact(e=0.3)
        return lambda case: case.bodies(disc, own + entries)

    return refusals.of_copies(
        settling(folder, disc), folder,
        {entries: change(entries) for entries in WRONG},
    )


@pytest.mark.fast
@pytest.mark.parametrize("entries", WRONG)
def test_wrong_entries_are_refused(entries, refused):
    refused[entries].names(*WRONG[entries])
