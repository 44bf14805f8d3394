# SPDX-License-Identifier: GPL-3.0-or-later
"""In the folder of a state: system/blockMeshDict, with cells that are equal
about the disc."""

import os
import sys
from pathlib import Path
from types import SimpleNamespace

sys.path.append(os.environ["GRAINFOAM_DIR"] + "/tests/regression")

import boxMesh
from bodyCase import PATCHES
from boxMesh import around, graded

RADIUS = 0.065

# Growth of 8 % from 4 radii on makes |y| half a percent larger
CORE, GROWTH = 6.4*RADIUS, 1.04

cells, height, offset = (
    float(os.environ[f"STUDY_{name}"])
    for name in ("cells", "height", "offset")
)
h = 2*RADIUS/cells
boxMesh.write(
    SimpleNamespace(path=Path()),
    graded(-3, 3, around(0, CORE, h), h, GROWTH),
    graded(-1, 1, around(offset - height, CORE, h), h, GROWTH),
    patches=PATCHES["tube"],
)
