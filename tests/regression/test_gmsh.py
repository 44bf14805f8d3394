# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of the test bench's head by gmsh: of its parameters, of a STEP file."""

import importlib.util
import os
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest

from benchCase import BENCH, BenchCase
from bodyCase import GRAVITY
from test_testBench import patches, volume

needs_gmsh = pytest.mark.skipif(
    not importlib.util.find_spec("gmsh"),
    reason="the python module of gmsh is not installed: etc/setup-debian -gmsh")

BALL = """FoamFile
{
    version     2.0;
    format      ascii;
    class       dictionary;
    object      immersedBodyProperties;
}

rho     1.2;
bodies
{
    ball
    {
        shape       { type sphere; radius 0.02; }
        density     60;
        position    (0.01 0.005 0.025);
    }
}
contact { type softSphere; }
"""

# A small and coarse head
HEAD = ["head.outlets=4", "head.diameter=0.16", "feedPipe.length=0.1",
        "outletTubes.shortLength=0.05", "gmsh.across=4"]
ALL = {"fanInlet", "walls", *(f"outlet{i}" for i in range(1, 5))}


def gmsh_mesh(folder, *arguments, **environment):
    """The script by itself: return code, and what it prints."""
    done = subprocess.run(
        [sys.executable, str(BENCH/"common/gmshMesh.py"),
         *map(str, arguments)], cwd=folder, text=True, capture_output=True,
        env={**os.environ, **environment})
    return done.returncode, done.stdout + done.stderr


def hexahedra(folder, changes):
    """Volume of the same head [m3]."""
    plain = [c for c in changes if not c.startswith("gmsh.")]
    case = BenchCase("distributionHead", folder, plain, "hexahedra")
    return volume(case.run("checkMesh"))


@pytest.fixture(scope="module")
def head(tmp_path_factory):
    """With an outlet that is blocked."""
    return BenchCase(
        "distributionHead", tmp_path_factory.mktemp("head"),
        [*HEAD, "head.blocked=2"], "case", "gmshMesh")


@needs_gmsh
def test_head_is_that_of_the_hexahedral_mesh(head, tmp_path):
    log = head.run("checkMesh")
    assert "Mesh OK" in log
    assert set(patches(head)) == ALL - {"outlet2"}
    assert volume(log) == pytest.approx(
        hexahedra(tmp_path, HEAD), rel=0.02)


@needs_gmsh
def test_air_flows_through_it(head, tmp_path):
    """Stable at the Courant numbers of the tutorial, and what comes in goes
    out."""
    case = head.copy(tmp_path, "run")
    (tmp_path/"common").symlink_to(BENCH/"common")
    control = case.path/"system/controlDict"
    control.write_text(control.read_text().replace(
        "endTime         0.2;", "endTime         0.02;"))
    case.run("foamRun")
    rates = [case.read_dat(
        f"postProcessing/outlet{i}/0/surfaceFieldValue.dat")[-1, 1]
        for i in (1, 3, 4)]
    area = np.pi*0.05**2
    assert sum(rates) == pytest.approx(10*area, rel=0.02)
    # The two beside the blocked one are alike
    assert rates[0] == pytest.approx(rates[1], rel=0.1)
    assert all(0.25 < rate/sum(rates) < 0.4 for rate in rates)


@needs_gmsh
def test_bent_tubes_are_swept(tmp_path):
    changes = [*HEAD, "outletTubes.length=0.1", "outletTubes.bendAngle=60",
               "outletTubes.bendRadius=0.1", "outletTubes.endLength=0.05",
               "mesh.alongOutletTubes=0.5"]
    case = BenchCase("wholeBench", tmp_path, changes, "gmsh", "gmshMesh")
    log = case.run("checkMesh")
    assert "Mesh OK" in log
    assert set(patches(case)) == ALL

    plain = [c for c in changes if not c.startswith("gmsh.")]
    other = BenchCase("wholeBench", tmp_path, plain, "hexahedra")
    assert volume(log) == pytest.approx(
        volume(other.run("checkMesh")), rel=0.02)


@pytest.fixture(scope="module")
def step(tmp_path_factory):
    """The head as a STEP file."""
    folder = tmp_path_factory.mktemp("step")
    code, text = gmsh_mesh(
        folder, "distributionHead", "-writeStep", "head.step", *HEAD)
    assert code == 0, text
    return folder/"head.step"


