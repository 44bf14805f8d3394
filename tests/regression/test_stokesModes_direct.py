# SPDX-License-Identifier: GPL-3.0-or-later
"""The direct solver of stokesModes, in periodic tubes."""

import numpy as np
import pytest

from bodyCase import BodyCase
from boxMesh import uniform
from stokesCase import (
    DRIVE, periodic_stokes_tube, refused, solve, stokes_tube, table_file,
    write_dict,
)

WIDE = 0.25
PLACES = [(-0.41, -0.33), (0.43, 0.37)]

# a = 0.3, yp = 0, 45 degrees: body-fitted finite elements, m = 5
SIDE = 0.3/np.sqrt(2)
PAIR = {
    "V_x0": (1.426699303, 0.05), "V_y0": (-1.936253e-3, 0.5),
    "V_rz0": (-0.3177312, 0.05), "V1_y0": (-1.684288e-4, 2),
    "V1_rz0": (1.682582e-4, 2), "C_x0": (-1.895141e-4, 2),
    "C_y0": (-1.143441e-3, 2), "C_rz0": (5.985905e-6, 2),
}

# a = 0.2, yp = -0.64, angle 0.5, by the same method: the upper disc overtakes
UNEVEN = [
    (sign*0.2*np.cos(0.5), -0.64 + sign*0.2*np.sin(0.5)) for sign in (-1, 1)
]
UNEVEN_VALUES = {
    "V_x0": (6.819567e-1, 0.05), "V_x1": (1.031813, 0.05),
    "V1_y0": (2.590979e-4, 1), "V1_y1": (3.497384e-4, 1),
    "C_y0": (3.216820e-3, 1), "C_y1": (2.891492e-3, 1),
}


@pytest.fixture(scope="module")
def coarse(tmp_path_factory):
    return periodic_stokes_tube(
        tmp_path_factory.mktemp("coarse"), "coarse", 32, PLACES, WIDE, 2
    )


def both(case, drive=DRIVE, states=None):
    """Tables by the iterative and the direct solver."""
    found = {}
    for solver in ("iterative", "direct"):
        found[solver] = solve(
            case, states, solver=solver, tolerance="1e-10", drive=drive
        )
        table_file(case).unlink()
    return found


def check_same(found, rel=1e-6):
    one, other = found["iterative"], found["direct"]
    for name in one:
        if name not in ("residual", "asymmetry"):
            scale = max(abs(one[name]).max(), 1e-3)
            assert other[name] == pytest.approx(one[name], abs=rel*scale), name
    assert (other["residual"] < 1e-9).all()


def check_values(found, values):
    for name, (reference, percent) in values.items():
        error = 100*(found[name][0]/reference - 1)
        assert abs(error) < percent, name


@pytest.mark.parametrize(
    "drive", [DRIVE, "{ direction (1 0 0); acceleration 3; }"]
)
def test_same_as_iterative(coarse, tmp_path, drive):
    """Also where a disc reaches across the ends."""
    states = [PLACES, [(-0.41, -0.33), (1.93, 0.37)]]
    found = both(BodyCase(coarse, tmp_path), drive, states)

    check_same(found)
    if "acceleration" in drive:
        # Slower than without discs, for which the mean is g/(3 nu) = 2
        assert 0 < found["direct"]["V_x0"][0] < 3


def test_rough_walls(tmp_path):
    """Robin walls, one of them moving, and cells that grow to one wall."""
    case = periodic_stokes_tube(tmp_path, "rough", 32, PLACES, WIDE, 2)
    case.controls(libs="(grainFvPatchFields)")
    case.replace("0/U", "noSlip", "robinVelocity; a 3; K (0.7 0 0)")

    check_same(both(case))


def test_pair(tmp_path):
    """8 cells per diameter: the values of a body-fitted method."""
    case = periodic_stokes_tube(
        tmp_path, "pair", 123, [(-SIDE, -SIDE), (SIDE, SIDE)]
    )
    found = solve(case, drive=DRIVE)

    assert "direct solver" in (case.path/"log.stokesModes").read_text()
    check_values(found, PAIR)
    assert found["asymmetry"][0] < 1e-3*found["A_x0_x0"][0]
    assert found["leastEigenvalue"][0] > 0
    # The other disc sees the same from the other side
    assert found["V_rz1"][0] == pytest.approx(-found["V_rz0"][0], rel=1e-6)
    assert found["V_y1"][0] == pytest.approx(found["V_y0"][0], rel=1e-6)


