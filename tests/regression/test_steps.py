# SPDX-License-Identifier: GPL-3.0-or-later
"""Time steps that do not converge: a disc of a hundredth of the fluid's density,
thrown into a flow of little viscosity, Courant numbers of 2.1 and 6."""

import re
import shutil

import numpy as np
import pytest

from bodyCase import BodyCase
from boxMesh import uniform
from foamCase import FoamError


@pytest.fixture(scope="module")
def tube(tmp_path_factory):
    case = BodyCase("tube", tmp_path_factory.mktemp("steps"))
    case.controls(writeFormat="ascii", writePrecision="17")
    case.mesh(uniform(-1, 1, 40), uniform(-1, 1, 40))
    case.replace("constant/transportProperties", "0.5;", "1e-3;")
    return case


def prepare(tube, folder, n_outer, deltaT):
    case = BodyCase(tube, folder, "case")
    case.bodies("""
        disc
        {
            shape       { type disc; radius 0.2; }
            densityRatio 0.01;
            position    (0.013 -0.3 0);
            velocity    (0.2 0.3 0);
            angularVelocity (0 0 2);
        }
    """, f"coupling {{ nOuterCorrectors {n_outer}; }}")
    case.controls(endTime=6*deltaT, deltaT=deltaT)
    return case


def test_a_step_is_repeated_with_half_its_length(tube, tmp_path):
    deltaT = 0.08
    case = prepare(tube, tmp_path, 3, deltaT)
    log = case.solve()
    repeats = re.findall(r"Time = (\S+), repeated with deltaT = (\S+)", log)
    assert len(repeats) == 1
    end, half = map(float, repeats[0])
    assert half == pytest.approx(deltaT/2)

    # The pieces end where the step was to end, and the others are whole
    motion = case.table("motion")
    times = motion["time"]
    whole = deltaT*np.arange(1, 7)
    assert np.abs(end + half - whole).min() < 1e-9
    assert times == pytest.approx(np.sort(np.append(whole, end)), abs=1e-9)
    assert np.abs(motion["velocity_x"]).max() < 3


def test_a_restart_within_a_halved_step_is_exact(tube, tmp_path):
    deltaT = 0.08
    at_once = prepare(tube, tmp_path, 3, deltaT)
    at_once.controls(
        writeControl="timeStep", writeInterval=1, timePrecision=15,
    )
    log = at_once.solve()
    (half,) = re.findall(r"Time = (\S+), repeated", log)
    times = at_once.times()

    # From the end of the first piece, and of the second
    first = times.index(half)
    for last in (first, first + 1):
        rest = BodyCase(at_once, tmp_path, f"rest{last}")
        for time in times[last + 1:]:
            shutil.rmtree(rest.path / time)
        rest.solve()

        assert rest.times() == times
        for name in ("U", "phi", "p", "uniform/immersedBodies"):
            expected, obtained = (
                (case.path/times[-1]/name).read_bytes()
                for case in (at_once, rest)
            )
            assert obtained == expected, name


NUT = """FoamFile
{
    version 2.0; format ascii; class volScalarField; object nut;
}
dimensions      [0 2 -1 0 0 0 0];
internalField   uniform 0;
boundaryField
{
    frontAndBack { type empty; }
    ".*" { type zeroGradient; }
}
"""
SMAGORINSKY = """LES;
LES
{
    LESModel Smagorinsky; turbulence on; printCoeffs off; delta cubeRootVol;
    cubeRootVolCoeffs { deltaCoeff 2; }
}
"""


def first_pieces(repeated, folder, deltaT):
    """The case after its first step, which is repeated, and after one that is
    as short from the start; with the time of its end."""
    repeated.controls(
        endTime=deltaT, deltaT=deltaT, writeControl="timeStep",
        writeInterval=1, timePrecision=12,
    )
    new = BodyCase(repeated, folder, "new")
    pieces = dict(re.findall(
        r"Time = (\S+), repeated with deltaT = (\S+)", repeated.solve()
    ))
    first = repeated.times()[1]
    new.controls(deltaT=pieces[first], endTime=first)
    assert ", repeated with" not in new.solve()
    return repeated, new, first


def same(cases, first, *fields):
    for name in fields:
        obtained, expected = (case.field(name, first) for case in cases)
        assert np.ptp(expected) > 0
        assert obtained == pytest.approx(
            expected, rel=1e-8, abs=1e-8*np.abs(expected).max()
        ), name


def test_a_repeated_step_begins_as_a_new_one(tube, tmp_path):
    """With what is no old level of a field in time: a viscosity that depends on
    the flow, and the gradients along ends under traction."""
    deltaT = 0.14
    case = prepare(tube, tmp_path, 3, deltaT)
    sides = """
        "inlet|outlet" {{ type fixedTraction{}; }}
        walls {{ type {}; }}
        frontAndBack {{ type empty; }}
    """
    case.conditions(
        sides.format("Velocity; traction (0 0 0)", "noSlip"),
        sides.format("Pressure", "zeroGradient"),
    )
    case.replace(
        "constant/transportProperties", "Newtonian;", "powerLaw; "
        "powerLawCoeffs { k 1e-3; n 0.7; nuMin 1e-5; nuMax 1; }",
    )
    case.replace(
        "system/fvSchemes", "div(phi,U)          Gauss linear;",
        "div(phi,U)          Gauss linear;\n"
        "    div((nuEff*dev2(T(grad(U))))) Gauss linear;",
    )
    case.controls(libs="(grainFvPatchFields)")
    *cases, first = first_pieces(case, tmp_path, deltaT)
    same(cases, first, "U", "p", "nu")


def test_a_repeated_step_begins_with_the_old_eddy_viscosity(tube, tmp_path):
    """Which the momentum equation has, and the model sets anew after it."""
    deltaT = 0.28
    case = prepare(tube, tmp_path, 3, deltaT)
    case.replace(
        "constant/turbulenceProperties", "laminar;", SMAGORINSKY
    )
    case.replace(
        "system/fvSchemes", "div(phi,U)          Gauss linear;",
        "div(phi,U)          Gauss linear;\n"
        "    div((nuEff*dev2(T(grad(U))))) Gauss linear;",
    )
    (case.path / "0/nut").write_text(NUT)
    *cases, first = first_pieces(case, tmp_path, deltaT)
    same(cases, first, "U", "p", "nut")


def test_a_fixed_time_step_that_is_too_long_is_warned_of(tube, tmp_path):
    def warnings(deltaT, **controls):
        case = BodyCase(tube, tmp_path, f"long{deltaT}{len(controls)}")
        case.bodies("""
            disc
            {
                shape       { type disc; radius 0.2; }
                position    (0 0 0);
                motion      { type fixed; }
            }
        """)
        case.controls(endTime=3*deltaT, deltaT=deltaT, **controls)
        return re.findall(r"go through (\S+) cells", case.solve())

    # Cells of 0.05, and 1.5 m/s at the start
    (cells,) = warnings(0.4)
    assert float(cells) == pytest.approx(12, rel=0.01)
    assert not warnings(0.05)
    assert not warnings(0.4, adjustTimeStep="yes", maxCo=20)


def test_a_run_that_cannot_go_on_stops_with_its_state(tube, tmp_path):
    deltaT = 0.2
    case = prepare(tube, tmp_path, 3, deltaT)
    with pytest.raises(FoamError, match="however short it is made"):
        case.solve()

    # What has been written is the end of the last good step
    end = case.latest_time()
    assert float(end) == pytest.approx(case.table("motion")["time"][-1])
    assert (case.path / end / "uniform/immersedBodies").is_file()

    # It can be read again
    case.run("foamRun", "-check")
