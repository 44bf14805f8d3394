# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases to start from: copies of etc/templates run, and write what they say."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from foamCase import tables

ROOT = Path(__file__).resolve().parents[2]
TEMPLATES = sorted(
    file.parent.name for file in ROOT.glob("etc/templates/*/README.md"))


def new_case(*arguments, cwd=None):
    return subprocess.run(
        [ROOT/"bin/grainFoamNewCase", *map(str, arguments)], cwd=cwd,
        text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def shorten(case, steps):
    """End after some time steps, and write the last one."""
    file = case/"system/controlDict"
    text = file.read_text()
    step = float(re.search(r"(?m)^deltaT +(\S+);", text)[1])
    for entry, value in (("endTime", steps*step), ("adjustTimeStep", "no"),
                         ("writeInterval", steps*step)):
        text = re.sub(rf"(?m)^{entry} .*;", f"{entry} {value};", text)
    file.write_text(text)


@pytest.mark.parametrize("name", TEMPLATES)
@pytest.mark.parametrize("arguments", [[], ["-parallel"]])
def test_a_copy_runs(tmp_path, name, arguments):
    if name == "grainsInPipe" and not shutil.which("gmsh"):
        pytest.skip("gmsh is not installed")
    case = tmp_path/"work/case"
    assert new_case(name, case).returncode == 0
    shorten(case, 3)
    done = subprocess.run(
        [case/"Allrun", *arguments], text=True, cwd=tmp_path,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode == 0, done.stdout
    log = (case/"log.foamRun").read_text()
    assert "Warning" not in log and "not converged" not in log

    if (case/"constant/immersedBodyProperties").read_text().count("\nbodies"):
        motion = tables.read_tables(case, "immersedBodyMotion")
        assert len(set(motion["time"])) == 3
    surfaces = case/"postProcessing/immersedBodySurfaces"
    assert (surfaces/"bodies.vtp.series").exists()

    # Not a second time over its results, which it would go on from
    again = subprocess.run(
        [case/"Allrun", *arguments], text=True, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT)
    assert again.returncode != 0 and "./Allclean" in again.stdout

    subprocess.run([case/"Allclean"], check=True)
    left = {p.name for p in case.iterdir()}
    assert {"0", "Allrun"} <= left <= {
        "0", "constant", "system", "Allrun", "Allclean", "README.md",
        "pipe.geo"}


def test_pipe_says_that_gmsh_is_missing(tmp_path):
    new_case("grainsInPipe", tmp_path/"case")
    path = tmp_path/"path"
    path.mkdir()
    for folder in ("/usr/bin", "/bin"):
        for program in Path(folder).iterdir():
            link = path/program.name
            if program.name != "gmsh" and not link.is_symlink():
                link.symlink_to(program)
    done = subprocess.run(
        ["bash", tmp_path/"case/Allrun"], text=True,
        # Of the OpenFOAM that is sourced: without it Debian's is set up
        env={**os.environ, "PATH": str(path), "GRAINFOAM_DIR": str(ROOT)},
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode != 0
    assert "apt-get install gmsh" in done.stdout


def test_templates_are_listed():
    done = new_case()
    assert done.returncode == 0
    for name in TEMPLATES:
        title = (ROOT/"etc/templates"/name/"README.md").read_text()
        assert f"{title.splitlines()[0][2:]}\n" in done.stdout
        assert name in done.stdout


@pytest.mark.parametrize("arguments, message", [
    (("sphereinBox", "case"), "no template 'sphereinBox': it is one of grains"),
    (("../templates", "case"), "no template"),
    (("sphereInBox", "there"), "'there' exists"),
    (("sphereInBox",), "usage: grainFoamNewCase TEMPLATE DIR"),
])
def test_wrong_arguments_are_refused(tmp_path, arguments, message):
    (tmp_path/"there").mkdir()
    done = new_case(*arguments, cwd=tmp_path)
    assert done.returncode != 0
    assert message in done.stdout
    assert [p.name for p in tmp_path.iterdir()] == ["there"]
    assert not list((tmp_path/"there").iterdir())
