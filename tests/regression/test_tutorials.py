# SPDX-License-Identifier: GPL-3.0-or-later
"""Scripts of the tutorials: they run anywhere, and refuse wrong arguments before
they remove anything."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BENCH = ROOT/"tutorials/testBench3D"


def call(*command, sourced=True, **options):
    """Output and return code of a command, with etc/bashrc sourced or not."""
    environment = {k: v for k, v in os.environ.items()
                   if sourced or k not in ("GRAINFOAM_DIR", "PYTHONPATH")}
    return subprocess.run(
        [*map(str, command)], env=environment, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options)


@pytest.fixture
def elsewhere(tmp_path):
    """A copy of a tutorial, with two steps to make."""
    case = tmp_path/"copy"
    shutil.copytree(ROOT/"tutorials/tube2D/freeGrain", case)
    control = case/"system/controlDict"
    text = control.read_text()
    for entry, value in (("endTime", 0.005), ("writeInterval", 0.005)):
        text = re.sub(rf"(?m)^{entry} .*;", f"{entry} {value};", text)
    control.write_text(text)
    return case


def test_a_copy_of_a_tutorial_runs(elsewhere):
    done = call(elsewhere/"Allrun")
    assert done.returncode == 0, done.stdout
    assert (elsewhere/"plots/velocity.png").exists()

    # A picture drawn anew, by itself
    done = call(os.environ["GRAINFOAM_PYTHON"], "plot.py", cwd=elsewhere)
    assert done.returncode == 0, done.stdout
    assert call(elsewhere/"Allclean").returncode == 0
    assert not (elsewhere/"plots").exists()


def test_a_copy_says_what_to_source(elsewhere):
    for script in ("Allrun", "Allclean"):
        done = call(elsewhere/script, sourced=False)
        assert done.returncode != 0
        assert "Source etc/bashrc of grainFoam first" in done.stdout
    done = call(os.environ["GRAINFOAM_PYTHON"], "plot.py", cwd=elsewhere,
                sourced=False)
    assert done.returncode != 0
    assert "# source etc/bashrc of grainFoam" in done.stdout


def test_tutorials_folder_without_the_rest_says_so(tmp_path):
    case = tmp_path/"tutorials/tube2D/freeGrain"
    shutil.copytree(ROOT/"tutorials/tube2D/freeGrain", case)
    shutil.copy(ROOT/"tutorials/RunFunctions", tmp_path/"tutorials")
    done = call(case/"Allrun", sourced=False)
    assert done.returncode != 0
    assert "source its etc/bashrc first" in done.stdout


def test_all_scripts_find_the_functions():
    for script in ROOT.glob("tutorials/**/All*"):
        text = script.read_text()
        assert "RunFunctions" not in text or "GRAINFOAM_DIR:-" in text, script


@pytest.mark.parametrize("piece, argument, message", [
    ("grains", "air.tubVelocity=16", "did you mean tubeVelocity?"),
    ("grains", "air.tubeVelocity=-1", "must be positive"),
    ("grains", "-paralel", "'-paralel': -parallel or SECTION.NAME=VALUE"),
    ("headGrains", "head.blocked=13", "none of the 12 outlets"),
    ("drill", "drill.seed=whaet", "did you mean wheat?"),
    ("drill", "drill.bendRadius=0.05", "one diameter of the feed pipe"),
])
def test_results_outlive_a_wrong_argument(tmp_path, piece, argument, message):
    shutil.copy(BENCH/"bench.ini", tmp_path)
    for folder in ("common", "distributionHead", piece):
        shutil.copytree(BENCH/folder, tmp_path/folder)
    case = tmp_path/piece
    results = [case/name for name in ("1.5/U", "plots/sensorSpeed.png",
                                      "log.foamRun", "constant/benchChanges")]
    for file in results:
        file.parent.mkdir(exist_ok=True)
        file.write_text("of an earlier run")

    done = call(case/"Allrun", argument)
    assert done.returncode != 0
    assert message in done.stdout
    assert [file.read_text() for file in results] == ["of an earlier run"]*4
