# SPDX-License-Identifier: GPL-3.0-or-later
"""A FoamCase with immersed bodies: meshes, dictionaries and tables.

    case = BodyCase("tube", tmp_path)
    case.mesh(graded(-3, 3, (-0.5, 0.5), 0.1), uniform(-1, 1, 20))
    case.bodies("disc { shape { type disc; radius 0.2; } ... }")
    case.solve(ranks=2)
    case.table("motion")["velocity_x"]
"""

import re
from pathlib import Path

import numpy as np

import boxMesh
from foamCase import FoamCase, tables

CASES = Path(__file__).parent / "cases"

PATCHES = {
    "tube": {"inlet": "x-", "outlet": "x+", "walls": "y- y+"},
    "cylinder": {"inlet": "x-", "outlet": "x+", "walls": "y- y+"},
    "box": {"walls": "x- x+ y- y+ z- z+"},
}

GRAVITY = """FoamFile
{{
    version     2.0;
    format      ascii;
    class       uniformDimensionedVectorField;
    object      g;
}}

dimensions      [0 1 -2 0 0 0 0];
value           ({:.15g} {:.15g} {:.15g});
"""

TABLES = {"motion": "immersedBodyMotion", "forces": "immersedBodyForces"}


class BodyCase(FoamCase):
    """A copy of cases/<kind>, or of another BodyCase with its mesh."""

    def __init__(self, kind, tmp_path, name=None):
        if isinstance(kind, BodyCase):
            super().__init__(kind.path, tmp_path, name)
            self.kind = kind.kind
        else:
            super().__init__(CASES / kind, tmp_path, name)
            self.kind = kind
        self.read = {}

    def mesh(self, x, y, z=None):
        """Make the mesh and the initial velocity; returns number of cells."""
        cells = boxMesh.write(self, x, y, z, PATCHES[self.kind])
        self.run("blockMesh")
        if (self.path / "system/setExprFieldsDict").exists():
            self.run("setExprFields")
        return cells

    def bodies(self, text, before=""):
        """Write constant/immersedBodyProperties with the given bodies."""
        file = self.path / "constant" / "immersedBodyProperties"
        header = file.read_text().split("}", 1)[0] + "}\n"
        file.write_text(f"{header}\n{before}\n\nbodies\n{{\n{text}\n}}\n")

    def replace(self, file, old, new):
        """Replace text that a file has once."""
        path = self.path / file
        text = path.read_text()
        assert text.count(old) == 1, f"'{old}' in {path}"
        path.write_text(text.replace(old, new))

    def conditions(self, U, p):
        """Conditions of the patches, all of them, in 0/U and 0/p."""
        for field, text in (("U", U), ("p", p)):
            path = self.path / "0" / field
            head = path.read_text().split("boundaryField", 1)[0]
            path.write_text(f"{head}boundaryField\n{{{text}}}\n")

    def gravity(self, x=0, y=0, z=0):
        """Write constant/g."""
        (self.path / "constant/g").write_text(GRAVITY.format(x, y, z))

    def set_cyclic(self, *patches):
        """Make two patches, so far of type patch, one another's continuation.
        Before blockMesh, the conditions of the fields are left."""
        for one, other in (patches, reversed(patches)):
            self.replace(
                "system/blockMeshDict", f"    {one} {{ type patch;",
                f"    {one} {{ type cyclic; neighbourPatch {other};",
            )

    def set_symmetry(self, patch):
        """Make a patch, so far of type patch, a plane of symmetry. Before
        blockMesh, after the conditions of the other patches."""
        self.replace(
            "system/blockMeshDict", f"{patch} {{ type patch;",
            f"{patch} {{ type symmetryPlane;",
        )
        for field in ("U", "p"):
            path = self.path / "0" / field
            head, tail = path.read_text().split("boundaryField", 1)
            tail = tail.replace(
                "{", f"{{\n    {patch} {{ type symmetryPlane; }}\n", 1
            )
            path.write_text(f"{head}boundaryField{tail}")

    def controls(self, **entries):
        """Change or add entries of system/controlDict."""
        path = self.path / "system" / "controlDict"
        text = path.read_text()
        for key, value in entries.items():
            line = f"{key:<15} {value};"
            text, found = re.subn(rf"(?m)^{key} .*;$", line, text)
            if not found:
                text = text.replace("\nfunctions", f"{line}\n\nfunctions", 1)
        path.write_text(text)

    def decompose(self, ranks, n=None):
        """Decompose into ranks, or the n = (nx, ny, nz) parts of them."""
        nx, ny, nz = n or (ranks, 1, 1)
        self.replace(
            "system/decomposeParDict",
            "numberOfSubdomains 2", f"numberOfSubdomains {ranks}",
        )
        self.replace(
            "system/decomposeParDict", "(2 1 1)", f"({nx} {ny} {nz})"
        )
        self.run("decomposePar")

    def solve(self, ranks=1, n=None):
        """Run the solver, after decomposition if on several ranks."""
        if ranks > 1 and not (self.path / "processor0").exists():
            self.decompose(ranks, n)
        return self.run("foamRun", ranks=ranks)

    def table_files(self, name):
        """The .dat files of a function object by the times of their start."""
        return tables.table_files(self.path, name, TABLES[name])

    def columns(self, name):
        """The same for all bodies, read once per run."""
        states = [(file, file.stat()) for file in self.table_files(name)]
        key = [(file, s.st_mtime_ns, s.st_size) for file, s in states]
        if self.read.get(name, (None,))[0] != key:
            columns = tables.run_columns(self.path, name, TABLES[name])
            self.read[name] = key, columns
        return self.read[name][1]

    def table(self, name, body=0):
        """Columns of a table by their names without units, for one body."""
        columns = self.columns(name)
        rows = columns["body"] == body
        return {c: values[rows] for c, values in columns.items() if c != "name"}

    def field(self, name, time=None):
        """Cell values of a field that was written in ascii."""
        path = self.path / (time or self.latest_time()) / name
        text = path.read_text().split("internalField", 1)[1]
        values = re.search(r"\(\n(.*?)\n\)\n", text, re.DOTALL).group(1)
        return np.array(
            [re.sub("[()]", "", v).split() for v in values.splitlines()],
            dtype=float,
        )
