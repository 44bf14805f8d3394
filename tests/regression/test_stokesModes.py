# SPDX-License-Identifier: GPL-3.0-or-later
"""stokesModes: resistance and free motion of bodies in Stokes flow."""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[1]/"benchmarks"))

from bodyCase import BodyCase
from boxMesh import around, graded, uniform
from measure import DEPTH, set_stokes, set_viscosity
from periodicTube import direct_pressure
from stokesCase import (
    RADIUS, discs, refused, solve, stokes_tube, table, table_file, write_dict,
)

# Body-fitted finite elements, m = 4, see tests/benchmarks/stokesModes
ONE = {
    "A_x0_x0": 6.626786, "A_y0_y0": 6.357214, "A_rz0_rz0": 0.0533790,
    "V_x0": 1.361306, "V_rz0": -0.448684,
}
WIDE = 0.25         # a large disc, for coarse meshes


@pytest.fixture(scope="module")
def coarse(tmp_path_factory):
    """Two large discs in a short tube; neither place is one of symmetry."""
    return stokes_tube(
        tmp_path_factory.mktemp("coarse"), "coarse",
        uniform(-2, 2, 64), uniform(-1, 1, 32),
        [(-0.41, -0.33), (0.43, 0.37)], WIDE,
    )


@pytest.fixture(scope="module")
def solved(coarse, tmp_path_factory):
    """Its table, and that of a second state."""
    case = BodyCase(coarse, tmp_path_factory.mktemp("solved"))
    states = [[(-0.41, -0.33), (0.43, 0.37)], [(-0.41, -0.33), (0.43, 0.5)],
              [(-0.2, 0), (0.2, 0)], [(-0.5, -2), (0.5, 0)]]
    return case, states, solve(case, states, tolerance="1e-9")


def matrix(columns, row=0, names=("x0", "y0", "rz0", "x1", "y1", "rz1")):
    return np.array(
        [[columns[f"A_{i}_{j}"][row] for j in names] for i in names]
    )


def test_one_disc(tmp_path):
    """8 cells per diameter: resistance, free motion, first order of inertia."""
    h = 2*RADIUS/8
    case = stokes_tube(
        tmp_path, "one", graded(-3, 3, around(0, 6.4*RADIUS, h), h, 1.04),
        graded(-1, 1, around(-0.3, 6.4*RADIUS, h), h, 1.04), [(0, -0.3)],
    )
    found = solve(case)
    error = {k: 100*(found[k][0]/v - 1) for k, v in ONE.items()}

    assert found["residual"][0] < 1e-7
    assert abs(error["A_x0_x0"]) < 0.03
    assert abs(error["A_y0_y0"]) < 0.03
    assert abs(error["A_rz0_rz0"]) < 0.6
    assert abs(error["V_x0"]) < 0.05
    assert abs(error["V_rz0"]) < 0.1
    assert found["V_y0"][0] == pytest.approx(0, abs=1e-6)
    # The lateral velocity at Re = 0.1, over Re
    assert found["V1_y0"][0] == pytest.approx(-1.596e-4, rel=0.02)
    assert found["asymmetry"][0] < 1e-5*ONE["A_x0_x0"]


def test_resistance_is_symmetric_and_positive(solved):
    A = matrix(solved[2])

    assert abs(A - A.T).max() < 1e-3*abs(A).max()
    assert solved[2]["asymmetry"][0] == pytest.approx(abs(A - A.T).max())
    least = np.linalg.eigvalsh(0.5*(A + A.T)).min()
    assert solved[2]["leastEigenvalue"][0] == pytest.approx(least, rel=1e-6)
    assert least > 0


def test_free_motion_solves_the_balance(solved):
    names = ["x0", "y0", "rz0", "x1", "y1", "rz1"]
    A = matrix(solved[2])
    V, V1, B, C = (
        np.array([solved[2][f"{q}_{n}"][0] for n in names])
        for q in ("V", "V1", "B", "C")
    )

    assert A @ V == pytest.approx(B, rel=1e-8)
    assert A @ V1 == pytest.approx(C, rel=1e-8)


def test_overlap_is_no_number(solved):
    assert np.isfinite(solved[2]["V_x0"][:2]).all()
    assert np.isnan(solved[2]["V_x0"][2:]).all()
    assert solved[2]["px1"][2] == 0.2


def test_mirrored(coarse, tmp_path):
    """In the middle of the tube."""
    case = BodyCase(coarse, tmp_path)
    found = solve(case, [[(-0.41, -0.33), (0.43, 0.37)],
                         [(-0.41, 0.33), (0.43, -0.37)]], tolerance="1e-9")

    for name, sign in (("V_x0", 1), ("V_rz0", -1), ("V_y0", -1), ("V1_x1", 1),
                       ("A_x0_rz0", -1), ("A_x0_y1", -1), ("C_y1", -1)):
        first, second = found[name]
        assert second == pytest.approx(sign*first, rel=1e-5), name


def test_ranks(coarse, solved, tmp_path):
    case = BodyCase(coarse, tmp_path)
    found = solve(case, solved[1][:1], ranks=2, tolerance="1e-9")

    for name in found:
        if name not in ("residual", "asymmetry"):
            one, two = solved[2][name][0], found[name][0]
            assert two == pytest.approx(one, rel=1e-6, abs=1e-7), name


def test_resumes(solved, tmp_path):
    """A row that was not written to its end is written again."""
    case = BodyCase(solved[0], tmp_path)
    text = table_file(case).read_text()
    lines = text.splitlines(keepends=True)
    table_file(case).write_text("".join(lines[:2]) + lines[2][:50])

    log = case.run("stokesModes")

    assert "of which the table has 1" in log
    assert "State 0" not in log
    assert table_file(case).read_text() == text


