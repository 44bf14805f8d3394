# SPDX-License-Identifier: GPL-3.0-or-later
"""Ends under traction (fixedTractionVelocity and fixedTractionPressure)."""

import re

import numpy as np
import pytest

import refusals
from bodyCase import BodyCase
from boxMesh import around, uniform
from endCase import EndCase

RADIUS = 0.065
H = 2*RADIUS/8

# Q/F, V_x/F and u/F in the middle of a channel of half width 1 and length 6, Re
# = 2, F = 0.5 in viscous units, by body-fitted finite elements (Taylor-Hood)
# computed for this project
FULL = {"Q": 0.115011, "V": 0.0860757, "empty": 0.0862577}
NORMAL = {"Q": 1/9, "V": 0.083157, "empty": 1/12}

FIXED = "constraints { translate (0 0 0); rotate (0 0 0); }"


def tube(folder, name, tangential="free", h=0.1, h_end=0.04, more=""):
    """Coarse mesh, without a body."""
    case = EndCase(
        folder, name, h, (around(0, 1, h), around(0, 0.2, h)), h_end, 0.5,
        tangential=tangential, more=more,
    )
    (case.path / "constant/immersedBodyProperties").unlink()
    case.controls(libs="(grainFvPatchFields)")
    case.replace("system/fvSchemes", "div(phi,U)          Gauss linear;",
                 "div(phi,U)          Gauss linear;\n"
                 "    div((nuEff*dev2(T(grad(U))))) Gauss linear;")
    case.replace("system/fvSolution", "PIMPLE\n{",
                 "PIMPLE\n{\n    nCorrectors 2;")
    text = (case.path / "system/controlDict").read_text()
    (case.path / "system/controlDict").write_text(
        text.split("functions")[0] + "functions {}\n"
    )
    return case


def disc(case, more, window=True):
    case.bodies(
        f"disc {{ shape {{ type disc; radius {RADIUS}; }} densityRatio 2; "
        f"position (0 0 0); {more} }}",
        "window { type comoving; direction (1 0 0); }" if window else "",
    )


@pytest.mark.parametrize("tangential, reference, tolerance", [
    ("free", FULL, 3e-3), ("zero", NORMAL, 1e-3),
])
def test_free_disc(tangential, reference, tolerance, tmp_path):
    core = around(0, 4*RADIUS, H)
    case = EndCase(tmp_path, "disc", H, (core, core), 0.02, 0.5,
                   tangential=tangential)
    disc(case, "velocity ambient; constraints { translate (1 0 0); }")
    case.controls(endTime="4", deltaT="0.04", writeInterval="4")
    case.solve()
    speed = case.table("motion")["velocity_x"][-1]
    assert speed/0.5 == pytest.approx(reference["V"], rel=tolerance)
    assert case.flow_rate(speed)/0.5 == pytest.approx(
        reference["Q"], rel=tolerance
    )


@pytest.mark.parametrize("solver", ["foamRun", "pimpleFoam"])
@pytest.mark.parametrize("tangential, reference, tolerance", [
    ("free", FULL, 5e-3), ("zero", NORMAL, 3e-3),
])
def test_empty_channel(solver, tangential, reference, tolerance, tmp_path):
    case = tube(tmp_path, "empty", tangential, h=0.06, h_end=0.03)
    case.controls(endTime="4", deltaT="0.04", writeInterval="4")
    case.run(solver)
    assert case.flow_rate()/0.5 == pytest.approx(
        reference["Q"], rel=tolerance
    )


@pytest.mark.parametrize("nu_dt", [1e-3, 1, 100])
def test_any_time_step_is_stable(nu_dt, tmp_path):
    """nu dt from 1e-2 to 1e5 squares of the smallest cells, F in steps."""
    case = EndCase(tmp_path, "steps", 0.1,
                   (around(0, 1, 0.1), around(0, 0.2, 0.1)),
                   0.04, 0.5)
    dt = nu_dt/0.5
    case.conditions(
        f"table ((0 (0 0 0)) ({9.5*dt} (0 0 0)) ({9.6*dt} (1 0 0))"
        f" ({19.5*dt} (1 0 0)) ({19.6*dt} (-1 0 0)))"
    )
    disc(case, FIXED, window=False)
    case.controls(endTime=f"{60*dt}", deltaT=f"{dt}",
                  writeInterval=f"{10*dt}")
    case.solve()
    largest = [np.abs(case.field("U", t)).max() for t in case.times()[1:]]
    # A jump of the traction overshoots where dt is large
    assert max(largest) < 2
    assert largest[-1] < 0.17


