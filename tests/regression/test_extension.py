# SPDX-License-Identifier: GPL-3.0-or-later
"""Models of a library that the case names: tests/extension."""

import shutil
import subprocess
from pathlib import Path

import pytest

import refusals
from bodyCase import BodyCase
from boxMesh import uniform

SOURCE = Path(__file__).parents[1] / "extension"
SHAPE = "type capsule; cap 0.02; straight 0.02;"
LAW = "law cone; restitution 1; friction 0; reducedModulus 1e8;"
DRAG = "type constant; coefficient 0.5;"


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    """Path of the library, built beside a copy of its sources."""
    folder = tmp_path_factory.mktemp("build") / "extension"
    shutil.copytree(
        SOURCE, folder, ignore=shutil.ignore_patterns("linux*", "lnInclude")
    )
    files = folder / "Make/files"
    text = files.read_text()
    assert text.count("$(FOAM_USER_LIBBIN)") == 1
    files.write_text(text.replace("$(FOAM_USER_LIBBIN)", str(folder)))
    done = subprocess.run(
        ["wmake", "-s", folder], text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
    )
    assert done.returncode == 0, done.stdout
    assert "warning" not in done.stdout
    return folder / "libgrainExtension.so"


def capsule(library, folder, name, shape=SHAPE, law=LAW, drag=DRAG):
    """A grain smaller than the cells that flies to a wall and back."""
    case = BodyCase("box", folder, name)
    case.mesh(*3*[uniform(-0.75, 0.75, 12)])
    case.bodies(
        f"grain {{ shape {{ {shape} }} densityRatio 1000;"
        " position (0.5 0.03 0.02); velocity (6 0 0); }",
        f"rho 1; contact {{ type softSphere; {law} }}"
        f"coupling {{ type unresolved; dragModel {{ {drag} }} }}",
    )
    case.controls(endTime=0.06, deltaT=0.005, libs=f'("{library}")')
    return case


def test_shape_law_and_drag_of_a_library(library, tmp_path):
    lost = []
    for coefficient in (0.5, 1):
        case = capsule(
            library, tmp_path, f"drag{coefficient}",
            drag=f"type constant; coefficient {coefficient};",
        )
        log = case.solve()
        assert "softSphere, cone, restitution 1, friction 0" in log
        assert "drag of constant" in log

        speed = case.table("motion")["velocity_x"]
        before, after = speed[speed > 0], speed[speed < 0]
        lost.append(6 - before[5])

        # Elastic: what the drag takes in a step is less than this
        assert after[0] == pytest.approx(-before[-1], rel=1e-3)

    assert lost[0] > 0.005
    assert lost[1] == pytest.approx(2*lost[0], rel=0.01)


WRONG = [
    ("shape", "type capsul; cap 0.02; straight 0.02;",
     "nearest valid one is 'capsule'"),
    ("shape", SHAPE + " radius 1;", "Unknown keyword 'radius'"),
    ("law", LAW + " halfAngel 50;", "nearest valid one is 'halfAngle'"),
    ("law", LAW + " stiffness 5;", "Unknown keyword 'stiffness'"),
    ("law", LAW.replace("law cone", "law con"),
     "nearest valid one is 'cone'"),
    ("drag", DRAG + " coeficient 1;", "nearest valid one is 'coefficient'"),
]


@pytest.fixture(scope="module")
def refused(library, tmp_path_factory):
    folder = tmp_path_factory.mktemp("refused")
    right = {"shape": SHAPE, "law": LAW, "drag": DRAG}
    return refusals.of_copies(capsule(library, folder, "right"), folder, {
        text: lambda case, part=part, text=text: case.replace(
            "constant/immersedBodyProperties", right[part], text
        )
        for part, text, _ in WRONG
    })


@pytest.mark.parametrize("text, message", [wrong[1:] for wrong in WRONG])
def test_wrong_entries_of_the_library(text, message, refused):
    refused[text].names(message)


def test_injection_scales_a_shape_of_the_library(library, tmp_path):
    case = capsule(library, tmp_path, "sizes")
    properties = case.path / "constant/immersedBodyProperties"
    properties.write_text(
        properties.read_text()
        + f"injection {{ seeds {{ shape {{ {SHAPE} }} densityRatio 1000;"
        " size 2; position (0.4 -0.3 0); velocity (6 0 0); times (0); } }\n"
    )
    case.controls(endTime=0.08)
    case.solve()

    # What the wall takes from each, by their masses
    impulses = [
        sum(case.table("forces", body)["contactForce_x"]) for body in (0, 1)
    ]
    assert impulses[0] < 0
    assert impulses[1] == pytest.approx(8*impulses[0], rel=0.03)
