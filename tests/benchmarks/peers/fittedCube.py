# SPDX-License-Identifier: GPL-3.0-or-later
"""A cube in a square duct, a quarter of it, on a mesh with its faces: cells
that grow away from its edges on both sides, for simpleFoam."""

import re
from pathlib import Path

from bodyCase import BodyCase
from boxMesh import HEADER, coarsen
from foamCase import FoamCase
from measure import Result
from peers.installed import installed

CASE = Path(__file__).parent / "cylinder"
SIDE, INLET, OUTLET = 0.5, -1.5, 2.5
EDGE = 0.02     # cells at the edges, growing by 12 %
X = (INLET, -0.5*SIDE, 0, 0.5*SIDE, OUTLET)
Y = (0, 0.5*SIDE, 1)
# Sections whose small cells are at their end
TOWARDS = (0, 2)


def set_conditions(case, Re):
    """A quarter of the duct: conditions, velocity and viscosity."""
    old = "1.2*pos().y()*(0.41 - pos().y())/sqr(0.41)"
    new = "(1 - sqr(pos().y()))*(1 - sqr(pos().z()))"
    case.replace("0/U", old, new)
    case.replace("constant/transportProperties", "1e-3;", f"{SIDE/Re:.12g};")
    for field in ("U", "p"):
        case.replace(
            f"0/{field}", "frontAndBack { type empty; }",
            '"south|middle" { type symmetryPlane; }',
        )
    for patch in ("south", "middle"):
        case.replace(
            "system/blockMeshDict", f"{patch} {{ type patch;",
            f"{patch} {{ type symmetryPlane;",
        )
    case.run("blockMesh")


def sections(points, refinement, ends):
    """Number of cells and expansion between successive points."""
    growth = 1 + 0.12/refinement
    result = []
    for i, (low, high) in enumerate(zip(points, points[1:])):
        _, n, ratio = coarsen(high - low, EDGE/refinement, growth)
        result.append((n, 1/ratio if i in ends else ratio))
    return result


def write(case, refinement):
    """Write the blockMeshDict, return the number of cells."""
    x = sections(X, refinement, TOWARDS)
    y = sections(Y, refinement, (0,))

    def corner(i, j, k):
        return i + 5*(j + 3*k)

    lines, cells = [], 0
    for k in range(2):
        for j in range(2):
            for i in range(4):
                if i in (1, 2) and j == k == 0:
                    continue
                corners = [
                    corner(i + a, j + b, k + c) for c in (0, 1)
                    for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))
                ]
                (nx, gx), (ny, gy), (nz, gz) = x[i], y[j], y[k]
                lines += [
                    f"hex ({' '.join(map(str, corners))}) ({nx} {ny} {nz})"
                    f" simpleGrading ({gx:.12g} {gy:.12g} {gz:.12g})"
                ]
                cells += nx*ny*nz
    vertices = [f"({a} {b} {c})" for c in Y for b in Y for a in X]
    (case.path / "system/blockMeshDict").write_text("\n".join([
        HEADER, "vertices (", *vertices, ");", "blocks (", *lines, ");",
        "edges ();", "defaultPatch { name cylinder; type wall; }",
        "boundary (", *boundary(corner), ");", "",
    ]))
    return cells


def boundary(corner):
    """All patches but the cube."""
    def faces(axis, value, skip=lambda i, j: False):
        sizes = [n for a, n in enumerate((4, 2, 2)) if a != axis]
        for i in range(sizes[0]):
            for j in range(sizes[1]):
                if skip(i, j):
                    continue
                square = []
                for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    index = [i + a, j + b]
                    index.insert(axis, value)
                    square.append(corner(*index))
                yield f"({' '.join(map(str, square))})"

    def inside(i, j):
        return i in (1, 2) and j == 0

    for name, kind, parts in (
        ("inlet", "patch", [*faces(0, 0)]),
        ("outlet", "patch", [*faces(0, 4)]),
        ("walls", "wall", [*faces(1, 2), *faces(2, 2)]),
        ("south", "patch", [*faces(1, 0, inside)]),
        ("middle", "patch", [*faces(2, 0, inside)]),
    ):
        yield f"{name} {{ type {kind}; faces ({' '.join(parts)}); }}"


def results(folder, Re, refinement):
    """(result, drag on the whole cube over density)."""
    if not installed("simpleFoam", "simpleFoam"):
        return
    case = FoamCase(CASE, folder, f"fitted_Re{Re}_{refinement}")
    case.replace = BodyCase.replace.__get__(case)
    cells = write(case, refinement)
    set_conditions(case, Re)
    log = case.run("simpleFoam")
    times = re.findall(r"ExecutionTime = (\S+) s", log)
    force = case.read_dat("postProcessing/forces/0/force.dat")
    yield Result(
        f"Re {Re}", round(SIDE*refinement/EDGE, 1), cells, steps=len(times),
        cpu=float(times[-1]), solver="simpleFoam",
    ), 4*force[-1, 1]
