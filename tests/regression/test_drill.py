# SPDX-License-Identifier: GPL-3.0-or-later
"""What is read off the drill, from tables of which it is known."""

import math
import os
import re
import subprocess
import sys

import numpy as np
import pytest

from benchCase import BENCH, BenchCase

sys.path.insert(0, str(BENCH.parent/"plotting"))
os.environ.setdefault("MPLBACKEND", "Agg")

import drillStatistics  # noqa: E402

COLUMNS = ("time[s]", "plane", "body", "velocity_x[m/s]", "velocity_y[m/s]",
           "velocity_z[m/s]", "axial[m/s]", "radius[m]", "angle[deg]",
           "direction", "interval[s]", "spacing[m]", "signal", "planeName",
           "bodyName")
# Grains of each outlet in the 4 s that count; the second one is closed
COUNTS = {1: 400, 3: 200, 4: 300}


def write_case(folder):
    """A run of 5 s, of which the first does not count, with four outlets and
    evenly spaced grains that took 0.5 s."""
    (folder/"constant").mkdir()
    (folder/"constant/benchChanges").write_text(
        "head.outlets=4\nhead.blocked=2\ndrill.airAlone=0.4\n"
        "drill.filling=0.6\n")
    rows, events = [], []
    for plane, (outlet, number) in enumerate(COUNTS.items()):
        for t in np.arange(0, 5, 4/number) + 1/number:
            body = len(rows)
            rows.append((t, [plane, body, 1, 0, 0, 5, 0.01, 90, 1, 0, 0, 0,
                             f"outlet{outlet}", f"seed{body}"]))
            events += [(t - 0.5, body, "enters", "seed"),
                       (t, body, "leaves", f"outlet{outlet}")]
    # Back through a plane does not count
    rows.append((4.0005, [0, 0, -1, 0, 0, -5, 0.01, 90, -1, 0, 0, 0, "outlet1",
                          "seed0"]))
    lines = ["# Planes, by number:"]
    lines += [f"# {i}{' ':17}: outlet{n}" for i, n in enumerate(COUNTS)]
    lines.append("# " + "\t".join(COLUMNS))
    lines += ["\t".join(map(str, (f"{t:.9g}", *row)))
              for t, row in sorted(rows, key=lambda row: row[0])]
    write(folder/"postProcessing/sensor/0/passages.dat", lines)
    lines = ["# time[s]\tbody\twhat\tname\twhere"]
    lines += [f"{t:.9g}\t{body}\t{what}\tseed{body}\t{where}"
              for t, body, what, where in sorted(events)]
    write(folder/"postProcessing/immersedBodies/0/passage.dat", lines)


def write(file, lines):
    file.parent.mkdir(parents=True)
    file.write_text("\n".join(lines) + "\n")


@pytest.fixture
def run(tmp_path):
    write_case(tmp_path)
    return drillStatistics.Drill(tmp_path)


def test_shares_and_their_variation(run):
    assert run.outlets() == list(COUNTS)
    found = run.shares()
    counts = np.array(list(COUNTS.values()))
    assert found["counts"] == pytest.approx(counts, abs=1)
    value, low, high = found["variation"]
    assert value == pytest.approx(1/3, abs=0.005)
    assert low <= value <= high and high - low < 0.05
    low, high = found["interval"].T
    assert (low < counts/900).all() and (counts/900 < high).all()


def test_spacing_and_time_of_residence(run):
    spacing = run.spacing()
    assert spacing[:, :3] == pytest.approx(0, abs=1e-6)
    times = run.residence()
    assert len(times) == pytest.approx(900, abs=3)
    assert times == pytest.approx(0.5, abs=1e-6)


@pytest.mark.parametrize("total, outlets", [(1000, 12), (20000, 11)])
def test_chance(total, outlets):
    """The variance of counts is N/n."""
    mean, low, high = drillStatistics.chance(total, outlets)
    assert mean == pytest.approx(math.sqrt(outlets/total), rel=0.04)
    assert low < mean < high


@pytest.mark.parametrize("seed", ["wheat", "maize"])
def test_seeds_that_are_no_spheres_fly_through_the_pipe(tmp_path, seed):
    """Ellipsoids, not resolved, turned at random, as the roller drops them."""
    case = BenchCase("drill", tmp_path, [
        f"drill.seed={seed}", "drill.airAlone=0.02", "drill.endTime=0.05"])
    subprocess.run([sys.executable, "setUp.py"], cwd=case.path, check=True)
    log = case.run("foamRun")
    assert len(re.findall(r"Body seed\d+ enters", log)) == pytest.approx(
        0.03*12*140, rel=0.25)
    assert "Stopped at" not in log
