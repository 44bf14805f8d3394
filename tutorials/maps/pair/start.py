# SPDX-License-Identifier: GPL-3.0-or-later
"""In the folder of a state of system/runsDict: the places at its start."""

import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.environ["STUDY"])

import pairMap

places = pairMap.places(*pairMap.STARTS[int(os.environ["STUDY_start"])])
rows = "\n".join(f"    ({x:.12g} {y:.12g} 0)" for x, y in places)
with open("constant/places", "w") as file:
    file.write(f"{len(places)}\n(\n{rows}\n)\n")
