# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh of a box with a core of equal cells, where a square about the origin is
an O-grid fitted to a cylinder of diameter 1; pimpleFoam on it.

Outside the square its cells are those of the box mesh that boxMesh.write makes of
the same directions."""

import math
import re
from pathlib import Path

from bodyCase import BodyCase
from boxMesh import HEADER
from foamCase import FoamCase
from measure import DEPTH, Result
from peers.installed import installed

CASE = Path(__file__).parent / "cylinder"
SOLVER = "pimpleFoam"
RADIUS = 0.5
# Numbering: 4 x 4 corners in a plane, then those on the cylinder
CORNERS, PLANE = 16, 20
RING = (5, 6, 10, 9)    # of the square, counter-clockwise from south-west


def split(direction, half, h):
    """Points and lists of sections of a direction (see boxMesh.graded): before,
    in and after the square from -half to half, which is in the core."""
    low, left, core, right = direction
    start = low + left[0]
    before, after = -half - start, start + core[0] - half
    points = [low, -half, half, start + core[0] + right[0]]
    return points, [
        [left, (before, round(before/h), 1)],
        [(2*half, round(2*half/h), 1)],
        [(after, round(after/h), 1), right],
    ]


def grading(sections):
    return "({})".format(" ".join(
        "({:.15g} {} {:.15g})".format(*section) for section in sections
    ))


def corners(a, b, c, d):
    return " ".join(map(str, (a, b, c, d, *(
        corner + PLANE for corner in (a, b, c, d)
    ))))


def blocks(x, y, radial):
    """Lines of the blocks, number of cells."""
    lines, total = [], 0
    for j, i in ((j, i) for j in range(3) for i in range(3)):
        if i == j == 1:
            continue
        n, m = (sum(s[1] for s in d) for d in (x[i], y[j]))
        a = i + 4*j
        lines += [
            f"hex ({corners(a, a + 1, a + 5, a + 4)}) ({n} {m} 1)"
            f" simpleGrading ({grading(x[i])} {grading(y[j])} 1)"
        ]
        total += n*m
    n = x[1][0][1]
    for i in range(4):
        j = (i + 1) % 4
        ring = corners(RING[i], RING[j], CORNERS + j, CORNERS + i)
        lines += [f"hex ({ring}) ({n} {radial} 1) simpleGrading (1 1 1)"]
        total += n*radial
    return lines, total


def boundary():
    """Lines of the patches."""
    def faces(*pairs):
        return " ".join(
            f"({a} {b} {b + PLANE} {a + PLANE})" for a, b in pairs
        )

    patches = {
        "inlet": ("patch", faces((0, 4), (4, 8), (8, 12))),
        "outlet": ("patch", faces((3, 7), (7, 11), (11, 15))),
        "sides": ("patch", faces(
            (0, 1), (1, 2), (2, 3), (12, 13), (13, 14), (14, 15)
        )),
        "cylinder": ("wall", faces(*(
            (CORNERS + i, CORNERS + (i + 1) % 4) for i in range(4)
        ))),
    }
    # What is left are the two planes
    yield "defaultPatch { name frontAndBack; type empty; }"
    yield "boundary ("
    for name, (kind, text) in patches.items():
        yield f"{name} {{ type {kind}; faces ({text}); }}"
    yield ");"


def write(case, x, y, half, h):
    """Write the blockMeshDict, return the number of cells."""
    xs, x = split(x, half, h)
    ys, y = split(y, half, h)
    angles = [math.radians(225 + 90*i) for i in range(4)]
    plane = [(a, b) for b in ys for a in xs] + [
        (RADIUS*math.cos(a), RADIUS*math.sin(a)) for a in angles
    ]
    vertices, arcs = [], []
    for offset, z in ((0, -0.5*DEPTH), (PLANE, 0.5*DEPTH)):
        vertices += [f"({a:.15g} {b:.15g} {z})" for a, b in plane]
        for i, angle in enumerate(angles):
            a, b = (offset + CORNERS + k % 4 for k in (i, i + 1))
            middle = angle + 0.25*math.pi
            arcs += [
                f"arc {a} {b} ({RADIUS*math.cos(middle):.15g}"
                f" {RADIUS*math.sin(middle):.15g} {z})"
            ]
    # As many cells as the square would have
    lines, total = blocks(x, y, round(0.4/h))
    (case.path / "system/blockMeshDict").write_text("\n".join([
        HEADER, "vertices (", *vertices, ");", "edges (", *arcs, ");",
        "blocks (", *lines, ");", *boundary(), "",
    ]))
    return total


class BoxCase(FoamCase):
    """A cylinder in a box; conditions of 0/U and 0/p are to be set."""

    conditions = BodyCase.conditions
    replace = BodyCase.replace
    controls = BodyCase.controls

    def __init__(self, folder, name, x, y, half, h):
        super().__init__(CASE, folder, name)
        self.D_over_h = round(1/h)
        self.cells = write(self, x, y, half, h)
        self.run("blockMesh")
        self.replace("system/fvSchemes", "steadyState", "backward")
        self.replace("system/controlDict", "(0.2 0.2 0)", "(0 0 0)")
        # No pressure is wanted; at points that are in the mesh
        self.replace(
            "system/controlDict", "((0.149999 0.2 0) (0.250001 0.2 0))",
            "((-1 0 0) (1 0 0))",
        )

    def solve(self, settings):
        """The result; nothing if the solver is not installed."""
        if not installed(SOLVER, SOLVER):
            return None
        log = self.run(SOLVER)
        times = re.findall(r"ExecutionTime = (\S+) s", log)
        return Result(
            settings, self.D_over_h, self.cells, steps=len(times),
            cpu=float(times[-1]), solver=SOLVER,
        )

    def history(self):
        """t, drag and lift per unit depth."""
        forces = self.read_dat("postProcessing/forces/0/force.dat")
        return forces[:, 0], forces[:, 1]/DEPTH, forces[:, 2]/DEPTH
