# SPDX-License-Identifier: GPL-3.0-or-later
"""So many bodies that each rank holds only those near to it, while some leave
the mesh and others enter it: the same on any number of ranks."""

import re

import numpy as np
import pytest

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform
from openTube import open_tube, passage
from periodicTube import direct_pressure
from sensorCase import add_sensor, passages
from spreadRuns import motions, run_in_parts, write_twice

LENGTH, STEP, STEPS = 40, 0.02, 30
CONTACT = (
    f"contact {{ type softSphere; collisionTime {STEP}; friction 0.3;"
    " largestOverlap 0.9; }"
)
# What is injected differs in size, and is larger than what there was
TRAFFIC = """
leaving
{{
    inlet  {{ type remove; }}
    outlet {{ {outlet} }}
}}
injection
{{
    grain
    {{
        shape       {{ {shape} }}
        size
        {{
            type uniform;
            uniformDistribution {{ minValue 0.8; maxValue 1.3; }}
        }}
        orientation random;
        densityRatio 3;
        region
        {{
            type box;
            min  (1 -0.02 {low});
            max  (39 0.02 {high});
        }}
        rate        50;
        seed        4;
        gap         0.05;
        {injected}
    }}
}}
"""
# In the middle of the tube, the first of them at once
AGAIN = "type reinject; position (20.1 0 0); velocity ambient;"


def deep_tube(folder, width, ratio=1):
    """A tube of square section, with a plug flow at the start. Along it the length
    of cells changes by this ratio and back, four times."""
    case = BodyCase("tube", folder, "rows")
    across = uniform(-width, width, round(10*width))
    along = [(LENGTH/8, round(5*LENGTH/8), r) for r in (ratio, 1/ratio)]
    boxMesh.write(
        case, [0, *4*along], across, across,
        {"inlet": "x-", "outlet": "x+", "walls": "y- y+ z- z+"},
    )
    case.run("blockMesh")
    case.conditions(
        "inlet { type fixedValue; value uniform (1 0 0); }"
        " outlet { type zeroGradient; } walls { type noSlip; }",
        "outlet { type fixedValue; value uniform 0; }"
        ' "inlet|walls" { type zeroGradient; }',
    )
    case.replace("0/U", "uniform (0 0 0)", "uniform (1 0 0)")
    return case


def place(case, shape, lanes, injected, outlet, apart=0.8, coupling=""):
    """Rows of bodies along a tube, some faster than others; those near to the
    inlet go against the flow."""
    direct_pressure(case)
    case.replace("constant/transportProperties", "0.5;", "0.02;")
    random = np.random.default_rng(6)
    places = np.array([
        (x, *lane) for lane in lanes for x in np.arange(0.4, LENGTH, apart)
    ])
    places[:, 0] += random.uniform(-0.1, 0.1, len(places))
    speed = random.choice((0.5, 4), len(places))
    speed[places[:, 0] < 2] = -3
    bodies = ""
    for u in (-3, 0.5, 4):
        at = " ".join(
            f"({x:.12g} {y:.12g} {z:.12g})" for x, y, z in places[speed == u]
        )
        bodies += (
            f"at{u:g}_ {{ shape {{ {shape} }} densityRatio 20;"
            f" velocity ({u} 0 0); positions ({at}); }}\n"
        )
    # Sensors at the ends, between two ranks and in the middle of one
    add_sensor(case, "\n".join(
        f"at{x} {{ point ({x} 0 0); normal (1 0 0); }}" for x in (0, 10, 25, 40)
    ))
    case.bodies(
        bodies,
        f"{CONTACT} coupling {{ resolvedFrom 2; {coupling} }}"
        + TRAFFIC.format(outlet=outlet, **injected),
    )
    write_twice(case, STEP, STEPS)
    return case


def rows(folder, outlet=AGAIN):
    """Two rows of discs, between which ellipses are injected."""
    return place(
        open_tube(folder, "rows", length=LENGTH), "type disc; radius 0.2;",
        [(-0.62, 0), (0.62, 0)], outlet=outlet, injected={
            "shape": "type ellipse; semiAxes (0.2 0.15);", "low": 0, "high": 0,
            "injected": "",
        },
    )