def test_restart_and_ranks(tmp_path):
    """A restart is exact; two ranks differ by the linear solvers only."""
    runs = {}
    for name in ("atOnce", "parts", "ranks"):
        case = runs[name] = tube(tmp_path, name, h_end=0.1)
        for solver in ("p|pFinal", "U|UFinal"):
            case.set("system/fvSolution", f'solvers/"({solver})"/relTol', 0)
        case.controls(endTime="0.2", deltaT="0.02", writeInterval="0.1",
                      writePrecision="17")
    runs["atOnce"].run("foamRun")
    case = runs["parts"]
    case.controls(endTime="0.1")
    case.run("foamRun")
    case.controls(endTime="0.2")
    case.run("foamRun")
    for field in ("U", "p", "phi"):
        parts, at_once = (
            (runs[name].path / "0.2" / field).read_bytes()
            for name in ("parts", "atOnce")
        )
        assert parts == at_once
    case = runs["ranks"]
    case.decompose(2, (1, 2, 1))
    case.run("foamRun", ranks=2)
    case.run("reconstructPar", "-latestTime")
    difference = case.field("U") - runs["atOnce"].field("U")
    assert np.abs(difference).max() < 1e-7


def test_backflow_at_high_reynolds_number(tmp_path):
    """Vortices of a cylinder, Re 1000, that leave right behind it."""
    case = BodyCase("cylinder", tmp_path)
    case.mesh(uniform(0, 0.5, 50), uniform(0, 0.41, 41))
    case.replace("constant/transportProperties", "1e-3", "2e-5")
    for field, condition in {
        "U": "fixedTractionVelocity; traction (0 0 0)",
        "p": "fixedTractionPressure",
    }.items():
        text = (case.path / "0.orig" / field).read_text()
        (case.path / "0" / field).write_text(re.sub(
            r"outlet  {[^}]*}", f"outlet {{ type {condition}; }}", text
        ))
    case.bodies(
        "cylinder { shape { type disc; radius 0.05; } position (0.3 0.2 0); "
        f"{FIXED} }}"
    )
    case.controls(endTime="8", deltaT="0.01", writeInterval="0.5",
                  writeFormat="ascii")
    case.solve()
    speeds = [case.field("U", time) for time in case.times()[1:]]
    assert max(np.abs(u).max() for u in speeds) < 3*0.3
    # There is backflow
    assert min(u[49::50, 0].min() for u in speeds) < -0.05


@pytest.mark.parametrize("start, end", [(-2.95, -2.6), (2.6, 2.95)])
def test_a_body_crosses_an_end(start, end, tmp_path):
    case = EndCase(tmp_path, "cross", 0.05,
                   (around(0, 2, 0.05), around(0, 0.4, 0.05)), 0.05, 0.5)
    case.bodies(f"""disc
    {{
        shape {{ type disc; radius 0.2; }}
        position ({start} 0.1 0);
        motion {{ type prescribed; velocity ({end - start} 0 0);
                  angularVelocity (0 0 1); }}
    }}""")
    case.controls(endTime="1", deltaT="0.02", writeInterval="0.1")
    case.solve()
    for time in case.times()[1:]:
        # The largest without a body is 0.5
        assert np.abs(case.field("U", time)).max() < 0.55
    forces = case.table("forces")["fluidForce_x"][5:]
    # From step to step by 3 and 5 % at most, where it leaves
    assert np.abs(np.diff(forces)).max() < 0.1*np.abs(forces).max()


WRONG = {
    "backflow -1;": "'backflow -1'",
    "relaxation 2;": "'relaxation 2'",
    "relaxation 0;": "'relaxation 0'",
    "rho -1;": "'rho -1'",
    "tangentialVelocity none;": "free zero",
    "tracktion (0 0 0);": "nearest valid one is 'traction'",
}


@pytest.fixture(scope="module")
def refused(tmp_path_factory):
    folder = tmp_path_factory.mktemp("refused")
    case = tube(folder, "right", h=0.2, h_end=0.2)
    return refusals.of_copies(case, folder, {
        entry: lambda case, entry=entry: case.replace(
            "0/U", "(0.25 0 0); tangentialVelocity free;",
            f"(0.25 0 0); tangentialVelocity free; {entry}",
        )
        for entry in WRONG
    })


@pytest.mark.fast
@pytest.mark.parametrize("entry", WRONG)
def test_wrong_entries_are_refused(entry, refused):
    refused[entry].names(WRONG[entry], "0/U")
