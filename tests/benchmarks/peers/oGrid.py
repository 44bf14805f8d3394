# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the blockMeshDict of the DFG channel fitted to its cylinder.

Four blocks between the cylinder and a box as high as the channel, one beyond.
"""

import math

from boxMesh import HEADER

X, Y, RADIUS, HEIGHT, LENGTH = 0.2, 0.2, 0.05, 0.41, 2.2
BOX = 0.4

# Largest over smallest cell: away from the cylinder, downstream
RADIAL, DOWNSTREAM = 6, 3


def points():
    """Corners in a plane: of the box, of the cylinder, of the outlet."""
    angles = [math.radians(45 + 90*i) for i in (2, 3, 0, 1)]
    return [
        (0, 0), (BOX, 0), (BOX, HEIGHT), (0, HEIGHT),
        *((X + RADIUS*math.cos(a), Y + RADIUS*math.sin(a)) for a in angles),
        (LENGTH, 0), (LENGTH, HEIGHT),
    ]


def arcs():
    """Edges of the cylinder in both planes."""
    for i in range(4):
        angle = math.radians(270 + 90*i)
        x, y = X + RADIUS*math.cos(angle), Y + RADIUS*math.sin(angle)
        for plane, z in ((0, -0.05), (10, 0.05)):
            yield (f"    arc {plane + 4 + i} {plane + 4 + (i + 1) % 4} "
                   f"({x:.15g} {y:.15g} {z})")


def write(case, n):
    """n cells on a quarter of the cylinder; returns the number of cells."""
    blocks = [
        (i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i, n, n, 1, 1/RADIAL)
        for i in range(4)
    ]
    blocks += [(1, 8, 9, 2, 2*n, n, DOWNSTREAM, 1)]

    def face(a, b):
        return f"({a} {b} {b + 10} {a + 10})"

    patches = {
        "inlet": ("patch", [face(0, 3)]),
        "outlet": ("patch", [face(8, 9)]),
        "walls": ("wall", [
            face(*f) for f in ((0, 1), (1, 8), (3, 2), (2, 9))
        ]),
        "cylinder": ("wall", [face(4 + i, 4 + (i + 1) % 4) for i in range(4)]),
        "frontAndBack": ("empty", [
            "({} {} {} {})".format(*(plane + p for p in block[:4]))
            for block in blocks for plane in (0, 10)
        ]),
    }
    lines = [HEADER, "vertices", "("]
    lines += [
        f"    ({x:.15g} {y:.15g} {z})" for z in (-0.05, 0.05)
        for x, y in points()
    ]
    lines += [");", "", "edges", "(", *arcs(), ");", "", "blocks", "("]
    for a, b, c, d, nx, ny, gx, gy in blocks:
        lines += [
            f"    hex ({a} {b} {c} {d} {a + 10} {b + 10} {c + 10} {d + 10})"
            f" ({nx} {ny} 1) simpleGrading ({gx} {gy:.15g} 1)"
        ]
    lines += [");", "", "boundary", "("]
    for name, (kind, faces) in patches.items():
        lines += [f"    {name} {{ type {kind}; faces ({' '.join(faces)}); }}"]
    lines += [");", ""]
    file = case.path / "system" / "blockMeshDict"
    file.write_text("\n".join(lines))
    return sum(block[4]*block[5] for block in blocks)
