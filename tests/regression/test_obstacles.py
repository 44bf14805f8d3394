# SPDX-License-Identifier: GPL-3.0-or-later
"""Fixed bodies may stand in walls and in each other."""

import re

import pytest

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform
from foamCase import FoamError

FIXED = "motion { type fixed; }"
CONTACT = "contact { type softSphere; }\nrho 1;"

SCENES = {
    "from floor to middle": f"""
        pillar {{ shape {{ type box; size (0.4 1 1); }}
                 position (0 -0.5 0); {FIXED} }}
    """,
    "across the floor": f"""
        bump {{ shape {{ type disc; radius 0.4; }}
               position (0 -1 0); {FIXED} }}
    """,
    "in each other": f"""
        a {{ shape {{ type disc; radius 0.3; }} position (0 0 0); {FIXED} }}
        b {{ shape {{ type disc; radius 0.3; }} position (0.4 0 0); {FIXED} }}
    """,
    "touching each other": f"""
        a {{ shape {{ type disc; radius 0.25; }} position (0 0 0); {FIXED} }}
        b {{ shape {{ type disc; radius 0.25; }} position (0.5 0 0); {FIXED} }}
    """,
    "beside a grain": f"""
        a {{ shape {{ type disc; radius 0.3; }} position (0 -0.8 0); {FIXED} }}
        b {{ shape {{ type disc; radius 0.25; }} densityRatio 2;
            position (-0.8 0 0); velocity ambient; }}
    """,
}


@pytest.fixture(scope="module")
def tube(tmp_path_factory):
    case = BodyCase("tube", tmp_path_factory.mktemp("obstacles"))
    case.mesh(uniform(-3, 3, 60), uniform(-1, 1, 20))
    case.controls(endTime="0.1")
    return case


@pytest.mark.parametrize("contact", ["", CONTACT])
@pytest.mark.parametrize("scene", SCENES)
def test_obstacles_overlap(scene, contact, tube, tmp_path):
    case = BodyCase(tube, tmp_path)
    case.bodies(SCENES[scene], contact)

    log = case.solve()

    speeds = [float(c) for c in re.findall(r"Number mean: \S+ max: (\S+)", log)]
    assert max(speeds) < 10*speeds[0]
    assert "Gap of" not in log
    assert "goes through the bodies" not in log


def test_pillar_across_the_channel(tmp_path):
    """From wall to wall, in three dimensions."""
    case = BodyCase("tube", tmp_path)
    boxMesh.write(
        case, uniform(-3, 3, 36), uniform(-1, 1, 12), uniform(-1, 1, 12),
        {"inlet": "x-", "outlet": "x+", "walls": "y- y+ z- z+"},
    )
    case.run("blockMesh")
    case.run("setExprFields")
    case.controls(
        endTime="0.4", writeFormat="ascii", writeControl="timeStep",
        writeInterval=20,
    )
    case.bodies(f"""
        pillar {{ shape {{ type cylinder; radius 0.35; length 2; }}
                 position (0 0 0); {FIXED} }}
    """)

    log = case.solve()

    assert "goes through the bodies" not in log
    U = case.field("U")
    assert 1.5 < U[:, 0].max() < 4


def test_blocked_channel(tmp_path):
    """One that leaves the flow no way is told of."""
    case = BodyCase("tube", tmp_path)
    case.mesh(uniform(-3, 3, 60), uniform(-1, 1, 20))
    case.controls(endTime="0.4")
    case.bodies(f"""
        plug {{ shape {{ type box; size (0.4 2 1); }}
               position (0 0 0); {FIXED} }}
    """)

    log = case.solve()

    assert log.count("Flow goes through the bodies") == 1


def test_free_bodies_do_not_overlap_obstacles(tube, tmp_path):
    case = BodyCase(tube, tmp_path)
    case.bodies(SCENES["in each other"].replace(FIXED, "densityRatio 2;", 1))

    with pytest.raises(FoamError, match="a and b by 0.2"):
        case.solve()
