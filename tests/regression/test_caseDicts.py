# SPDX-License-Identifier: GPL-3.0-or-later
"""#includeFunc finds our function objects, with an OpenFOAM as it is."""

import os
import re
import subprocess
from pathlib import Path

import pytest

from bodyCase import BodyCase
from boxMesh import uniform
from foamCase import tables

pytestmark = pytest.mark.fast

ROOT = Path(__file__).resolve().parents[2]
ENTRIES = ROOT/"etc/caseDicts/postProcessing/grainFoam"
GRAIN = """
    grain
    {
        shape       { type disc; radius 0.25; }
        densityRatio 2;
        position    (-0.53 -0.3 0);
        velocity    ambient;
    }
"""


def test_all_function_objects_have_one():
    classes = {file.stem for file in ROOT.glob("src/*/*/*.C")
               if re.search(r"Table\s*\(\s*functionObject,", file.read_text())}
    assert {file.name for file in ENTRIES.iterdir()} == classes


def test_includeFunc(tmp_path):
    case = BodyCase("tube", tmp_path)
    case.mesh(uniform(-3, 3, 60), uniform(-1, 1, 20))
    case.bodies(GRAIN)
    names = sorted(file.name for file in ENTRIES.iterdir())
    lines = "".join(f"\n    #includeFunc {name}" for name in names)
    case.replace("system/controlDict", "functions\n{", "functions\n{" + lines)
    (case.path/"system/sensorPlanes").write_text(
        "near { point (-0.51 0 0); normal (1 0 0); radius 1; }\n")
    case.controls(endTime="0.04", deltaT="0.01", writeInterval="0.02")
    log = case.solve()
    assert "Cannot find functionObject" not in log

    for name in ("Motion", "Forces", "Energy"):
        columns = tables.run_columns(case.path, f"immersedBody{name}")
        assert columns["time"] == pytest.approx([0.01, 0.02, 0.03, 0.04])
    passages = tables.run_columns(case.path, "opticalSensor", "passages")
    assert list(passages["planeName"]) == ["near"]
    folder = case.path/"postProcessing/immersedBodySurfaces"
    assert len(list(folder.glob("bodies_*.vtp"))) == 3


def sourced(script, **variables):
    """Output of a script after etc/bashrc, which is sourced with variables."""
    environment = {k: v for k, v in os.environ.items()
                   if k not in ("WM_PROJECT_SITE", "GRAINFOAM_DIR")}
    return subprocess.run(
        ["bash", "-c", f'. "{ROOT}/etc/bashrc" && {script}'],
        env={**environment, **variables}, text=True, check=True,
        capture_output=True,
    )


def test_site_of_the_user_stays_and_takes_a_link(tmp_path):
    site = str(tmp_path)
    done = sourced('echo "$WM_PROJECT_SITE"', WM_PROJECT_SITE=site)
    assert done.stdout.strip() == site

    command = done.stderr.split("function objects: ", 1)[1]
    subprocess.run(["bash", "-c", command], check=True)
    assert not sourced("true", WM_PROJECT_SITE=site).stderr
    link = tmp_path/"etc/caseDicts/postProcessing/grainFoam"
    assert link.resolve() == ENTRIES


def test_another_checkout_gives_way():
    done = sourced('echo "$WM_PROJECT_SITE"', WM_PROJECT_SITE="/other",
                   GRAINFOAM_DIR="/other")
    assert done.stdout.strip() == str(ROOT)
    assert not done.stderr
