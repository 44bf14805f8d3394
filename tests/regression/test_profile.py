# SPDX-License-Identifier: GPL-3.0-or-later
"""Undisturbed profiles at an inlet (tubeProfile), and bodies that begin with
them."""

import numpy as np
import pytest

import refusals
import roundTube
from bodyCase import BodyCase
from boxMesh import uniform
from wallFlow import CASE, WallFlow, rough_profile, steps

WALLS = {"smooth": (None, 0), "rough": (2, 0), "driven": (2, 3)}


def profile(r, a, K, round_tube):
    """Velocity of mean speed 1 in a tube of half width 1."""
    if not round_tube:
        return rough_profile(r, a, K, 2) if a else 1.5*(1 - r**2)
    B = 2*(a - K)/(4 + a) if a else 2
    return 1 - B/2 + B*(1 - r**2)


def entries(a, K):
    return f"a {a}; K {K};" if a else ""


def tube(folder, name, entry, h=0.1):
    """A short tube of radius 1 along x."""
    case = WallFlow(CASE, folder, name)
    roundTube.write(case, uniform(0, 0.4, 2), h)
    case.run("blockMesh")
    case.condition("inlet", f"type tubeProfile; {entry}")
    return case


@pytest.fixture
def plates(tmp_path):
    """A tube between plates, and what its undisturbed flow is set with."""
    case = BodyCase("tube", tmp_path)
    case.mesh(uniform(-3, 3, 60), uniform(-1, 1, 40))
    case.controls(writeFormat="ascii", writePrecision="15")
    return case


def set_inlet(case, entry):
    path = case.path / "0/U"
    text = (case.path / "0.orig/U").read_text()
    begin, end = text.index("    inlet\n"), text.index("    outlet")
    path.write_text(
        f"{text[:begin]}    inlet {{ type tubeProfile; {entry} }}\n"
        f"{text[end:]}"
    )


@pytest.mark.parametrize("walls", WALLS)
def test_round_tube(walls, tmp_path):
    """It stays what it is along the tube, to the error of the mesh."""
    a, K = WALLS[walls]
    case = tube(tmp_path, "tube", f"meanVelocity 1; {entries(a, K)}")
    case.condition("outlet", "type zeroGradient;", "U")
    case.condition("inlet", "type zeroGradient;", "p")
    if a:
        case.condition(
            "walls", f"type robinVelocity; a {a}; K ({K} 0 0);"
        )
    else:
        case.condition("walls", "type noSlip;")
    steps(case, 100, 0.02)
    case.run("foamRun")
    x = case.centres("inlet")
    exact = profile(np.hypot(x[:, 1], x[:, 2]), a, K, True)
    assert case.values("U", patch="inlet")[:, 0] == pytest.approx(exact)
    x = case.centres()
    exact = profile(np.hypot(x[:, 1], x[:, 2]), a, K, True)
    assert case.values("U")[:, 0] == pytest.approx(exact, abs=0.03)


def test_flow_rate_is_exact(tmp_path):
    case = tube(tmp_path, "tube", "flowRate table ((0 0) (1 4)); a 2;", 0.2)
    case.condition("inlet", "type zeroGradient;", "p")
    case.condition("walls", "type robinVelocity; a 2;")
    steps(case, 25, 0.02)
    case.run("foamRun")
    phi = case.values("phi", patch="inlet")
    assert -phi.sum() == pytest.approx(2, rel=1e-12)


@pytest.mark.parametrize("walls", WALLS)
def test_ambient_bodies_begin_with_it(walls, plates):
    a, K = WALLS[walls]
    y = -0.33
    set_inlet(plates, f"meanVelocity 1; {entries(a, K)}")
    plates.bodies(f"""disc
    {{
        shape {{ type disc; radius 0.2; }}
        densityRatio 2;
        position (0.02 {y} 0);
        velocity ambient;
    }}""")
    log = plates.run("foamRun", "-check")
    speed = float(log.split(f"(0.02 {y} 0)")[1].split("(")[1].split()[0])
    assert speed == pytest.approx(profile(y, a, K, False), rel=1e-12)


WRONG = {
    "": "needs one of 'meanVelocity' [m/s] and 'flowRate'",
    "meanVelocity 1; flowRate 1;": "needs only one of",
    "meanVelocity 1; a -1;": "'a -1'",
    "meanVelocity 1; a 1; slipLength 1;": "only one of 'a'",
    "meanVelocity 1; shape square;": "plates round",
    "meanVelocity 1; halfWidth 0;": "'halfWidth 0'",
    "meanVelocity 1; radius 1;": "'radius'",
    "meanVelocity 1; shape plates;": "needs 'across'",
}


@pytest.fixture(scope="module")
def refused(tmp_path_factory):
    folder = tmp_path_factory.mktemp("refused")
    case = tube(folder, "right", "meanVelocity 2;", 0.2)
    case.condition("walls", "type noSlip;")
    return refusals.of_copies(case, folder, {
        entry: lambda case, entry=entry: case.replace(
            "0/U", "meanVelocity 2;", entry
        )
        for entry in WRONG
    })


@pytest.mark.fast
@pytest.mark.parametrize("entry", WRONG)
def test_wrong_entries_are_refused(entry, refused):
    refused[entry].names(WRONG[entry], "0/U")
