# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the blockMeshDict of a round tube of radius 1 along x: a square block
in the middle, with cubic cells of size h where x has that size, and four
blocks around it to the wall.

    write(case, x=graded(-3, 3, core=(-0.8, 0.8), h=0.075), h=0.075)
"""

import math

from boxMesh import HEADER

# Corners of the inlet end; those of the outlet end follow by adding 8
SQUARE = (0, 1, 2, 3)
RINGS = ((4, 5, 1, 0), (1, 5, 6, 2), (3, 2, 6, 7), (4, 0, 3, 7))
WALL = ((4, 5), (5, 6), (6, 7), (7, 4))
MIDDLE = ((0, -1), (1, 0), (0, 1), (-1, 0))


def write(case, x, h, square=0.62):
    """x: a direction as boxMesh makes it; square: half side of the square."""
    n = round(square/h)
    a, b = n*h, math.sqrt(0.5)
    ends = x[0], x[0] + sum(section[0] for section in x[1:])
    along = sum(section[1] for section in x[1:])
    grading = " ".join("({:.15g} {} {:.15g})".format(*s) for s in x[1:])
    radial = max(3, round((1 - a)/h))

    def patch(name, kind, faces):
        return [f"    {name}", "    {", f"        type {kind};", "        faces"] \
            + ["        ("] \
            + ["            ({} {} {} {})".format(*face) for face in faces] \
            + ["        );", "    }"]

    def block(face, ny, nz):
        p, q, r, s = face
        return f"    hex ({p} {p + 8} {q + 8} {q} {s} {s + 8} {r + 8} {r}) " \
            f"({along} {ny} {nz}) simpleGrading (({grading}) 1 1)"

    lines = [HEADER, "vertices", "("]
    for end in ends:
        for side in (a, b):
            lines += [
                f"    ({end:.15g} {y*side:.15g} {z*side:.15g})"
                for y, z in ((-1, -1), (1, -1), (1, 1), (-1, 1))
            ]
    lines += [");", "", "blocks", "(", block(SQUARE, 2*n, 2*n)]
    lines += [
        block(ring, *sizes) for ring, sizes in zip(
            RINGS, 2*((2*n, radial), (radial, 2*n)), strict=True
        )
    ]
    lines += [");", "", "edges", "("]
    for start, end in ((0, ends[0]), (8, ends[1])):
        lines += [
            f"    arc {start + i} {start + j} ({end:.15g} {y} {z})"
            for (i, j), (y, z) in zip(WALL, MIDDLE, strict=True)
        ]
    lines += [");", "", "boundary", "("]
    faces = (SQUARE, *RINGS)
    lines += patch("inlet", "patch", faces)
    lines += patch("outlet", "patch", [[i + 8 for i in f] for f in faces])
    lines += patch("walls", "wall", [(i, j, j + 8, i + 8) for i, j in WALL])
    lines += [");", ""]

    (case.path / "system" / "blockMeshDict").write_text("\n".join(lines))