@needs_gmsh
@pytest.mark.parametrize("faces", [False, True], ids=["as bench.ini", "faces"])
def test_head_from_a_STEP_file(faces, step, tmp_path):
    assert "MILLI" in step.read_text()

    options = ["-step", step]
    if faces:
        # Other names: what is not listed is a wall
        places = tmp_path/"places"
        places.write_text("# the air\nfanInlet 0 0 -0.1\n"
                          "outlet1 -0.165 0 0.03\noutlet2 0 0.165 0.03\n")
        options += ["-faces", places]
    case = BenchCase("distributionHead", tmp_path, [
        *options, *HEAD, "gmsh.walls=0.7"], "step", "gmshMesh")
    log = case.run("checkMesh")
    assert "Mesh OK" in log
    expected = {"fanInlet", "walls", "outlet1", "outlet2"} if faces else ALL
    assert set(patches(case)) == expected
    assert volume(log) == pytest.approx(hexahedra(tmp_path, HEAD), rel=0.02)


@needs_gmsh
def test_resolved_grain_in_tetrahedra(step, tmp_path):
    """A free sphere in the head: the flow stays as it is from step to step, and
    all of them converge."""
    case = BenchCase("distributionHead", tmp_path, ["-step", step, *HEAD],
                     "step", "gmshMesh")
    (case.path/"constant/g").write_text(GRAVITY.format(0, 0, -9.81))
    (case.path/"constant/immersedBodyProperties").write_text(BALL)
    control = case.path/"system/controlDict"
    text = control.read_text()
    for old, new in (("adjustTimeStep  yes", "adjustTimeStep  no"),
                     ("deltaT          1e-4", "deltaT          2e-5"),
                     ("endTime         0.2", "endTime         6e-4")):
        assert old in text
        text = text.replace(old, new)
    control.write_text(text)
    log = case.run("foamRun")

    assert log.count("Progress: step") == 30
    assert "not converged" not in log
    courant = [float(c) for c in re.findall(r"Courant Number.*max: (\S+)", log)]
    assert max(courant[5:]) < 1.2*courant[5]


@needs_gmsh
def test_openings_that_are_not_there_are_refused(step, tmp_path):
    code, text = gmsh_mesh(
        tmp_path, "distributionHead", "-step", step, *HEAD,
        "outletTubes.shortLength=0.3")
    assert code != 0
    assert "no plane face has its centre at that of outlet1" in text
    assert "\n  0.165 " in text
    assert not list(tmp_path.iterdir())


@needs_gmsh
def test_command_refuses_wrong_arguments_before_it_removes_results(tmp_path):
    bench = tmp_path/"bench"
    shutil.copytree(BENCH, bench)
    old = bench/"gmshHead.gmsh"
    old.mkdir(exist_ok=True)
    for arguments, message in (
        (["head.outlet=4"], "did you mean outlets?"),
        (["head.outlets=40"], "do not fit"),
        (["-step", "none.step"], "there is no file"),
        (["-faces"], "there is no file"),
        (["-stp", "head.step"], "-parallel or SECTION.NAME=VALUE is wanted"),
    ):
        done = subprocess.run(
            [bench/"gmshHead/Allrun", *arguments], text=True,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        assert done.returncode != 0
        assert message in done.stdout
        assert old.exists()


@pytest.mark.parametrize("arguments, message", [
    (["measuringTube"], "is not one of distributionHead wholeBench"),
    (["distributionHead", "-stp", "head.step"], "did you mean -step?"),
    (["distributionHead", "-step", "head.step"], "there is no file"),
    (["distributionHead", "-faces", __file__], "goes with -step"),
    (["distributionHead", "-writeStep"], "a file is wanted"),
])
def test_wrong_arguments_are_refused(arguments, message, tmp_path):
    code, text = gmsh_mesh(tmp_path, *arguments)
    assert code != 0
    assert message in text
    assert not list(tmp_path.iterdir())


def test_it_says_that_gmsh_is_missing(tmp_path):
    modules = tmp_path/"modules"
    modules.mkdir()
    (modules/"gmsh.py").write_text("raise ImportError\n")
    code, text = gmsh_mesh(
        tmp_path, "distributionHead", *HEAD, PYTHONPATH=str(modules))
    assert code != 0
    assert "gmsh is missing: on Debian, etc/setup-debian -gmsh" in text
    assert not list(tmp_path.glob("*.msh"))
