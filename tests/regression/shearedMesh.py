# SPDX-License-Identifier: GPL-3.0-or-later
"""Shears the mesh of a box in 2D: its cells become parallelograms.

    case.mesh(uniform(0, 1.1, 66), uniform(0, 0.41, 24))
    shear(case, 34)
"""

import math
import re


def shear(case, degrees):
    """Move the vertices of blockMeshDict along x in proportion to y, and make
    the mesh and the initial velocity again."""
    file = case.path / "system/blockMeshDict"
    slope = math.tan(math.radians(degrees))

    def moved(vertex):
        x, y, z = map(float, vertex.groups())
        return f"    ({x + slope*y:.15g} {y:.15g} {z:.15g})\n"

    head, tail = file.read_text().split("\nblocks", 1)
    head = re.sub(r"    \((\S+) (\S+) (\S+)\)\n", moved, head)
    file.write_text(f"{head}\nblocks{tail}")
    case.run("blockMesh")
    if (case.path / "system/setExprFieldsDict").exists():
        case.run("setExprFields")
