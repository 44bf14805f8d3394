# SPDX-License-Identifier: GPL-3.0-or-later
"""Results do not depend on the number of processors."""

import numpy as np
import pytest

from bodyCase import BodyCase
from boxMesh import uniform

TIGHT = "coupling { tolerance 1e-9; nOuterCorrectors 25; }"

FREE = """
    free
    {
        shape       { type disc; radius 0.25; }
        densityRatio 2;
        position    (-0.1 -0.3 0);
        velocity    (1 0.2 0);
        angularVelocity (0 0 -1);
    }
"""
FIXED = """
    fixed
    {
        shape       { type disc; radius 0.2; }
        positions   ((-0.57 0.43 0) (0.52 0.41 0));
        constraints { translate (0 0 0); rotate (0 0 0); }
    }
"""
SPHERE = """
    sphere
    {
        shape       { type sphere; radius 0.25; }
        densityRatio 2.5;
        position    (0.04 0.03 0.02);
        velocity    (0.3 0 -0.5);
        angularVelocity (0 2 0);
    }
"""
SCENES = {"free": FREE, "free beside fixed": FREE + FIXED, "sphere": SPHERE}
BODIES = {"free": 1, "free beside fixed": 3, "sphere": 1}

# Parts in x, y, z
PARTS = {2: (2, 1, 1), 4: (2, 2, 1)}


@pytest.fixture(scope="module")
def meshed(tmp_path_factory):
    """Tube and box with tight tolerances."""
    cases = {}
    for kind in ("tube", "box"):
        case = BodyCase(kind, tmp_path_factory.mktemp("ranks"))
        if kind == "tube":
            case.mesh(uniform(-3, 3, 60), uniform(-1, 1, 20))
        else:
            case.mesh(*3*[uniform(-0.75, 0.75, 14)])
        # Few messages between ranks: there may be fewer cores
        case.replace("system/fvSolution", "GAMG;", "PCG;")
        case.replace(
            "system/fvSolution",
            "smoother        GaussSeidel", "preconditioner  DIC",
        )
        case.replace("system/fvSolution", "1e-8", "1e-12")
        case.replace("system/fvSolution", "0.01", "0")
        case.replace("system/fvSolution", "1e-9", "1e-12")
        case.replace("system/fvSolution", "1e-3", "0")
        case.controls(writeFormat="ascii", writePrecision="15")
        cases[kind] = case
    return cases


@pytest.fixture(scope="module")
def run(meshed, tmp_path_factory):
    """Run a scene on a number of ranks, once."""
    cache = {}

    def get(scene, ranks):
        if (scene, ranks) not in cache:
            mesh = meshed["box" if scene == "sphere" else "tube"]
            case = BodyCase(mesh, tmp_path_factory.mktemp("run"), "case")
            case.bodies(SCENES[scene], TIGHT)
            steps = 2 if scene == "sphere" else 6
            case.controls(
                endTime=str(0.02*steps), writeInterval=str(0.02*steps)
            )
            case.solve(ranks, PARTS.get(ranks))
            if ranks > 1:
                case.run("reconstructPar", "-latestTime")
            cache[scene, ranks] = case
        return cache[scene, ranks]

    return get


def difference(a, b):
    """Largest difference over the largest value."""
    return np.abs(a - b).max()/np.abs(a).max()


@pytest.mark.parametrize("ranks", [2, 4])
@pytest.mark.parametrize("scene", SCENES)
def test_any_number_of_ranks_gives_the_same(scene, ranks, run):
    serial, parallel = run(scene, 1), run(scene, ranks)

    # The free body moves, and is on both sides of the boundary at x = 0
    motion = serial.table("motion")
    assert np.ptp(motion["position_x"]) > 1e-3
    assert np.abs(motion["position_x"]).max() < 0.25

    for body in range(BODIES[scene]):
        for table, quantities in {
            "motion": ["position", "velocity", "angularVelocity"],
            "forces": ["fluidForce", "fluidTorque"],
        }.items():
            expected = serial.table(table, body)
            obtained = parallel.table(table, body)
            for quantity in quantities:
                a, b = (
                    np.array([t[f"{quantity}_{i}"] for i in "xyz"])
                    for t in (expected, obtained)
                )
                if np.abs(a).max() > 0:
                    assert difference(a, b) < 1e-7, (quantity, body)
                else:
                    assert np.abs(b).max() == 0, (quantity, body)

    for field, tolerance in (("U", 1e-7), ("bodyFraction", 1e-7)):
        assert difference(serial.field(field), parallel.field(field)) \
            < tolerance, field


@pytest.mark.parametrize("ranks", [2, 4])
def test_a_body_crosses_to_another_rank(ranks, meshed, tmp_path):
    """Moved at a given velocity, from one side of x = 0 to the other."""
    tables = []
    for n in (1, ranks):
        case = BodyCase(meshed["tube"], tmp_path, f"ranks{n}")
        case.bodies("""
            moved
            {
                shape       { type disc; radius 0.25; }
                position    (-0.31 0.037 0);
                velocity    (3 0 0);
                angularVelocity (0 0 1);
                constraints { translate (0 0 0); rotate (0 0 0); }
            }
        """)
        case.controls(endTime="0.2")
        case.solve(n, PARTS.get(n))
        tables.append(case.table("forces"))

    assert case.table("motion")["position_x"][-1] == pytest.approx(0.29)
    for column in ("fluidForce_x", "fluidForce_y", "fluidTorque_z"):
        assert difference(tables[0][column], tables[1][column]) < 1e-7, column
