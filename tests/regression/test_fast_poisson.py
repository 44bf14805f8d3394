# SPDX-License-Identifier: GPL-3.0-or-later
"""The direct solver of the pressure equation gives what others give."""

import re

import numpy as np
import pytest

from bodyCase import CASES, BodyCase
from boxMesh import graded, uniform
from foamCase import FoamCase

DISC = """
    disc
    {
        shape       { type disc; radius 0.25; }
        densityRatio 2;
        position    (-0.1 -0.3 0);
        velocity    ambient;
    }
"""
FAST = "fastPoisson; fallback { solver PCG; preconditioner DIC; }"


@pytest.fixture(scope="module")
def solve(tmp_path_factory):
    """Fields and log of a few steps."""
    def run(name, solver, ranks=1, parts=None, renumber=False):
        case = BodyCase("tube", tmp_path_factory.mktemp("fast"), name)
        case.mesh(
            graded(-3, 3, (-0.5, 0.5), 0.1, 1.1), uniform(-1, 1, 20),
        )
        if renumber:
            case.run("renumberMesh", "-overwrite")
        case.replace("system/fvSolution", "GAMG;", solver)
        case.replace("system/fvSolution", "1e-8", "1e-12")
        case.replace("system/fvSolution", "0.01", "0")
        case.replace("system/fvSolution", "1e-9", "1e-12")
        case.replace("system/fvSolution", "1e-3", "0")
        # As many iterations for all, and no sudden start: the way to convergence
        # depends on solvers
        case.bodies(DISC, "coupling { nOuterCorrectors 2; }")
        case.controls(
            endTime="0.06", writeInterval="0.06", writeFormat="ascii",
            writePrecision="15",
        )
        log = case.solve(ranks, parts)
        if ranks > 1:
            case.run("reconstructPar", "-latestTime")
        return case.field("U"), case.field("p"), log

    return run


def test_multigrid_and_any_decomposition_agree(solve):
    U, p, _ = solve("multigrid", "GAMG;")

    for name, *arguments in (
        ("serial",), ("slabs", 2, (2, 1, 1)), ("across", 2, (1, 2, 1)),
    ):
        fastU, fastP, log = solve(name, FAST, *arguments)
        assert np.abs(fastU - U).max() < 1e-7*np.abs(U).max(), name
        assert np.abs(fastP - p).max() < 1e-6*np.abs(p).max(), name
        assert len(re.findall("fastPoisson: .*tridiagonal", log)) == 1, name
        assert "PCG:  Solving for p" not in log, name


def test_renumbered_cells(solve):
    U, p, _ = solve("renumberedMultigrid", "GAMG;", renumber=True)
    fastU, fastP, log = solve("renumbered", FAST, renumber=True)
    assert np.abs(fastU - U).max() < 1e-7*np.abs(U).max()
    assert np.abs(fastP - p).max() < 1e-6*np.abs(p).max()
    assert "PCG:  Solving for p" not in log


def test_another_solver_where_the_coefficient_varies(tmp_path):
    """That of the pressure equation of pimpleFoam: said once, solved."""
    fields = {}
    for name, solver in (("usual", "PCG;"), ("varies", FAST)):
        case = FoamCase(CASES / "cavity", tmp_path, name)
        case.set("system/controlDict", "endTime", 0.1)
        case.set("system/controlDict", "writeFormat", "ascii")
        path = case.path / "system/fvSolution"
        text = path.read_text().replace("PCG;", solver)
        path.write_text(text.replace("1e-6", "1e-12"))
        case.run("blockMesh")
        log = case.run("foamRun")
        file = case.path / case.latest_time() / "U"
        fields[name] = re.search(
            r"internalField.*?boundaryField", file.read_text(), re.DOTALL
        ).group(0)

    assert log.count("not solved directly: the coefficient") == 1
    assert "DICPCG:  Solving for p" in log
    assert fields["usual"] == fields["varies"]


def test_closed_box_of_unit_cells(tmp_path):
    # The constant mode is singular, here without any rounding
    case = BodyCase("box", tmp_path, "unit")
    case.mesh(*3*[uniform(0, 8, 8)])
    case.replace("system/fvSolution", "GAMG;", FAST)
    # Two ranks have another preconditioner for U
    case.replace(
        "system/fvSolution", "1e-9;\n        relTol          1e-3",
        "1e-13; relTol 1e-9",
    )
    case.bodies("""
        sphere
        {
            shape       { type sphere; radius 2; }
            densityRatio 2;
            position    (4 4 4);
            velocity    (0.1 0 0);
        }
    """)
    case.controls(endTime="0.06")
    fields = []
    for ranks in (1, 2):
        log = case.solve(ranks)
        assert "dp: 8 x 8 x 8 cells: tridiagonal" in log
        fields.append(case.table("motion")["velocity_x"][-1])
    assert fields[1] == pytest.approx(fields[0], rel=1e-6)
