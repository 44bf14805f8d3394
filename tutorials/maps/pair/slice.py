# SPDX-License-Identifier: GPL-3.0-or-later
"""In the folder of a state of the study: the states of its slice."""

import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.environ["STUDY"])

import pairMap

_, states = pairMap.slice_states(float(os.environ["STUDY_yp"]))
pairMap.write_states(states)