def test_forces_are_those_of_the_solver(coarse, tmp_path):
    """On fixed discs, at the end of a steady run without convection."""
    case = BodyCase(coarse, tmp_path)
    fixed = discs([(-0.41, -0.33), (0.43, 0.37)], WIDE).replace(
        "; }\n", "; motion { type fixed; } }\n"
    )
    case.bodies(fixed[:-1] + "motion { type fixed; } }")
    set_stokes(case)
        # The pressure inside settles slowly: 5e-5 of the force are left
    direct_pressure(case)
    case.controls(endTime="400", deltaT="0.2")
    case.solve()
    nu = 0.5

    found = solve(case, tolerance="1e-9")

    for body in (0, 1):
        forces = case.table("forces", body)
        for name, quantity in (("x", "fluidForce_x"), ("y", "fluidForce_y"),
                               ("rz", "fluidTorque_z")):
            force = forces[quantity][-1]/(DEPTH*nu)
            assert found[f"B_{name}{body}"][0] == pytest.approx(
                force, abs=1e-4*abs(found[f"B_x{body}"][0])
            ), name


def test_does_not_depend_on_viscosity(coarse, solved, tmp_path):
    case = BodyCase(coarse, tmp_path)
    set_viscosity(case, 3)
    found = solve(case, solved[1][:1], tolerance="1e-9")

    for name in ("V_x0", "V1_y0", "C_x0", "A_x0_x1"):
        assert found[name][0] == pytest.approx(solved[2][name][0], rel=1e-5)


def test_flows(coarse, tmp_path):
    """That of free bodies has their velocity inside."""
    case = BodyCase(coarse, tmp_path)
    case.controls(writeFormat="ascii")
    found = solve(case, writeFlows="yes", inertia="no")
    at_rest = case.field("U.0.fixed", "0")
    free = case.field("U.0.free", "0")
    # Cell at the centre of the second body
    column, row = int((0.43 + 2)*16), int((0.37 + 1)*16)
    cell = column + 64*row

    assert abs(at_rest[cell]).max() < 1e-4
    assert free[cell][0] == pytest.approx(found["V_x1"][0], rel=0.03)
    assert found["C_x0"][0] == 0
    assert (case.path/"0/p.0.rz1").exists()


def test_sphere_in_a_box(tmp_path):
    """3D: all directions are the same."""
    case = BodyCase("box", tmp_path)
    case.mesh(*3*(uniform(-1, 1, 16),))
    case.bodies("sphere { shape { type sphere; radius 0.4; }"
                " position (0 0 0); }")
    found = solve(case, tolerance="1e-8")

    names = ["x0", "y0", "z0", "rx0", "ry0", "rz0"]
    A = matrix(found, names=names)
    assert A[:3, :3] == pytest.approx(A[0, 0]*np.eye(3), abs=1e-5*A[0, 0])
    assert A[3:, 3:] == pytest.approx(A[3, 3]*np.eye(3), abs=1e-5*A[3, 3])
    # More than without walls, 6 pi R and 8 pi R^3
    assert A[0, 0] > 6*np.pi*0.4
    assert A[3, 3] == pytest.approx(8*np.pi*0.4**3, rel=0.25)
    assert [found[f"B_{n}"][0] for n in names] == pytest.approx(6*[0], abs=1e-6)


def test_angles(tmp_path):
    """An ellipse along the tube, turned by a right angle, is one across it."""
    case = stokes_tube(
        tmp_path, "ellipse", uniform(-2, 2, 64), uniform(-1, 1, 32), [(0, 0)],
    )
    values = []
    for a, b, angle in ((0.4, 0.2, 0.5*np.pi), (0.2, 0.4, 0)):
        case.bodies(f"e {{ shape {{ type ellipse; semiAxes ({a} {b}); }}"
                    " position (0 0 0); }")
        found = solve(case, angles=f"(((0 0 {angle:.15g})))", inertia="no")
        values.append([found[n][0] for n in ("A_x0_x0", "A_y0_y0", "V_x0")])
        table_file(case).unlink()

    assert values[0] == pytest.approx(values[1], rel=1e-5)
    assert values[0][1] != pytest.approx(values[0][0], rel=0.05)


def test_refusals(coarse, tmp_path):
    case = BodyCase(coarse, tmp_path)

    write_dict(case, tolerence="1e-8")
    refused(case, "tolerence", "'tolerance'", "stokesModesDict")
    write_dict(case, tolerance="-1")
    refused(case, "'tolerance", "greater than 0")
    write_dict(case, [[(0, 0)]])
    refused(case, "State 0 in 'states' has 1 vectors", "2 bodies")
    write_dict(case, angles="(((0 0 1) (0 0 1)) ((0 0 1) (0 0 1)))")
    refused(case, "'angles' has 2 states, 'states' has 1")
    write_dict(case, [[(-0.5, 0), (5, 0)]])
    refused(case, "There is no flow", "body 'disc1' is outside the mesh")
    write_dict(case, [[(-0.2, 0), (0.2, 0)]])
    refused(case, "There is no flow", "bodies overlap: ", "disc0")

    write_dict(case)
    case.bodies("")
    refused(case, "'bodies' has no body")


def test_refuses_the_table_of_other_states(solved, tmp_path):
    case = BodyCase(solved[0], tmp_path)
    write_dict(case, [[(-0.4, -0.33), (0.43, 0.37)]])
    refused(case, "Row '0'", "stokesModes.dat", "move the table away")

    case.bodies(discs([(-0.41, -0.33)], WIDE))
    write_dict(case)
    refused(case, "other columns")
    assert len(table(case)["state"]) == 4
