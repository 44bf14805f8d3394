# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong input in other files than the dictionaries of bodies, and what goes on
from an earlier run: refused or spoken of, never followed in silence."""

import pytest

from bodyCase import GRAVITY, BodyCase
from boxMesh import uniform
from foamCase import FoamError
from wrongText import FILE

DRIVE = """FoamFile { version 2.0; format ascii; class dictionary;
    object fvOptions; }
drive { type meanVelocityForce; selectionMode all; fields (U); Ubar (1 0 0); }
"""


@pytest.fixture(scope="module")
def meshed(tmp_path_factory):
    """Coarse tube with one disc."""
    case = BodyCase("tube", tmp_path_factory.mktemp("refusals"))
    case.mesh(uniform(-3, 3, 60), uniform(-1, 1, 20))
    case.controls(endTime="0.02", writeControl="timeStep", writeInterval="1")
    return case


@pytest.fixture
def tube(meshed, tmp_path):
    return BodyCase(meshed, tmp_path)


def refusal(case, *arguments):
    with pytest.raises(FoamError):
        case.run("foamRun", *arguments)
    log = (case.path / "log.foamRun").read_text()
    assert "FOAM FATAL" in log
    assert "\nTime = " not in log
    return log


@pytest.mark.parametrize(
    "value, dimensions",
    [("(0 0 -9.81)", "[0 1 -2 0 0 0 0]"), ("(0 -9.81 0)", "[0 1 -1 0 0 0 0]")],
)
def test_gravity(value, dimensions, tube):
    """Out of the plane, and of wrong dimensions."""
    text = GRAVITY.format(0, -9.81, 0)
    (tube.path / "constant/g").write_text(
        text.replace("(0 -9.81 0)", value)
        .replace("[0 1 -2 0 0 0 0]", dimensions)
    )

    log = refusal(tube)

    assert f"'value {value}', 'dimensions {dimensions}'" in log
    assert "constant/g" in log


def test_mean_velocity_force(tube):
    (tube.path / "constant/fvOptions").write_text(DRIVE)

    log = refusal(tube)

    assert "'type meanVelocityForce' in 'drive'" in log
    assert "'type flowRateForce'" in log


def test_dry_run(tube):
    assert "foamRun -check" in refusal(tube, "-dry-run")


def test_write_interval(tube):
    tube.controls(writeControl="runTime", writeInterval="0")

    log = refusal(tube)

    assert "Numbers overflow" in log
    assert "system/controlDict" in log


def test_dictionary_of_fast_poisson(tube):
    tube.replace(
        "system/fvSolution", "GAMG;\n        smoother        GaussSeidel;",
        "fastPoisson; fallbak { solver GAMG; smoother GaussSeidel; }",
    )

    with pytest.raises(FoamError) as error:
        tube.run("foamRun")

    assert "'fallbak'" in str(error.value)
    assert "'fallback'" in str(error.value)


def test_profile_along_its_patch(tube):
    for field, inlet, other, zero in (
        ("U", "tubeProfile; meanVelocity 1; axis (0 1 0)", "noSlip", "(0 0 0)"),
        ("p", "zeroGradient", "zeroGradient", "0"),
    ):
        head = (tube.path / "0.orig" / field).read_text()
        (tube.path / "0" / field).write_text(
            head.split("boundaryField", 1)[0] + f"""boundaryField
            {{
                inlet {{ type {inlet}; }}
                outlet {{ type fixedValue; value uniform {zero}; }}
                walls {{ type {other}; }}
                frontAndBack {{ type empty; }}
            }}
            """
        )

    log = refusal(tube)

    assert "'axis (0 1 0)'" in log
    assert "'inlet'" in log
    assert "0/U" in log


def test_another_shape_than_before(tube):
    tube.run("foamRun")
    tube.controls(endTime="0.04")
    tube.replace(FILE, "radius 0.25", "radius 0.3")

    log = refusal(tube)

    assert "'disc' has a volume of 0.028" in log
    assert "'shape'" in log
    assert "0.02/uniform/immersedBodies" in log


def test_no_state_of_the_bodies(tube):
    tube.run("foamRun")
    tube.controls(endTime="0.04")
    (tube.path / "0.02/uniform/immersedBodies").unlink()

    log = tube.run("foamRun")

    assert "There is no state of the bodies" in log
    assert "0.02/uniform/immersedBodies" in log


def test_settings_that_are_not_used(tube):
    tube.replace(
        "system/fvSolution", "PIMPLE\n{",
        "PIMPLE\n{ nOuterCorrectors 5; nCorrectors 3; consistent yes;"
        " momentumPredictor no;",
    )
    tube.replace("system/fvSolution", "relTol          0.01", "relTol 0")

    log = tube.run("foamRun")

    assert log.count(
        "'nOuterCorrectors' 'nCorrectors' 'consistent' 'momentumPredictor'"
    ) == 1
    assert "'relTol 0.01' does" in log


def test_used_settings_are_not_spoken_of(tube):
    log = tube.run("foamRun")

    assert "not used" not in log
    assert "ask for" not in log


def test_a_body_that_leaves_says_how_fast(tube):
    tube.bodies("""
        disc
        {
            shape       { type disc; radius 0.25; }
            position    (2.6 0 0);
            motion      { type prescribed; velocity (20 0 0); }
        }
    """)
    tube.controls(endTime="0.2")

    with pytest.raises(FoamError) as error:
        tube.run("foamRun")

    assert "in this step bodies moved through 4 cells" in str(error.value)
