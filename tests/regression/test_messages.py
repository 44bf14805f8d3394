# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong input is refused before any time step, with what to do about it."""

import pytest

import refusals
from bodyCase import BodyCase
from boxMesh import uniform
from foamCase import FoamError
from wrongEntries import WRONG
from wrongText import BODY, FILE

pytestmark = pytest.mark.fast

# One of each kind of place: these run the program itself, all of them a fork
# with the same code
END_TO_END = [
    "keyword",
    "keyword of a shape",
    "type of function",
    "exponents",
    "overlap with a wall",
    "file of positions",
    "patches that no patch matches",
    "distribution",
    "a plane without a normal",
    "steady state",
    "solver",
    "a radius beyond all bounds",
]

DISC = "{ type disc; radius 0.25; }"
MOVING_MESH = """FoamFile
{
    version     2.0;
    format      ascii;
    class       dictionary;
    object      dynamicMeshDict;
}

dynamicFvMesh   dynamicMotionSolverFvMesh;
motionSolverLibs (fvMotionSolvers);
motionSolver    displacementLaplacian;
diffusivity     uniform;
"""


@pytest.fixture(scope="module")
def tube(tmp_path_factory):
    """Coarse tube with one disc, D/h = 5, meshed."""
    case = BodyCase("tube", tmp_path_factory.mktemp("messages"))
    case.mesh(uniform(-3, 3, 60), uniform(-1, 1, 20))
    case.controls(endTime="0.02")
    return case


def refusal(case):
    """Message of a run that has to fail before its first time step."""
    with pytest.raises(FoamError):
        case.run("foamRun")
    log = (case.path / "log.foamRun").read_text()
    assert "FOAM FATAL" in log
    assert "\nTime = " not in log
    assert case.times() == ["0"]
    return log


def test_the_case_itself_runs(tube, tmp_path):
    case = BodyCase(tube, tmp_path)
    assert "\nTime = 0.02" in case.run("foamRun")


@pytest.fixture(scope="module")
def refused(tube, tmp_path_factory):
    """The refusals of all wrong entries."""
    def change(file, text, instead):
        def in_case(case):
            path = case.path / file
            path.write_text(path.read_text().replace(text, instead))
        return in_case

    return refusals.of_copies(tube, tmp_path_factory.mktemp("refused"), {
        name: change(*entry[:3]) for name, entry in WRONG.items()
    })


@pytest.mark.parametrize("wrong", WRONG)
def test_wrong_entries_are_refused(wrong, tube, refused):
    file, text, _, message = WRONG[wrong]
    assert (tube.path / file).read_text().count(text) == 1

    refused[wrong].names(*message)


@pytest.mark.parametrize("wrong", END_TO_END)
def test_the_program_refuses_wrong_entries(wrong, tube, tmp_path):
    file, text, instead, message = WRONG[wrong]
    case = BodyCase(tube, tmp_path, "tube")
    case.replace(file, text, instead)

    log = refusal(case)

    assert [part for part in message if part not in log] == []


def test_disc_in_three_dimensions(tmp_path):
    case = BodyCase("box", tmp_path)
    case.mesh(*3*[uniform(-1, 1, 10)])
    case.replace(FILE, "type sphere", "type disc")

    log = refusal(case)

    assert "'type disc'" in log
    assert "use 'sphere'" in log
    assert FILE in log


def test_restraints_of_an_unresolved_body(tmp_path):
    case = BodyCase("box", tmp_path)
    case.mesh(*3*[uniform(-1, 1, 10)])
    case.replace(
        FILE, "densityRatio    2.5;", "densityRatio 2.5; coupling unresolved;"
        " restraints { one { type linearSpring; damping (1 1 1); } }",
    )
    case.replace(FILE, "bodies\n", "rho 1;\n\nbodies\n")

    log = refusal(case)

    assert "'restraints' in immersedBodyProperties" in log
    assert "sphere is of the type 'unresolved'" in log
    assert "'coupling resolved'" in log


def test_moving_mesh(tube, tmp_path):
    case = BodyCase(tube, tmp_path, "tube")
    (case.path / "constant/dynamicMeshDict").write_text(MOVING_MESH)
    (case.path / "0/pointDisplacement").write_text("""FoamFile
{
    version     2.0;
    format      ascii;
    class       pointVectorField;
    object      pointDisplacement;
}
dimensions [0 1 0 0 0 0 0];
internalField uniform (0 0 0);
boundaryField
{
    ".*" { type fixedValue; value uniform (0 0 0); }
    frontAndBack { type empty; }
}
""")

    log = refusal(case)

    assert "need a mesh at rest" in log
    assert "constant/dynamicMeshDict" in log


def test_restart_without_the_state_of_a_body(tube, tmp_path):
    case = BodyCase(tube, tmp_path, "tube")
    case.controls(writeControl="timeStep", writeInterval="1")
    case.run("foamRun")
    case.controls(endTime="0.04")
    case.replace(FILE, "disc\n", "pea\n")

    with pytest.raises(FoamError) as error:
        case.run("foamRun")

    message = str(error.value)
    for part in ("'pea'", "(disc)", FILE, "0.02/uniform/immersedBodies"):
        assert part in message
    assert case.latest_time() == "0.02"


@pytest.mark.parametrize("radius, warned", [(0.19, True), (0.21, False)])
def test_few_cells_are_warned_of(radius, warned, tube, tmp_path):
    case = BodyCase(tube, tmp_path, "tube")
    case.replace(FILE, "radius 0.25", f"radius {radius}")

    log = case.run("foamRun")

    assert ("Body 'disc' has only 3.8 cells across" in log) == warned
    assert (FILE in log) == warned


def test_small_gaps_are_warned_of_once(tube, tmp_path):
    case = BodyCase(tube, tmp_path, "tube")
    case.replace(FILE, BODY, "position (-0.5 -0.7 0);")
    case.controls(endTime="0.06")

    log = case.run("foamRun")

    assert log.count("m between disc and a wall, below the cell size") == 1


def test_overlap_during_the_run_stops_it_with_the_state(tube, tmp_path):
    case = BodyCase(tube, tmp_path, "tube")
    case.bodies(f"""
        a
        {{
            shape {DISC}
            position (-1 0 0);
            velocity (1 0 0);
            constraints {{ translate (0 0 0); rotate (0 0 0); }}
        }}
        b {{ $a; position (-0.47 0 0); velocity (0 0 0); }}
    """)
    case.controls(endTime="0.2")

    with pytest.raises(FoamError) as error:
        case.run("foamRun")

    # The gap of 0.03 m closes at 0.03 s
    message = str(error.value)
    assert "a and b" in message
    assert "Stopped at time 0.04" in message
    assert (case.path / "0.04/uniform/immersedBodies").exists()


def test_function_objects_without_bodies(tube, tmp_path):
    case = BodyCase(tube, tmp_path, "tube")
    (case.path / FILE).unlink()
    case.replace(
        "system/fvSchemes", "none;",
        "none;\n    div((nuEff*dev2(T(grad(U))))) Gauss linear;",
    )

    with pytest.raises(FoamError) as error:
        case.run("foamRun")

    assert "'motion' needs immersed bodies" in str(error.value)
    assert FILE in str(error.value)
