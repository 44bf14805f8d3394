# SPDX-License-Identifier: GPL-3.0-or-later
"""Time per step of the benchmark `cost`, by parts."""

import sys
from types import SimpleNamespace

import pytest
from leagueCase import BENCHMARKS, stand_in

sys.path.append(str(BENCHMARKS/"cost"))

from foamCase import FoamError  # noqa: E402
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


def test_the_clock_is_read_at_the_ends_of_steps(tmp_path):
    program = stand_in(tmp_path, """
        import time
        for step in range(3):
            print("Time =", step, flush=True)
            time.sleep(0.2)
            print("ExecutionTime = 0.01 s", flush=True)
    """)
    case = SimpleNamespace(path=tmp_path)
    memory, clock = TimedRun.execute(case, [str(program)], 1)
    assert len(clock) == 3 and memory > 0
    assert clock[2] - clock[0] == pytest.approx(0.4, abs=0.15)
    assert (tmp_path/"log").read_text().count("ExecutionTime") == 3


def test_a_failed_run_is_an_error(tmp_path):
    program = stand_in(tmp_path, "raise SystemExit(1)")
    with pytest.raises(FoamError):
        TimedRun.execute(SimpleNamespace(path=tmp_path), [str(program)], 1)
