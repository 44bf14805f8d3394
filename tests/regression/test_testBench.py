# SPDX-License-Identifier: GPL-3.0-or-later
"""The test bench: meshes from its parameters, friction of a smooth tube."""

import math
import re
import subprocess
import sys

import pytest
from benchCase import BENCH, BenchCase, periodicFriction
from friction import blasius, colebrook


def failed_checks(log):
    return re.findall(r"\*\*\*.*", log)


def patches(case):
    """{name: number of faces}"""
    text = (case.path/"constant/polyMesh/boundary").read_text()
    return {name: int(number) for name, number in re.findall(
        r"(\w+)\s*\{[^}]*nFaces\s+(\d+)", text)}


def volume(log):
    return float(re.search(r"Total volume = (\S+)\.\s", log)[1])


@pytest.mark.parametrize("piece, changes", [
    ("distributionHead", ["head.blocked=3"]),
    ("drill", ["head.blocked=3"]),
    ("drill", ["drill.bendRadius=0.1", "drill.across=4", "head.height=0.12"]),
    ("distributionHead", ["head.outlets=17", "outletTubes.diameter=0.03"]),
    ("wholeBench", ["head.outlets=20", "outletTubes.diameter=0.03",
                    "outletTubes.length=0.1", "outletTubes.bendAngle=90"]),
])
def test_head_has_a_sound_mesh(tmp_path, piece, changes):
    case = BenchCase(piece, tmp_path, ["feedPipe.length=0.1", *changes])
    log = case.check_mesh()
    outlets = dict(c.split("=") for c in changes).get("head.outlets", 12)
    assert "Mesh OK" in log
    assert not failed_checks(log)

    expected = {f"outlet{i + 1}" for i in range(int(outlets))}
    if "head.blocked=3" in changes:
        expected.remove("outlet3")
    assert set(patches(case)) == {"fanInlet", "walls", *expected}


def test_bend_has_the_volume_of_a_torus(tmp_path):
    """Of inscribed polygons: less by a known factor; n sides per quarter."""
    changes = ["mesh.resolution=3", "bend.angle=60", "bend.radius=0.05"]
    case = BenchCase("bend", tmp_path, changes)
    log = case.check_mesh()
    assert "Mesh OK" in log and not failed_checks(log)

    sides, a = 48, 0.0175
    section = 0.5*sides*math.sin(2*math.pi/sides)*a**2
    angle = math.pi/3
    n = round(0.05*angle/(0.5*0.035/3))
    step = angle/n
    # A sector of straight pieces, about the same axis
    bent = section*0.05*n*math.sin(step)
    assert volume(log) == pytest.approx(section*(0.175 + 0.7) + bent, rel=1e-4)


def test_smooth_tube_has_the_friction_of_Blasius(tmp_path):
    for U, tolerance in ((4.31, 0.05), (8.62, 0.02)):
        case = BenchCase(
            "periodicTube", tmp_path, [f"air.tubeVelocity={U}"], f"U{U}")
        case.run("foamRun")
        Re, f, _ = periodicFriction(case.path)
        assert f == pytest.approx(blasius(Re), rel=tolerance)


def test_Colebrook_is_solved():
    """Moody's chart: Re 1e5, Ks/D 0.001; Prandtl's law of smooth tubes."""
    assert colebrook(1e5, 0.001) == pytest.approx(0.0222, abs=1e-4)
    f = colebrook(1e4)
    assert 1/math.sqrt(f) == pytest.approx(
        2*math.log10(1e4*math.sqrt(f)/2.51), rel=1e-9)


@pytest.mark.parametrize("change, message", [
    ("head.outlet=12", "did you mean outlets?"),
    ("heads.outlets=12", "did you mean head?"),
    ("head.outlets=12.5", "a whole number is wanted"),
    ("head.outlets=40", "do not fit"),
    ("head.blocked=13", "none of the 12 outlets"),
    ("mesh.wallLayer=0.3", "at most"),
    ("head.height=-0.06", "must be positive"),
    ("outlets", "SECTION.NAME=VALUE is wanted"),
])
def test_wrong_parameters_are_refused(tmp_path, change, message):
    done = subprocess.run(
        [sys.executable, str(BENCH/"common/makeMesh.py"), "distributionHead",
         change],
        cwd=tmp_path, text=True, capture_output=True,
    )
    assert done.returncode != 0
    assert message in done.stderr
    assert not list(tmp_path.iterdir())
