# SPDX-License-Identifier: GPL-3.0-or-later
"""What a scene does not need is not done: the results are the same, and the log
says what is left out. Other skips have tests of their own: no bodies
(test_zero_bodies), the direct solver (test_fast_poisson), the window
(test_periodicTube, test_timeOrder), locked motions (unit tests)."""

import re

import numpy as np
import pytest

from bodyCase import BodyCase
from boxMesh import uniform

HELD = "motion { type fixed; }"
FREE = "densityRatio 2; velocity (1 0 0);"
STILL = "motion { type prescribed; velocity (0 0 0); }"
STOKES = "div(phi,U)          Gauss linear", "div(phi,U)          none"


def make_tube(tmp_path, size):
    """Closed, of this half width; cells of 0.05."""
    case = BodyCase("tube", tmp_path, f"tube{size}")
    case.mesh(*2*[uniform(-size, size, 40*size)])
    case.controls(endTime="0.2", deltaT="0.02")
    case.replace(
        "system/fvSolution", "1e-8;\n        relTol          0.01",
        "1e-12; relTol 1e-6",
    )
    case.replace(
        "system/fvSolution", "1e-9;\n        relTol          1e-3",
        "1e-13; relTol 1e-8",
    )
    return case


@pytest.fixture
def tube(tmp_path):
    return make_tube(tmp_path, 1)


def solve(tube, folder, name, motion, before=""):
    """The case, and what its log says is skipped."""
    case = BodyCase(tube, folder, name)
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius 0.2; }}
            position    (0.01 -0.3 0);
            {motion}
        }}
    """, before)
    return case, re.search(r"skipped: (.*)", case.solve()).group(1)


def same(a, b, table, columns, tolerance):
    for column in columns:
        x, y = a.table(table)[column][-1], b.table(table)[column][-1]
        assert x == pytest.approx(y, rel=tolerance), column


def test_motion(tube, tmp_path):
    """The same layer, which is by default that of bodies that do move; one
    outer iteration or two have made no difference since the sudden start."""
    layer = "resistance { type exponential; steepness 1.2; }"
    tube.controls(endTime="0.4", deltaT="0.005")
    held, skipped = solve(tube, tmp_path, "held", HELD, layer)
    still, not_skipped = solve(tube, tmp_path, "still", STILL, layer)
    assert "motion of bodies" in skipped
    assert "motion of bodies" not in not_skipped
    same(held, still, "forces", ("fluidForce_x",), 2e-4)
    same(held, still, "forces", ("fluidTorque_z",), 1e-3)


def test_convection(tube, tmp_path):
    """At a Reynolds number of a millionth it makes no difference."""
    slow = BodyCase(tube, tmp_path, "slow")
    slow.replace("constant/transportProperties", "0.5;", "5e5;")
    slow.controls(endTime="2e-7", deltaT="2e-8")
    full, not_skipped = solve(slow, tmp_path, "full", HELD)
    slow.replace("system/fvSchemes", *STOKES)
    stokes, skipped = solve(slow, tmp_path, "stokes", HELD)
    assert "convection" in skipped
    assert "convection" not in not_skipped
    same(stokes, full, "forces", ("fluidForce_x", "fluidTorque_z"), 1e-5)


def test_outer_iterations(tube, tmp_path):
    """Those that a converged step is spared, all made for comparison."""
    free = "densityRatio 2; velocity ambient;"
    few, _ = solve(
        tube, tmp_path, "few", free, "coupling { tolerance 1e-4; }"
    )
    many, _ = solve(
        tube, tmp_path, "many", free,
        "coupling { nOuterCorrectors 30; tolerance 1e-9; }",
    )
    for column in ("velocity_x", "angularVelocity_z"):
        # Few: converged to 1e-4 of the speed
        same(few, many, "motion", (column,), 3e-4)


def test_bands(tube, tmp_path):
    """Later outer iterations leave the fluid away from bodies alone, unless
    viscosity takes what happens at the bodies there in one step. Of 30
    iterations the last ones solve for all cells."""
    free = "densityRatio 2; velocity ambient;"
    bands = "in the bands of bodies"
    tube.replace("constant/transportProperties", "0.5;", "5;")
    viscous, _ = solve(tube, tmp_path, "viscous", free)
    assert bands not in (viscous.path / "log.foamRun").read_text()

    tube.replace("constant/transportProperties", "5;", "0.02;")
    few, _ = solve(
        tube, tmp_path, "few", free, "coupling { tolerance 1e-4; }"
    )
    assert bands in (few.path / "log.foamRun").read_text()
    many, _ = solve(
        tube, tmp_path, "many", free,
        "coupling { nOuterCorrectors 30; tolerance 1e-9; }",
    )
    # As without bands, where it is 3.5e-5, 2.6e-5 and 2.07e-4
    bounds = {
        "velocity_x": 1e-4, "velocity_y": 1e-4, "angularVelocity_z": 2.2e-4
    }
    for column, bound in bounds.items():
        v, w = (c.table("motion")[column][-1] for c in (few, many))
        assert v == pytest.approx(w, abs=bound), column


NOTHING = """
FoamFile
{
    version     2.0;
    format      ascii;
    class       dictionary;
    object      fvOptions;
}

