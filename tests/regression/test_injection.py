# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that enter, by all kinds of injectors."""

import json
import math

import numpy as np
import pytest

from bodyCase import BodyCase
from openTube import DISC, DT, H, RADIUS, flow_rate, open_tube, passage

LEAVING = "leaving { outlet { type remove; } }"
RANDOM = f"""
    grains
    {{
        shape       {{ type disc; radius 0.2; }}
        size
        {{
            type uniform;
            uniformDistribution {{ minValue 0.8; maxValue 1.2; }}
        }}
        densityRatio
        {{
            type uniform;
            uniformDistribution {{ minValue 2; maxValue 10; }}
        }}
        patch       {{ name inlet; gap 0.1; }}
        rate        4;
        intervals   random;
        seed        3;
        orientation random;
    }}
"""
SURFACES = """functions
{
    surfaces
    {
        type            immersedBodySurfaces;
        libs            (immersedBodyFunctionObjects);
        writeControl    timeStep;
        writeInterval   10;
    }"""


@pytest.fixture(scope="module")
def tubes(tmp_path_factory):
    folder = tmp_path_factory.mktemp("injection")
    return {
        driven: open_tube(folder, driven, driven)
        for driven in ("rate", "pressure")
    }


def prepare(tube, folder, injection, end, name="case", bodies=""):
    case = BodyCase(tube, folder, name)
    case.bodies(bodies, f"injection\n{{\n{injection}\n}}\n{LEAVING}")
    case.controls(endTime=str(end))
    return case


def set_pcg(case):
    """Sends few messages: there may be fewer cores than ranks."""
    for old, new in (
        ("GAMG;", "PCG;"),
        ("smoother        GaussSeidel", "preconditioner  DIC"),
    ):
        case.replace("system/fvSolution", old, new)


def entries(case):
    return [e for e in passage(case) if e.what == "enters"]


def test_regular_injection(tubes, tmp_path):
    """At the first time step at or after start + k/rate."""
    case = prepare(tubes["rate"], tmp_path, f"""
        seeds
        {{
            {DISC}
            positions   ((0.6 0.2 0) (0.6 -0.2 0));
            rate        2;
            start       0.11;
            number      4;
        }}
    """, 2.4)
    case.replace("system/controlDict", "functions\n{", SURFACES)
    case.solve()
    events = entries(case)

    due = 0.11 + 0.5*np.arange(4)
    steps = DT*np.ceil(due/DT - 1e-6)
    assert [e.name for e in events] == [f"seeds{k}" for k in (1, 2, 3, 4)]
    assert [e.time for e in events] == pytest.approx(steps)
    assert [e.position[1] for e in events] == [0.2, -0.2, 0.2, -0.2]

    # With the mean velocity of the fluid displaced: that of the parabola
    # less 1.5 R^2/4
    mean = 1.5*(1 - 0.2**2 - RADIUS**2/4)
    assert events[0].velocity[0] == pytest.approx(mean, rel=0.01)
    assert events[0].spin[2] == pytest.approx(1.5*0.2, rel=0.02)

    # Rows from then on, with the name before the first
    (file,) = case.table_files("motion")
    text = file.read_text()
    for e in events:
        assert case.table("motion", e.number)["time"][0] \
            == pytest.approx(e.time + DT, abs=DT + 1e-9)
        assert text.count(e.name) == 1

    # The series has all times, those without bodies too
    folder = case.path / "postProcessing/surfaces"
    series = json.loads((folder / "bodies.vtp.series").read_text())["files"]
    assert len(series) == 13
    for entry in series:
        n = sum(e.time < entry["time"] + 1e-9 for e in events)
        assert f"NumberOfVerts='{n}'" in (folder / entry["name"]).read_text()


def test_entering_hardly_disturbs_the_flow(tubes, tmp_path):
    """Driven by a pressure, the flow rate changes by less than 0.1 % in the
    step and by less than 1 % later, as it does with bodies in it."""
    case = prepare(tubes["pressure"], tmp_path, f"""
        one {{ {DISC} position (1 0.3 0); times (0.6); }}
    """, 1)
    case.solve()
    time, rate = flow_rate(case)
    k = np.searchsorted(time, 0.6 + 1e-9)
    steps = np.abs(np.diff(rate))/rate[k]
    assert steps[k - 1] < 1e-3
    assert steps[k:].max() < 1e-3
    assert np.ptp(rate[k - 1:]) < 1e-2*rate[k]


def test_random_injection(tubes, tmp_path):
    cases = [
        prepare(tubes["rate"], tmp_path, injection, 1.2, name)
        for name, injection in (
            ("first", RANDOM), ("again", RANDOM),
            ("other", RANDOM.replace("seed        3", "seed 4")),
        )
    ]
    tables = []
    for case in cases:
        case.solve()
        file = case.path / "postProcessing/immersedBodies/0/passage.dat"
        tables.append(file.read_text())

    assert tables[0] == tables[1] != tables[2]

    events = entries(cases[0])
    assert len(events) > 2
    radii = {e.position[0] - 0.1 for e in events}
    assert len(radii) == len(events)
    assert 0.16 <= min(radii) and max(radii) <= 0.24
    assert len({e.position[1] for e in events}) == len(events)


