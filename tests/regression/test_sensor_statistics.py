# SPDX-License-Identifier: GPL-3.0-or-later
"""What the optical sensor makes of many passages, restart, and the pictures."""

import subprocess
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest

from bodyCase import BodyCase
from openTube import open_tube
from sensorCase import add_sensor, passages, table

PLOTTING = Path(__file__).parents[2] / "tutorials/plotting"
PICTURES = """functions
{
    surfaces
    {
        type            immersedBodySurfaces;
        libs            (immersedBodyFunctionObjects);
        writeControl    writeTime;
    }
    plane
    {
        type            surfaces;
        libs            (sampling);
        writeControl    writeTime;
        surfaceFormat   raw;
        fields          (U);
        interpolationScheme cell;
        surfaces
        (
            plane
            {
                type            plane;
                planeType       pointAndNormal;
                pointAndNormalDict { point (0 0 0); normal (0 0 1); }
                interpolate     false;
            }
        );
    }"""


def prepare(tube, folder, name="case"):
    """Fed by a roller, with a light and outlets."""
    case = BodyCase(tube, folder, name)
    case.bodies("", """
        injection
        {
            seeds
            {
                shape       { type disc; radius 0.2; }
                densityRatio 2;
                positions   ((0.3 0.6 0) (0.3 0.1 0) (0.3 -0.4 0));
                seed        2;
                roller
                {
                    revolutionsPerSecond 0.3;
                    cells       10;
                    jitter      0.4;
                    misses      0.1;
                    doubles     0.2;
                }
            }
        }
        leaving { outlet { type remove; } }
    """)
    add_sensor(case, """
        upper { point (0.7 0.5 0); normal (1 0 0); radius 0.5; }
        lower { point (0.7 -0.5 0); normal (1 0 0); radius 0.5; rate 1; }
        all   { point (0.9 0 0); normal (1 0 0); radius 1; }
    """, """rate 3; outlets (upper lower); start 0.3;
        light { thickness 0; resolution 0.02; }
        writeControl writeTime;""")
    case.controls(
        writeControl="timeStep", writeInterval="50", writePrecision="17",
        timePrecision="15", endTime="5",
    )
    return case


@pytest.fixture(scope="module")
def fed(tmp_path_factory):
    return open_tube(tmp_path_factory.mktemp("fed"))


def statistics(case, folder="."):
    time = case.latest_time(folder)
    file = case.path / folder / time / "uniform/opticalSensor.sensor"
    return file.read_text().split("// * *", 1)[1]


@pytest.mark.parametrize("ranks", [1, 2])
def test_restart_is_exact(ranks, fed, tmp_path):
    at_once = prepare(fed, tmp_path, "atOnce")
    if ranks > 1:
        at_once.decompose(ranks)
    in_parts = BodyCase(at_once, tmp_path, "inParts")
    folder = "processor0" if ranks > 1 else "."

    at_once.solve(ranks)
    times = at_once.times(folder)[1:]
    assert len(times) == 5
    for time in times:
        in_parts.controls(endTime=time)
        in_parts.solve(ranks)

    assert statistics(in_parts, folder) == statistics(at_once, folder)
    rows, parts = passages(at_once), passages(in_parts)
    assert len(rows) > 15
    for a, b in zip(rows, parts, strict=True):
        assert a.time == pytest.approx(b.time, abs=1e-12)
        assert (a.body, a.plane, a.signal) == (b.body, b.plane, b.signal)
        assert a.interval == pytest.approx(b.interval, abs=1e-11, nan_ok=True)

    # The names of times, sums of time steps, may differ in the last digit
    at_once_end, end = times[-1], in_parts.latest_time(folder)

    # All that there is to go wrong has been there
    summary = table(at_once, at_once_end, "summary")
    assert summary["doubles"][2] > 0
    assert summary["misses"][2] > 0
    for name in ("summary", "radii", "intervals", "outlets"):
        a, b = table(at_once, at_once_end, name), table(in_parts, end, name)
        for column in a:
            if column != "name":
                assert a[column] == pytest.approx(
                    b[column], rel=1e-12, nan_ok=True
                ), column


@pytest.fixture(scope="module")
def solved(fed, tmp_path_factory):
    case = prepare(fed, tmp_path_factory.mktemp("solved"))
    case.replace("system/controlDict", "functions\n{", PICTURES)
    case.solve()
    return case


def test_tables_are_those_of_the_passages(solved):
    case = solved
    end = case.latest_time()
    rows = [r for r in passages(case) if r.time >= 0.3]
    summary = table(case, end, "summary")
    intervals = table(case, end, "intervals")
    outlets = table(case, end, "outlets")

    for k, plane in enumerate(("upper", "lower", "all")):
        mine = [r for r in rows if r.plane == plane]
        # The first grain of each signal
        seen = {r.signal: r.time for r in reversed(mine)}
        times = np.array(sorted(seen.values()))
        x = np.diff(times)*(1 if plane == "lower" else 3)
        assert summary["grains"][k] == len(mine) > 3
        assert summary["signals"][k] == len(seen)
        assert summary["hidden"][k] == len(mine) - len(seen)
        assert summary["multiples"][k] == sum(x <= 0.5)
        assert summary["misses"][k] == sum(x > 1.5)
        assert summary["variationOfInterval"][k] == pytest.approx(
            x.std(ddof=1)/x.mean()
        )
        T = float(end) - 0.3
        assert summary["duration"][k] == pytest.approx(T)
        assert summary["doubleRate"][k] == pytest.approx(
            summary["doubles"][k]/T
        )
        counted = intervals["plane"] == k
        assert intervals["number"][counted] == pytest.approx(np.histogram(
            x, np.append(0, np.append(np.arange(0.05, 3, 0.1), np.inf))
        )[0])
        speeds = [r.axial for r in mine]
        assert summary["meanSpeed"][k] == pytest.approx(np.mean(speeds))
        assert summary["deviationOfSpeed"][k] == pytest.approx(
            np.std(speeds, ddof=1)
        )

    n = summary["grains"][:2]
    assert outlets["share"] == pytest.approx(n/n.sum())
    title = (
        case.path / f"postProcessing/sensor/{end}/outlets.dat"
    ).read_text().splitlines()[0]
    assert float(title.split()[-1]) == pytest.approx(
        n.std(ddof=1)/n.mean(), rel=1e-4
    )


def test_pictures(solved):
    """The scripts find what they draw, of each of the planes."""
    for script, *arguments in (
        ("sensorPlots",), ("animate", "-frames", "3"),
    ):
        subprocess.run(
            [sys.executable, PLOTTING / f"{script}.py", solved.path,
             *arguments], check=True,
        )
    plots = solved.path / "plots"
    # How much of the paper stays white; letters differ by version
    white = {
        "sensorSpeed.png": 0.91, "sensorDensity.png": 0.91,
        "sensorSpacing.png": 0.43, "sensorMisses.png": 0.75,
        "sensorOutlets.png": 0.55,
    }
    frames = [f"animation/frame{i:04d}.png" for i in range(3)]
    for name in (*white, *frames):
        picture = plt.imread(plots / name)
        share = (picture[:, :, :3] == 1).all(axis=2).mean()
        assert share == pytest.approx(white.get(name, 0.35), abs=0.06), name

    # Grains, grey, are where they are at that time
    last = plt.imread(plots / frames[2])
    assert (np.abs(last[:, :, :3] - 0.93) < 0.01).all(axis=2).sum() > 500
    assert (plots / "animation.gif").stat().st_size > 5000
