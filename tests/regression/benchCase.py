# SPDX-License-Identifier: GPL-3.0-or-later
"""A piece of tutorials/testBench3D, with its mesh and initial fields.

    case = BenchCase("periodicTube", tmp_path, ["air.tubeVelocity=5"])
    case.run("foamRun")
    Re, f, roughness = periodicFriction(case.path)
"""

import re
import shutil
import subprocess
import sys
from pathlib import Path

from foamCase import FoamCase

BENCH = Path(__file__).resolve().parents[2]/"tutorials/testBench3D"
sys.path.insert(0, str(BENCH/"common"))

from friction import periodicFriction


class BenchCase(FoamCase):
    """cells: number of cells. mesher: gmshMesh for a mesh by gmsh, of which
    changes may be options."""

    def __init__(
        self, piece, tmp_path, changes=(), name=None, mesher="makeMesh"
    ):
        tmp_path = Path(tmp_path)
        super().__init__(BENCH/piece, tmp_path, name)
        # What a run of the tutorial has left
        for entry in (*self.times(), "postProcessing"):
            shutil.rmtree(self.path/entry, ignore_errors=True)
        if not (tmp_path/"common").exists():
            (tmp_path/"common").symlink_to(BENCH/"common")
        shutil.copytree(BENCH/"common/0.orig", self.path/"0")
        for file in self.path.glob("0.orig/*"):
            shutil.copy(file, self.path/"0")
        self.make_mesh(piece, changes, mesher)

    def make_mesh(self, piece, changes, mesher):
        script = BENCH/f"common/{mesher}.py"
        done = subprocess.run(
            [sys.executable, str(script), piece, *map(str, changes)],
            cwd=self.path, text=True, check=True, stdout=subprocess.PIPE,
        )
        self.cells = int(re.search(r"(\d+) cells", done.stdout)[1])
        self.run("gmshToFoam", f"{piece}.msh")
        self.run("foamDictionary", "constant/polyMesh/boundary",
                 "-entry", "entry0/walls/type", "-set", "wall")
        if (self.path/"system/createPatchDict").exists():
            self.run("createPatch", "-overwrite")

    def check_mesh(self):
        """The log of checkMesh with all its checks."""
        return self.run("checkMesh", "-allTopology", "-allGeometry")
