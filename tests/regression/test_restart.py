# SPDX-License-Identifier: GPL-3.0-or-later
"""A run in two parts gives what the run in one go gives, to the last bit."""

import pytest

from bodyCase import BodyCase
from boxMesh import uniform

VARIANTS = {
    "backward": {},
    "Euler": {},
    "backward, adjusted time step": {
        "adjustTimeStep": "yes",
        "maxCo": "0.2",
    },
    "backward, comoving window": {},
    "backward, prescribed motion": {},
    "backward, partly prescribed motion": {},
    "backward, restraints": {},
    "backward, comoving window, restraints": {},
    "backward, adjusted time step, prescribed motion": {
        "adjustTimeStep": "yes",
        "maxCo": "0.2",
    },
}
PRESCRIBED = """motion
    {
        type        prescribed;
        velocity    { type sine; amplitude 2; frequency 3; scale (1 0.5 0);
                      level (1 0 0); }
        angularVelocity table ((0 (0 0 1)) (0.3 (0 0 -2)));
    }"""
PARTLY = """motion
    {
        type        prescribed;
        velocity    table ((0 (1 0 0)) (0.3 (0 0 0)));
    }
    constraints     { translate (0 1 0); rotate (0 0 1); }"""
RESTRAINTS = """velocity ambient;
    restraints
    {
        spring
        {
            type        linearSpring;
            stiffness   (3 5 0);
            damping     (0.1 0 0);
            rotationalStiffness (0 0 0.1);
        }
        push
        {
            type        externalForce;
            force       table ((0 (0 0 0)) (0.3 (0.1 0 0)));
        }
    }"""
WINDOW = "window { type comoving; direction (1 0 0); }"
ENTRIES = {
    ", prescribed": PRESCRIBED, "partly": PARTLY, "restraints": RESTRAINTS,
}


@pytest.fixture(scope="module")
def tube(tmp_path_factory):
    case = BodyCase("tube", tmp_path_factory.mktemp("restart"))
    case.mesh(uniform(-3, 3, 60), uniform(-1, 1, 20))
    case.controls(
        endTime="0.2", writeControl="timeStep", writeInterval="5",
        # The run goes on from the time in the name of the folder
        writePrecision="17", timePrecision="15",
    )
    return case


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("variant", VARIANTS)
def test_restart_is_exact(variant, ranks, tube, tmp_path):
    at_once = BodyCase(tube, tmp_path, "atOnce")
    at_once.controls(**VARIANTS[variant])
    at_once.replace("system/fvSchemes", "backward", variant.split(",")[0])
    if "window" in variant:
        at_once.replace(
            "constant/immersedBodyProperties", "bodies\n{",
            f"{WINDOW}\n\nbodies\n{{",
        )
    for part, entries in ENTRIES.items():
        if part in variant:
            at_once.replace(
                "constant/immersedBodyProperties", "velocity    ambient;",
                entries,
            )
    if ranks > 1:
        at_once.decompose(ranks)
    in_parts = BodyCase(at_once, tmp_path, "inParts")

    at_once.solve(ranks)
    folder = "processor0" if ranks > 1 else "."
    in_parts.controls(endTime=at_once.times(folder)[1])
    in_parts.solve(ranks)
    in_parts.controls(endTime="0.2")
    in_parts.solve(ranks)

    assert float(at_once.latest_time(folder)) > 0.12
    expected, obtained = at_once.results(ranks), in_parts.results(ranks)
    for name in ("U", "phi", "p", "uniform/immersedBodies"):
        assert any(file.endswith("/" + name) for file in expected)
    assert sorted(obtained) == sorted(expected)
    assert [f for f in expected if obtained[f] != expected[f]] == []

    # Steps of several lengths, or the variant is none
    times = at_once.table("motion")["time"]
    assert len(in_parts.table_files("motion")) == 2
    steps = {round(t2 - t1, 10) for t1, t2 in zip(times, times[1:])}
    assert (len(steps) > 1) == ("adjusted" in variant)

    # The tables of the two parts are those of the run at once
    for table in ("motion", "forces"):
        columns = at_once.table(table)
        parts = in_parts.table(table)
        assert columns.pop("time") == pytest.approx(parts["time"])
        differing = [n for n in columns if (columns[n] != parts[n]).any()]
        assert differing == [], table