def test_uneven_pair(tmp_path):
    """Discs that move relative to their mean velocity: what the layers do."""
    case = periodic_stokes_tube(tmp_path, "uneven", 123, UNEVEN)

    check_values(solve(case, drive=DRIVE), UNEVEN_VALUES)


def test_moved_by_whole_cells(coarse, tmp_path):
    """The matrix of the last state serves."""
    case = BodyCase(coarse, tmp_path)
    h = 4/64
    moved = [[(x + n*h, y) for x, y in PLACES] for n in (0, 5, 9)]
    between = [[(x + 0.5*h, y) for x, y in PLACES]]
    around = [[(x + 4, y) for x, y in PLACES]]
    found = solve(case, moved + between + around, drive=DRIVE)

    log = (case.path/"log.stokesModes").read_text()
    assert log.count("that of the last state") == 2
    for name in ("V_x0", "V_y1", "A_x0_rz1", "V1_y0"):
        values = found[name]
        assert values[1:3] == pytest.approx(values[0], rel=1e-7), name
        assert values[4] == pytest.approx(values[0], rel=1e-7), name
        assert values[3] == pytest.approx(values[0], rel=0.1), name
        assert values[3] != pytest.approx(values[0], rel=1e-7), name


def test_ranks(coarse, tmp_path):
    """On two of them the iterative solver serves."""
    one = solve(BodyCase(coarse, tmp_path, "one"), drive=DRIVE)
    case = BodyCase(coarse, tmp_path, "two")
    two = solve(case, ranks=2, drive=DRIVE)

    log = (case.path/"log.stokesModes").read_text()
    assert "iterative solver, as there are several processors" in log
    for name in ("V_x0", "V_rz1", "V1_y0", "A_x0_y1", "B_y1"):
        assert two[name][0] == pytest.approx(one[name][0], rel=1e-4), name


def test_where_it_serves(tmp_path):
    """Without cyclic ends the iterative one is taken, or direct refused."""
    case = stokes_tube(
        tmp_path, "ends", uniform(-1, 1, 16), uniform(-1, 1, 16), [(0, 0)],
        WIDE,
    )
    write_dict(case, solver="direct")
    refused(
        case, "'solver direct' does not serve here: its ends along x",
        "stokesModesDict",
    )

    solve(case)
    log = (case.path/"log.stokesModes").read_text()
    assert "iterative solver, as its ends along x are not cyclic" in log

    write_dict(case, solver="dircet")
    refused(case, "dircet")


def test_mirror_images(coarse, tmp_path):
    """Of one pair three are computed from the first, and the one with its discs
    interchanged."""
    (x0, y0), (x1, y1) = PLACES
    states = [
        PLACES, [(x0, -y0), (x1, -y1)], [(-x0, y0), (-x1, y1)],
        [(-x1, -y1), (-x0, -y0)], [(x1, y1), (x0, y0)], [(x0, y1), (x1, y1)],
    ]
    case = BodyCase(coarse, tmp_path)
    every = solve(case, states, drive=DRIVE)
    table_file(case).unlink()
    found = solve(case, states, drive=DRIVE, mirrors="((0 1 0) (1 0 0))")

    log = (case.path/"log.stokesModes").read_text()
    assert log.count(": mirror image of state 0") == 4
    assert log.count("dense matrix") == 2
    for name in every:
        scale = abs(every[name]).max()
        if name not in ("residual", "asymmetry"):
            assert found[name] == pytest.approx(
                every[name], abs=1e-6*max(scale, 1e-3)
            ), name

    # A run that goes on knows them too
    lines = table_file(case).read_text().splitlines(keepends=True)
    table_file(case).write_text("".join(lines[:2]))
    again = solve(case, states, drive=DRIVE, mirrors="((0 1 0) (1 0 0))")
    log = (case.path/"log.stokesModes").read_text()
    assert log.count(": mirror image of state 0") == 4
    for name in found:
        assert again[name] == pytest.approx(found[name], rel=1e-6, abs=1e-9)


def test_refuses_mirrors(coarse, tmp_path):
    case = BodyCase(coarse, tmp_path)

    def refuses(text, **entries):
        write_dict(case, drive=DRIVE, **entries)
        refused(case, "'mirrors'", text)

    refuses("(1 1 0)", mirrors="((1 1 0))")
    refuses("once", mirrors="((0 1 0) (0 -1 0))")
    refuses("(0 0 1)", mirrors="((0 0 1))")

    refuses("not like that", mirrors="((0 1 0))",
            angles="(((0 0 1) (0 0 0)))")
    case.bodies("b { shape { type ellipse; semiAxes (0.3 0.2); }"
                " position (0 0 0); }")
    refuses("round bodies", mirrors="((0 1 0))")
