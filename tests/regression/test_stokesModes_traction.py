# SPDX-License-Identifier: GPL-3.0-or-later
"""stokesModes: ends under traction."""

import shutil
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1]/"benchmarks"))

from bodyCase import BodyCase
from boxMesh import uniform
from measure import set_viscosity
from stokesCase import discs, refused, solve, write_dict

ROOT = Path(__file__).resolve().parents[2]


def traction_tube(folder, along):
    """A disc between ends under traction 1, four cells per diameter."""
    case = BodyCase("tube", folder)
    case.controls(libs="(grainFvPatchFields)")
    end = f"type fixedTractionVelocity; tangentialVelocity {along}; backflow 0;"
    case.conditions(
        f"inlet {{ {end} traction (1 0 0); }}"
        f" outlet {{ {end} traction (0 0 0); }}"
        " walls { type noSlip; } frontAndBack { type empty; }",
        '"inlet|outlet" { type fixedTractionPressure; }'
        " walls { type zeroGradient; } frontAndBack { type empty; }",
    )
    set_viscosity(case, 1)
    # Not longer at the ends than across
    case.mesh(uniform(-3, 3, 186), uniform(-1, 1, 62))
    case.bodies(discs([(0, 0)]))
    return case


@pytest.mark.parametrize(
    "along, speed, error",
    [("zero", 0.08315700, 1e-3), ("free", 0.08607604, 2e-3)],
)
def test_traction(along, speed, error, tmp_path):
    """Ends under traction 1, without or with a velocity along them: a disc in
    the middle of the tube, body-fitted finite elements. With a velocity the
    corners are singular, and an error of first order is left."""
    case = traction_tube(tmp_path, along)
    found = solve(case, inertia="no")

    assert found["residual"][0] < 1e-7
    assert found["V_x0"][0] == pytest.approx(speed, rel=error)
    assert found["V_y0"][0] == pytest.approx(0, abs=1e-6)


def test_states_under_traction(tmp_path):
    """What the first state leaves on the ends does not stop the second one: a
    part of the tube of the tutorial, whose cells are as small as it takes.
    The speed falls towards the wall."""
    case = BodyCase("tube", tmp_path)
    tube = ROOT/"tutorials/maps/tube"
    for name in ("0", "constant", "system"):
        shutil.rmtree(case.path/name, ignore_errors=True)
    for name in ("constant", "system", "traction/system"):
        shutil.copytree(tube/name, case.path/Path(name).name,
                        dirs_exist_ok=True)
    shutil.copytree(tube/"traction/0.orig", case.path/"0")
    mesh = case.path/"system/blockMeshDict"
    text = mesh.read_text()
    for old, new in (("left            -3;", "left -1;"),
                     ("right           3;", "right 1;"),
                     ("along           369;", "along 123;")):
        assert old in text
        text = text.replace(old, new)
    mesh.write_text(text)
    case.run("blockMesh")
    found = solve(case, [[(0, -0.6)], [(0, -0.3)]], inertia="no")

    assert max(found["residual"]) < 1e-7
    assert found["V_x0"][1] > 1.2*found["V_x0"][0] > 0


def test_refuses_what_is_not_linear(tmp_path):
    case = BodyCase("tube", tmp_path)
    case.controls(libs="(grainFvPatchFields)")
    case.replace("0/p", '".*"', 'outlet { type fixedTractionPressure; }\n".*"')
    case.replace("0/U", "outlet  { $inlet; }",
                 "outlet { type fixedTractionVelocity; traction (0 0 0); }")
    case.mesh(uniform(-2, 2, 32), uniform(-1, 1, 16))
    write_dict(case)
    refused(case, "'backflow' on patch 'outlet'", "0/U", "'backflow 0'")
    U = case.path/"0/U"
    text = U.read_bytes()
    assert b"backflow        0.5;" in text
    U.write_bytes(text.replace(b"backflow        0.5;", b"backflow 0; fan 1;"))
    refused(case, "'fan' on patch 'outlet'", "0/U", "'traction'")

    case.replace("constant/transportProperties", "Newtonian", "CrossPowerLaw")
    refused(case, "'transportModel' is 'CrossPowerLaw'")


def test_refuses_long_cells_under_traction(tmp_path):
    case = BodyCase("tube", tmp_path)
    case.controls(libs="(grainFvPatchFields)")
    case.replace("0/p", '".*"', 'outlet { type fixedTractionPressure; }\n".*"')
    case.replace("0/U", "outlet  { $inlet; }",
                 "outlet { type fixedTractionVelocity; backflow 0;"
                 " traction (1 0 0); }")
    case.mesh(uniform(-3, 3, 12), uniform(-1, 1, 40))
    write_dict(case)
    refused(case, "ends under traction", "'tangentialVelocity zero'", "0/U")
