# SPDX-License-Identifier: GPL-3.0-or-later
"""Time per step of the benchmark `cost`, by parts."""

import sys

import pytest
from leagueCase import BENCHMARKS

sys.path.append(str(BENCHMARKS/"cost"))

from timedRun import BODIES, STEPS, TimedRun  # noqa: E402

pytestmark = pytest.mark.fast

# Name, that above it, and seconds
PROFILE = (
    ("application::main", None, 20),
    ("time.run() c", 0, 10),
    ("momentumPredictor", 1, 4),
    ("resolvedBodies::updateFrame", 2, 1),
    ("resolvedBodies::updateResistance", 3, 0.5),
    ("momentumEquation::solveInBands", 2, 0.75),
    ("resolvedBodies::updateResistance", 5, 0.25),
    ("pressureCorrector", 1, 3),
    ("immersedBodies::shieldFlux", 7, 0.125),
    ("immersedBodies::predict", 1, 2),
)


def test_parts_of_a_step(tmp_path):
    file = tmp_path/"profiling"
    file.write_text("\n".join(
        f"id {i}; " + ("" if above is None else f"parentId {above}; ")
        + f'description "{name}"; calls 2; totalTime {seconds}; childTime 0;'
        for i, (name, above, seconds) in enumerate(PROFILE)
    ))
    assert TimedRun.profile(file) == {
        STEPS: 10, "momentumPredictor": 2.75, "pressureCorrector": 2.875,
        BODIES: 1 + 0.25 + 0.125 + 2,
    }
