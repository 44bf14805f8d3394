# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of function objects: none of a run that is only checked, and all of one
that ends early."""

import json

import pytest

from bodyCase import BodyCase
from boxMesh import uniform
from foamCase import FoamError

FUNCTIONS = """functions
{
    sensor
    {
        type    opticalSensor;
        libs    (immersedBodyFunctionObjects);
        planes  { middle { point (0 0 0); normal (1 0 0); } }
    }
    surfaces
    {
        type    immersedBodySurfaces;
        libs    (immersedBodyFunctionObjects);
        writeControl writeTime;
    }"""
LEAVES = """
    disc
    {
        shape       { type disc; radius 0.25; }
        position    (2.6 0 0);
        motion      { type prescribed; velocity (20 0 0); }
    }
"""


@pytest.fixture
def tube(tmp_path):
    case = BodyCase("tube", tmp_path)
    case.mesh(uniform(-3, 3, 60), uniform(-1, 1, 20))
    case.controls(endTime="0.04")
    case.replace("system/controlDict", "functions\n{", FUNCTIONS)
    return case


def series(case):
    """Times of the surfaces for ParaView."""
    folder = case.path / "postProcessing/surfaces"
    files = json.loads((folder / "bodies.vtp.series").read_text())["files"]
    assert all((folder / file["name"]).exists() for file in files)
    return [file["time"] for file in files]


def test_a_check_leaves_no_files(tube):
    tube.run("foamRun", "-check")
    assert not list(tube.path.glob("postProcessing/*/*/*.dat"))
    assert not list(tube.path.glob("postProcessing/*/*.vtp"))

    tube.run("foamRun")
    names = {f.name for f in tube.path.glob("postProcessing/*/0/*.dat")}
    assert "immersedBodyMotion.dat" in names
    assert "passages.dat" in names
    assert not [name for name in names if name.endswith("_0.dat")]


def test_the_first_step_is_adjusted_with_a_sensor(tube):
    tube.controls(adjustTimeStep="yes", maxCo="0.1")

    tube.run("foamRun")

    assert len(tube.table("motion")["time"]) > 3


def test_surfaces_at_the_start(tube):
    tube.run("foamRun")

    assert series(tube)[0] == 0


def test_all_is_written_at_an_early_stop(tube):
    tube.bodies(LEAVES)
    tube.controls(endTime="0.2")

    with pytest.raises(FoamError, match="Stopped at time 0.04"):
        tube.run("foamRun")

    assert series(tube) == [0, 0.04]
    assert tube.table("motion")["time"][-1] == pytest.approx(0.04)
    assert (tube.path / "0.04/bodyFraction").exists()


def test_a_check_at_rest(tube):
    head = (tube.path / "0.orig/U").read_text().split("boundaryField")[0]
    (tube.path / "0/U").write_text(
        head + "boundaryField { \".*\" { type noSlip; }"
        " frontAndBack { type empty; } }"
    )
    tube.bodies(LEAVES.split("motion")[0] + "motion { type fixed; } }")

    assert "Courant number of 1" not in tube.run("foamRun", "-check")


def test_a_check_tells_of_traffic(tube):
    tube.bodies(LEAVES, """
        leaving { outlet { type remove; } }
        injection { seeds { shape { type disc; radius 0.2; } densityRatio 2;
            position (0 0 0); rate 1; } }
    """)

    log = tube.run("foamRun", "-check")

    assert "injectors" in log and "seeds" in log
    assert "outlet remove" in log
    assert "Courant number of 1:  fluid" in log