def events(case):
    """What happened, and where."""
    rows = passage(case)
    return (
        [(e.time, e.number, e.what, e.name, e.where) for e in rows],
        np.array([[*e.position, *e.velocity, *e.spin] for e in rows]),
    )


def check_ranks(one, several):
    what, where = events(one)
    as_what, as_where = events(several)
    assert what == as_what
    assert np.abs(as_where - where).max() < 1e-6*np.abs(where).max()
    a, b = motions(one), motions(several)
    largest = np.maximum(np.abs(a).max(axis=1, keepdims=True), 1e-6)
    assert np.max(np.abs(a - b)/largest) < 1e-6

    seen, as_good = passages(one), passages(several)
    assert [(x.plane, x.body) for x in seen] == [(x.plane, x.body) for x in as_good]
    assert {x.plane for x in seen} >= {"at0", "at10"}
    assert [x.time for x in seen] == pytest.approx([x.time for x in as_good])
    return what


def count(happened, what, where):
    return sum(e[2] == what and e[4] == where for e in happened)


def run_on_ranks(case, folder, number=100):
    """The same on one rank and on four."""
    several = BodyCase(case, folder, "ranks4")
    case.solve()
    log = several.solve(4, (4, 1, 1))
    assert f"Bodies are spread over the ranks: {number}" in log
    return check_ranks(case, several)


def test_same_on_several_ranks(tmp_path):
    happened = run_on_ranks(rows(tmp_path), tmp_path)
    assert count(happened, "leaves", "inlet") == 2
    assert count(happened, "leaves", "outlet") == 3
    assert count(happened, "enters", "again") == 1
    assert count(happened, "enters", "grain") >= 30


@pytest.mark.nightly
def test_held(tmp_path):
    happened = run_on_ranks(rows(tmp_path, "type hold;"), tmp_path)
    assert count(happened, "held", "outlet") == 2


@pytest.mark.nightly
@pytest.mark.parametrize("coupling", ["unresolved", "auto"])
def test_others_enter(coupling, tmp_path):
    """Such that the mesh does not resolve; or it decides on that."""
    happened = run_on_ranks(
        place(
            deep_tube(tmp_path, 1), "type sphere; radius 0.3;",
            [(y, z) for y in (-0.6, 0.6) for z in (-0.6, 0.6)], apart=1.6,
            outlet=AGAIN, injected={
                "shape": "type sphere; radius 0.2;", "low": -0.02, "high": 0.02,
                "injected": f"coupling {coupling};",
            },
        ), tmp_path,
    )
    assert count(happened, "enters", "grain") >= 30


def test_resolved_anew(tmp_path):
    """Cells are longer and shorter in turn along the tube: bodies are resolved as
    they come to the shorter ones, and no longer where they leave them."""
    case = place(
        deep_tube(tmp_path, 1, 2), "type sphere; radius 0.23;",
        [(y, z) for y in (-0.6, 0.6) for z in (-0.6, 0.6)],
        coupling="type auto;", outlet=AGAIN, injected={
            "shape": "type sphere; radius 0.2;", "low": -0.02, "high": 0.02,
            "injected": "",
        },
    )
    happened = run_on_ranks(case, tmp_path, 200)
    assert count(happened, "enters", "grain") >= 30
    changes, as_many = (
        re.findall(
            r"Cells per width: (\d+) bodies resolved from now on, (\d+) no",
            (path/"log.foamRun").read_text(),
        ) for path in (case.path, tmp_path/"ranks4")
    )
    assert changes == as_many
    assert (np.array(changes, int).sum(axis=0) > 10).all()


def test_restart_is_exact(tmp_path):
    """While some wait to enter again."""
    at_once = rows(tmp_path)
    parts = run_in_parts(at_once, tmp_path, STEP, STEPS, (4, 1, 1))

    # The sums of fastPoisson may differ in the last bit from run to run
    assert np.max(np.abs(motions(at_once) - motions(parts))) < 1e-10
    happened, as_good = events(at_once)[0], events(parts)[0]
    assert happened == as_good
    state = at_once.path/"processor0"/f"{STEP*STEPS/2:g}"
    text = (state/"uniform/immersedBodies").read_text()
    assert "waiting" in text and "gone" in text
