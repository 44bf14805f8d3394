# SPDX-License-Identifier: GPL-3.0-or-later
"""Flows along walls with closed forms: a channel of any direction, an annulus.

    case = channel(tmp_path, "c", cells=10, rotation=turned(33))
    case.condition("top", "type robinVelocity; a 2; K (1 0 0);")
    case.force(rotation @ (0.3, 0, 0))
    case.run("foamRun")
    u = case.velocity() @ direction
"""

import math
import re
from pathlib import Path

import numpy as np

from boxMesh import HEADER
from foamCase import FoamCase

CASE = Path(__file__).parent / "cases" / "channel"
NU = 0.5

CORNERS = [
    (x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))
]


def turned(degrees, axis=(0, 0, 1)):
    """Matrix of a rotation."""
    x, y, z = np.array(axis)/np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = math.radians(degrees)
    return np.eye(3) + math.sin(angle)*cross \
        + (1 - math.cos(angle))*cross @ cross


def vector(v):
    """A vector as OpenFOAM reads it."""
    return "(" + " ".join(f"{x:.16g}" for x in v) + ")"


class WallFlow(FoamCase):
    """A copy of cases/channel."""

    def replace(self, file, old, new):
        """Replace text that a file has once."""
        path = self.path / file
        text = path.read_text()
        assert text.count(old) == 1, f"'{old}' in {path}"
        path.write_text(text.replace(old, new))

    def condition(self, patch, entries, field="U"):
        """Set the boundary condition of a patch."""
        path = self.path / "0" / field
        text = path.read_text().rstrip()
        assert text.endswith("}")
        path.write_text(f"{text[:-1]}    {patch} {{ {entries} }}\n}}\n")

    def force(self, f):
        """Set the body force [m/s2]."""
        self.replace("constant/fvOptions", "(0 0 0)", vector(f))

    def start(self, U):
        """Set the velocity at the start."""
        cells = "".join(map(vector, U))
        self.replace(
            "0/U", "internalField   uniform (0 0 0)",
            f"internalField nonuniform List<vector> {len(U)}({cells})",
        )

    def values(self, name, time=None, patch=None):
        """Cell values of a field, or those of a patch."""
        text = (self.path / (time or self.latest_time()) / name).read_text()
        begin = f"    {patch}\n" if patch else "internalField"
        text = text.split(begin, 1)[1]
        if patch:
            text = text.split("}", 1)[0].split("value ", 1)[1]
        text = text[text.index("uniform"):]
        if "List<" not in text[:40]:
            value = re.sub("[()]", " ", text[:text.index(";")]).split()[1:]
            return np.array(value, dtype=float).reshape(1, -1)
        start = text.index("(")
        numbers = text[start:text.index(";", start)].replace(")", ") ")
        size = 1 if "List<scalar>" in text[:start] else 3
        numbers = re.sub("[()]", " ", numbers).split()
        return np.array(numbers, dtype=float).reshape(-1, size)

    def centres(self, patch=None):
        """Centres of the cells, or of the faces of a patch."""
        if not (self.path / "0/C").exists():
            self.run("postProcess", "-func", "writeCellCentres", "-time", "0")
        return self.values("C", "0", patch)


def write(case, vertices, blocks, edges, boundary):
    """Write and run blockMeshDict; boundary: name: (type, faces, more)."""
    lines = [HEADER, "vertices", "("]
    lines += [f"    {vector(v)}" for v in vertices]
    lines += [");", "blocks", "(", *blocks, ");", "edges", "("]
    lines += [*edges, ");", "boundary", "("]
    for name, (kind, faces, more) in boundary.items():
        text = " ".join("({} {} {} {})".format(*face) for face in faces)
        lines += [f"    {name} {{ type {kind}; {more} faces ({text}); }}"]
    lines += [");", ""]
    (case.path / "system/blockMeshDict").write_text("\n".join(lines))
    case.run("blockMesh")


def channel(folder, name, cells, rotation=None, three_d=False):
    """Channel -1 < y < 1, periodic along x, and in 3D along z, rotated."""
    case = WallFlow(CASE, folder, name)
    rotation = np.eye(3) if rotation is None else rotation
    length = 4/cells
    vertices = [
        rotation @ ((x - 0.5)*length, 2*y - 1, (z - 0.5)*length)
        for x, y, z in CORNERS
    ]
    layers = 2 if three_d else 1

    def pair(a, b, faces):
        return {
            a: ("cyclic", [faces[0]], f"neighbourPatch {b};"),
            b: ("cyclic", [faces[1]], f"neighbourPatch {a};"),
        }

    front = (0, 3, 2, 1), (4, 5, 6, 7)
    boundary = {
        "bottom": ("wall", [(0, 1, 5, 4)], ""),
        "top": ("wall", [(3, 7, 6, 2)], ""),
        **pair("left", "right", ((0, 4, 7, 3), (1, 2, 6, 5))),
        **(pair("back", "front", front) if three_d
           else {"frontAndBack": ("empty", front, "")}),
    }
    write(
        case, vertices,
        [f"hex (0 1 2 3 4 5 6 7) (2 {cells} {layers}) simpleGrading (1 1 1)"],
        [], boundary,
    )
    return case


def annulus(folder, name, inner, outer, cells):
    """Ring, cells over its width; the inner wall is `bottom`, the outer `top`."""
    case = WallFlow(CASE, folder, name)
    angles = [math.radians(45 + 90*i) for i in range(4)]
    vertices = [
        (r*math.cos(angle), r*math.sin(angle), z)
        for z in (0, 0.1) for r in (inner, outer) for angle in angles
    ]
    around = round(0.5*math.pi*0.5*(inner + outer)/(outer - inner)*cells)
    blocks, edges, walls, flat = [], [], ([], []), []
    for i in range(4):
        j = (i + 1) % 4
        blocks.append(
            f"hex ({i} {i + 4} {j + 4} {j} {i + 8} {i + 12} {j + 12} {j + 8})"
            f" ({cells} {around} 1) simpleGrading (1 1 1)"
        )
        middle = math.radians(90 + 90*i)
        for k, r in enumerate((inner, outer)):
            walls[k].append(
                (i + 4*k, j + 4*k, j + 4*k + 8, i + 4*k + 8)
            )
            for z in (0, 1):
                point = r*math.cos(middle), r*math.sin(middle), 0.1*z
                start = 4*k + 8*z
                edges.append(f"arc {i + start} {j + start} {vector(point)}")
        flat += [
            (i, i + 4, j + 4, j), (i + 8, i + 12, j + 12, j + 8)
        ]
    write(case, vertices, blocks, edges, {
        "bottom": ("wall", walls[0], ""), "top": ("wall", walls[1], ""),
        "frontAndBack": ("empty", flat, ""),
    })
    return case


def order(errors):
    """Order of convergence between meshes of twice the cells."""
    errors = np.array(errors)
    return np.log2(errors[:-1]/errors[1:])


def steps(case, n, dt):
    """Make n time steps dt."""
    case.set("system/controlDict", "deltaT", dt)
    case.set("system/controlDict", "endTime", f"{n*dt:g}")
    case.set("system/controlDict", "writeInterval", n)


def rough_profile(y, a, K, Q):
    """Undisturbed flow of flow rate Q between rough walls y = -1 and 1."""
    return (6*K - 3*a*Q)/(4*(3 + a))*(y**2 - 1) + (2*K + 3*Q)/(2*(3 + a))