nothing
{
    type            vectorSemiImplicitSource;
    active          true;
    selectionMode   all;
    volumeMode      specific;
    injectionRateSuSp { U ((0 0 0) 0); }
}
"""


def test_the_rest_waits(tmp_path):
    """Between outer iterations the fluid away from bodies waits for pressure
    gradient and velocity, but where options could act on it. An option that
    does nothing makes no difference: eight steps, of which the last six have
    two iterations or more, the second of them in bands."""
    tube = make_tube(tmp_path, 2)
    tube.controls(
        endTime="0.16", writeInterval="0.16", writeFormat="ascii",
        writePrecision="12",
    )
    tube.replace("constant/transportProperties", "0.5;", "0.02;")
    cases = [BodyCase(tube, tmp_path, name) for name in ("waits", "does_not")]
    (cases[1].path/"constant/fvOptions").write_text(NOTHING)
    for case in cases:
        case.bodies("""
            disc
            {
                shape       { type disc; radius 0.2; }
                position    (0.01 -0.3 0);
                densityRatio 2; velocity ambient;
            }
        """)
        log = case.solve()
        assert log.count("in the bands of bodies") > 5
    for column in ("velocity_x", "velocity_y", "angularVelocity_z"):
        same(*cases, "motion", (column,), 1e-9)
    for field in ("U", "p", "phi"):
        one, other = (case.field(field) for case in cases)
        assert np.abs(one - other).max() < 1e-9*np.abs(other).max()


def residuals(case):
    """Of the components of velocity: initial, final, iterations."""
    return np.array(re.findall(
        r"Solving for U[xy], Initial residual = (\S+), "
        r"Final residual = (\S+), No Iterations (\d+)",
        (case.path / "log.foamRun").read_text(),
    ), float)


@pytest.mark.parametrize("walls", ["noSlip", "slip"])
def test_components_one_after_the_other(tube, tmp_path, walls):
    """Symmetric Gauss-Seidel for all components at once makes the iterations
    of OpenFOAM's; a smoother that is a dictionary is left to that. At walls
    with slip the diagonal differs between components. Euler: without a second
    previous level it begins where that does."""
    tube.replace("0.orig/U", "noSlip", walls)
    tube.replace("system/fvSchemes", "backward", "Euler")
    tube.controls(
        writeFormat="ascii", writePrecision="12", writeInterval="0.2"
    )
    tube.replace("system/fvSolution", "PBiCGStab", "smoothSolver")
    tube.replace(
        "system/fvSolution", "preconditioner  DILU",
        "minIter 5; maxIter 5; smoother symGaussSeidel",
    )
    at_once, _ = solve(tube, tmp_path, "once", HELD)
    tube.replace(
        "system/fvSolution", "smoother symGaussSeidel;",
        "smoother { smoother symGaussSeidel; }",
    )
    by_one, _ = solve(tube, tmp_path, "one", HELD)
    ours, theirs = residuals(at_once), residuals(by_one)
    assert len(ours) == 20
    assert ours == pytest.approx(theirs, rel=1e-4)
    assert at_once.field("U") == pytest.approx(by_one.field("U"), abs=1e-12)


def test_the_empty_direction(tmp_path):
    """What rounding leaves there is dropped each step: swept on it would grow,
    and spread as ever smaller numbers, which make the processor slow."""
    tube = make_tube(tmp_path, 5)
    tube.controls(endTime="0.08", writeInterval="0.08", writeFormat="ascii")
    tube.replace(
        "system/fvSolution", "PBiCGStab;\n        preconditioner  DILU",
        "smoothSolver;\n        smoother        symGaussSeidel",
    )
    case, _ = solve(tube, tmp_path, "wide", FREE)
    across = np.abs(case.field("U")[:, 2])
    assert across.max() < 1e-13