def test_a_body_waits_until_there_is_room(tubes, tmp_path):
    """Injected faster than they go away, at a gap of a cell."""
    case = prepare(tubes["rate"], tmp_path, f"""
        seeds {{ {DISC} position (0.6 0 0); rate 20; number 5; }}
    """, 1.6)
    log = case.solve()
    times = [e.time for e in entries(case)]
    assert len(times) > 2
    spacing = 1.45*np.diff(times)
    assert spacing.min() > 2*RADIUS + H - 1.5*DT
    assert spacing.max() < 2*RADIUS + H + 4*DT
    assert log.count("Body seeds2 waits: no room where it is to enter") == 1


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("adjust", ["no", "yes"])
def test_restart_is_exact(adjust, ranks, tubes, tmp_path):
    """While bodies enter, wait, pass the outlet and are put back."""
    at_once = prepare(tubes["rate"], tmp_path, RANDOM + f"""
        seeds {{ {DISC} position (2.7 -0.3 0); rate 10; }}
    """, 1.2, "atOnce", f"row {{ {DISC} position (3.4 0.3 0); }}")
    at_once.replace(
        "constant/immersedBodyProperties", "type remove;",
        "type reinject; shift (-2.6 0.1 0);",
    )
    at_once.controls(
        writeControl="timeStep", writeInterval="12", writePrecision="17",
        timePrecision="15", adjustTimeStep=adjust, maxCo="0.4",
    )
    if ranks > 1:
        at_once.decompose(ranks)
    in_parts = BodyCase(at_once, tmp_path, "inParts")

    at_once.solve(ranks)
    folder = "processor0" if ranks > 1 else "."
    for time in at_once.times(folder)[1:]:
        in_parts.controls(endTime=time)
        in_parts.solve(ranks)

    expected, obtained = at_once.results(ranks), in_parts.results(ranks)
    assert sorted(obtained) == sorted(expected)
    assert [f for f in expected if obtained[f] != expected[f]] == []

    kinds = {e.what for e in passage(at_once)}
    assert kinds == {"enters", "leaves"}
    assert "waits" in (at_once.path / "log.foamRun").read_text()


@pytest.mark.parametrize(
    "ranks", [2, pytest.param(4, marks=pytest.mark.nightly)]
)
def test_any_number_of_ranks_gives_the_same(ranks, tubes, tmp_path):
    cases = []
    for n in (1, ranks):
        case = prepare(
            tubes["rate"], tmp_path, RANDOM, 0.8, f"ranks{n}",
            f"row {{ {DISC} position (3.6 0.3 0); velocity ambient; }}",
        )
        set_pcg(case)
        for old, new in (
            ("1e-8", "1e-11"), ("0.01", "0"), ("1e-9", "1e-11"), ("1e-3", "0"),
        ):
            case.replace("system/fvSolution", old, new)
        case.solve(n, {4: (2, 2, 1)}.get(n))
        cases.append(passage(case))

    serial, parallel = cases
    assert len(serial) > 2
    assert [(e.time, e.number, e.what, e.name) for e in serial] == [
        (e.time, e.number, e.what, e.name) for e in parallel
    ]
    for a, b in zip(serial, parallel):
        for x, y in ((a.position, b.position), (a.velocity, b.velocity),
                     (a.spin, b.spin)):
            assert x == pytest.approx(y, abs=1e-6)


def test_a_step_after_an_entry_can_be_repeated(tmp_path):
    """A light body that is thrown in: the step that does not converge goes
    back to just after its entry."""
    case = BodyCase("tube", tmp_path)
    case.mesh([-1, (2, 40, 1)], [-1, (2, 40, 1)])
    case.replace("constant/transportProperties", "0.5;", "1e-3;")
    case.bodies("", """
        coupling { nOuterCorrectors 3; }
        injection
        {
            light
            {
                shape       { type disc; radius 0.2; }
                densityRatio 0.003;
                position    (0.013 -0.3 0);
                times       (0.05);
                velocity    (0.2 0.3 0);
                angularVelocity (0 0 2);
            }
        }
    """)
    case.controls(endTime="0.4", deltaT="0.05")
    log = case.solve()
    assert "repeated with deltaT = 0.025" in log
    (event,) = passage(case)
    motion = case.table("motion")
    assert event.number == 0
    assert motion["time"][-1] == pytest.approx(0.4)
    assert np.abs(motion["velocity_x"]).max() < 3
    assert math.isclose(motion["time"][0], 0.05)
