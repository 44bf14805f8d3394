# SPDX-License-Identifier: GPL-3.0-or-later
"""A peer for bodies that move: overset meshes (overPimpleDyMFoam).

A ring of cells around a disc of diameter 1 moves through a background mesh.
"""

import math
import re
from pathlib import Path

import boxMesh
from bodyCase import BodyCase
from foamCase import FoamCase
from measure import DEPTH, Result

CASE = Path(__file__).parent / "overset"
SOLVER = "overPimpleDyMFoam"
PATCHES = {"inlet": "x-", "outlet": "x+", "walls": "y- y+"}

# Radii of the ring, largest over smallest cell
INNER, OUTER, RADIAL = 0.5, 1.5, 2


def faces(corners):
    """Faces between the planes on the edges of a closed line of corners."""
    pairs = zip(corners, corners[1:] + corners[:1])
    return " ".join(f"({a} {b} {b + 8} {a + 8})" for a, b in pairs)


def add_ring(case, start, n):
    """Add to system/blockMeshDict the ring, n cells on a quarter."""
    circles, arcs = [], []
    for plane, z in ((8, -0.5*DEPTH), (16, 0.5*DEPTH)):
        for circle, radius in ((0, OUTER), (4, INNER)):
            for i in range(4):
                corner, middle = (
                    " ".join(f"{x:.15g}" for x in (
                        start[0] + radius*math.cos(math.radians(degrees)),
                        start[1] + radius*math.sin(math.radians(degrees)), z,
                    )) for degrees in (225 + 90*i, 270 + 90*i)
                )
                circles += [f"    ({corner})"]
                a, b = (plane + circle + j % 4 for j in (i, i + 1))
                arcs += [f"    arc {a} {b} ({middle})"]

    blocks, sides = [], []
    for i in range(4):
        j = (i + 1) % 4
        low = [8 + i, 8 + j, 12 + j, 12 + i]
        high = [corner + 8 for corner in low]
        corners = " ".join(map(str, low + high))
        blocks += [
            f"    hex ({corners}) body ({n} {n} 1)"
            f" simpleGrading (1 {1/RADIAL:.15g} 1)"
        ]
        sides += ["({} {} {} {})".format(*side) for side in (low, high)]

    file = case.path / "system" / "blockMeshDict"
    text = file.read_text()
    text = text.replace(
        ");\n\nblocks\n(", "\n".join([
            *circles, ");", "", "edges", "(", *arcs, ");", "", "blocks", "(",
            *blocks,
        ]), 1,
    )
    text = text.replace(
        "faces ((0 3 2 1)", f"faces ({' '.join(sides)} (0 3 2 1)"
    )
    text = text.replace(
        "boundary\n(", f"""boundary
(
    disc {{ type wall; faces ({faces([12, 13, 14, 15])}); }}
    overset {{ type overset; faces ({faces([8, 9, 10, 11])}); }}""",
    )
    file.write_text(text)


class OversetCase(FoamCase):
    """A disc that moves, on a background mesh of directions x and y."""

    replace = BodyCase.replace
    controls = BodyCase.controls

    def __init__(self, folder, name, x, y, start, n):
        super().__init__(CASE, folder, name)
        self.cells = boxMesh.write(self, x, y, patches=PATCHES) + 4*n*n
        add_ring(self, start, n)
        self.run("blockMesh")
        self.run("setFields")

    def solve(self, settings, D_over_h):
        """The result of the run."""
        log = self.run(SOLVER)
        times = re.findall(r"ExecutionTime = (\S+) s", log)
        return Result(
            settings, D_over_h, self.cells, steps=len(times),
            cpu=float(times[-1]), solver=SOLVER,
        )

    def history(self):
        """t and the force per unit depth, x and y."""
        forces = self.read_dat("postProcessing/forces/0/force.dat")
        return forces[:, 0], forces[:, 1:3]/DEPTH
