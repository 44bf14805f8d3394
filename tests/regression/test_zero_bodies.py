# SPDX-License-Identifier: GPL-3.0-or-later
"""Without bodies the fields are pimpleFoam's, to the last bit."""

from pathlib import Path

import pytest

from foamCase import FoamCase, FoamError

CASES = Path(__file__).parent / "cases"
SOLVERS = ["incompressibleFluid", "immersedFluid"]

# Entries that reach the branches the cases do not take by themselves
VARIANTS = {
    "cavity": {},
    "cavity-simplec": {
        "nOuterCorrectors": "2",
        "nNonOrthogonalCorrectors": "1",
        "consistent": "yes",
    },
    "turbulentStep": {},
    "turbulentStep-piso": {
        "nOuterCorrectors": "1",
        "nCorrectors": "2",
        "consistent": "no",
    },
    "movingPiston": {},
    "movingPiston-outer": {
        "nOuterCorrectors": "2",
        "moveMeshOuterCorrectors": "yes",
    },
    "movingPiston-noCorrectPhi": {"correctPhi": "no"},
    "rotor": {},
    "rotor-predictor": {"momentumPredictor": "yes"},
}


def prepare(variant, ranks, folder):
    """The meshed and, for several ranks, decomposed case."""
    case = FoamCase(CASES / variant.split("-")[0], folder, variant)
    for entry, value in VARIANTS[variant].items():
        case.set("system/fvSolution", f"PIMPLE/{entry}", value)
    case.run("blockMesh")
    if ranks > 1:
        case.run("decomposePar")
    return case


@pytest.fixture(scope="module")
def prepared(tmp_path_factory):
    """The cases, each made once."""
    cache = {}

    def get(variant, ranks):
        key = variant, ranks
        if key not in cache:
            cache[key] = prepare(*key, tmp_path_factory.mktemp("prepared"))
        return cache[key]

    return get


@pytest.fixture(scope="module")
def stock(prepared, tmp_path_factory):
    """pimpleFoam's results, computed once per variant and number of ranks."""
    cache = {}

    def get(variant, ranks):
        key = variant, ranks
        if key not in cache:
            case = prepared(*key).copy(tmp_path_factory.mktemp("stock"), "case")
            case.run("pimpleFoam", ranks=ranks)
            cache[key] = case.results(ranks, headers=True)
        return cache[key]

    return get


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("variant", VARIANTS)
def test_fields_are_those_of_pimpleFoam(
    variant, ranks, solver, prepared, stock, tmp_path
):
    case = prepared(variant, ranks).copy(tmp_path, "case")
    case.run("foamRun", "-solver", solver, ranks=ranks)

    expected = stock(variant, ranks)
    obtained = case.results(ranks, headers=True)

    assert sorted(obtained) == sorted(expected)
    assert [f for f in expected if obtained[f] != expected[f]] == []


@pytest.mark.parametrize("solver", SOLVERS)
def test_restart_is_that_of_pimpleFoam(solver, tmp_path):
    cases = []
    for run in (["pimpleFoam"], ["foamRun", "-solver", solver]):
        case = prepare("movingPiston", 1, tmp_path / run[0])
        case.run(*run)
        case.set("system/controlDict", "endTime", 0.5)
        case.run(*run)
        cases.append(case.results(headers=True))

    assert cases[0] == cases[1]


def test_post_processing_is_that_of_pimpleFoam(tmp_path):
    case = prepare("turbulentStep", 1, tmp_path)
    case.run("foamRun")
    values = []
    for app in ("pimpleFoam", "foamRun"):
        case.run(app, "-postProcess", "-latestTime", "-func", "yPlus")
        file = case.path / case.latest_time() / "yPlus"
        values.append(file.read_bytes())
        file.unlink()

    assert values[0] == values[1]


@pytest.mark.parametrize("solver", SOLVERS)
def test_check_reports_and_makes_no_time_step(solver, tmp_path):
    case = prepare("cavity", 1, tmp_path)
    log = case.run("foamRun", "-solver", solver, "-check")

    assert "cells            576" in log
    assert "(U p phi)" in log
    assert "deltaT           0.02" in log
    assert case.times() == ["0"]


def test_check_finds_a_missing_scheme(tmp_path):
    case = prepare("cavity", 1, tmp_path)
    case.run(
        "foamDictionary", "system/fvSchemes",
        "-entry", "divSchemes/div(phi,U)", "-remove",
    )

    with pytest.raises(FoamError, match=r"div\(phi,U\)"):
        case.run("foamRun", "-check")


def test_unknown_solver_is_refused_with_the_valid_ones(tmp_path):
    case = prepare("cavity", 1, tmp_path)

    with pytest.raises(FoamError) as error:
        case.run("foamRun", "-solver", "incompresibleFluid")

    assert "Unknown solver incompresibleFluid" in str(error.value)
    assert "system/controlDict" in str(error.value)
    for solver in SOLVERS:
        assert solver in str(error.value).split("Valid solvers")[1]


def test_missing_solver_names_file_and_keyword(tmp_path):
    case = prepare("cavity", 1, tmp_path)
    case.run(
        "foamDictionary", "system/controlDict", "-entry", "solver", "-remove"
    )

    with pytest.raises(FoamError) as error:
        case.run("foamRun")

    assert "add the entry solver" in str(error.value)
    assert "system/controlDict" in str(error.value)
    assert "incompressibleFluid" in str(error.value).split("Valid solvers")[1]
