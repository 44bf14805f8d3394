# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that cyclic patches cut: arrays, where place does not matter."""

import numpy as np
import pytest

from bodyCase import BodyCase
from foamCase import FoamError
from periodicBox import periodic_case, superficial_speed
from periodicTube import direct_pressure

CELLS = {2: 16, 3: 12}
SHAPES = {2: "disc; radius 0.2", 3: "sphere; radius 0.3"}
# Of the centre in its cell
OFFSET = np.array([0.3, 0.4, 0.2])
PLACES = {
    "corner": (0, 0, 0),
    "side": (0.5, 0, 0.5),
    # Three periods away
    "beyond": (3.5, -1, 0.5),
}


@pytest.fixture(scope="module")
def boxes(tmp_path_factory):
    """Periodic boxes, with convection and pressure that falls along x."""
    cases = {}
    for dims, cells in CELLS.items():
        folder = tmp_path_factory.mktemp("boxes")
        case = periodic_case(folder, f"{dims}D", cells, dims, 30, True)
        direct_pressure(case)
        case.controls(endTime="0.3", deltaT="0.02")
        # No face of its patch may be on a processor
        path = case.path / "system/controlDict"
        head, tail = path.read_text().split("flowRate", 1)
        path.write_text(head + tail.split("}", 1)[1])
        cases[dims] = case
    return cases


@pytest.fixture(scope="module")
def loads(boxes, tmp_path_factory):
    """Force and torque on a body in all steps."""
    cache = {}

    def get(dims, place, parts=(1, 1, 1), before=""):
        key = dims, place, parts, before
        if key in cache:
            return cache[key]
        case = BodyCase(boxes[dims], tmp_path_factory.mktemp("run"))
        x, y, z = np.array(place) + OFFSET/CELLS[dims]
        case.bodies(f"""
            body
            {{
                shape {{ type {SHAPES[dims]}; }}
                position ({x:.15g} {y:.15g} {z:.15g});
                motion {{ type fixed; }}
            }}
        """, before)
        case.solve(int(np.prod(parts)), parts)
        table = case.table("forces")
        cache[key] = np.array([
            table[f"{name}_{i}"] for name in ("fluidForce", "fluidTorque")
            for i in "xyz"
        ])
        return cache[key]

    return get


def difference(a, b):
    return np.abs(a - b).max()/np.abs(a).max()


@pytest.mark.parametrize("dims", CELLS)
@pytest.mark.parametrize("place", PLACES)
def test_anywhere_is_the_middle(dims, place, loads):
    middle = loads(dims, (0.5, 0.5, 0.5))
    assert middle[0, -1] > 0.1
    assert difference(middle, loads(dims, PLACES[place])) < 1e-9


@pytest.mark.parametrize(
    "dims, parts", [
        (2, (2, 1, 1)), (2, (1, 2, 1)), (2, (4, 1, 1)), (2, (2, 2, 1)),
        (3, (1, 2, 1)), (3, (2, 1, 2)),
    ]
)
def test_on_any_number_of_ranks(dims, parts, loads):
    middle = loads(dims, (0.5, 0.5, 0.5))
    assert difference(middle, loads(dims, (0, 0, 0), parts)) < 1e-9


def test_another_resistance(loads):
    model = "resistance { type distanceWeighted; }"
    middle = loads(2, (0.5, 0.5, 0.5), before=model)
    corner = loads(2, (0, 0, 0), before=model)
    assert difference(middle, corner) < 1e-9


def test_a_body_force_is_a_pressure_gradient(tmp_path):
    """fvOptions: their force acts on the layer as the gradient would."""
    speeds = []
    for name, by_force in (("force", True), ("gradient", False)):
        case = periodic_case(tmp_path, name, CELLS[2], 2, 30, by_force)
        case.replace(
            "system/fvSchemes", "div(phi,U)          Gauss linear",
            "div(phi,U)          none",
        )
        case.bodies("""
            disc
            {
                shape { type disc; radius 0.2; }
                position (0.02 0.03 0);
                motion { type fixed; }
            }
        """)
        case.controls(endTime="80", deltaT="0.05")
        case.solve()
        speeds.append(superficial_speed(case, 0.1)[-1])
    assert speeds[0] == pytest.approx(speeds[1], rel=1e-3)


def ami_case(folder, name):
    """A box whose sides along x are coupled by interpolation."""
    case = periodic_case(folder, name, CELLS[2], 2, 0, True)
    for one, other, sign in (("left", "right", ""), ("right", "left", "-")):
        case.replace(
            "system/blockMeshDict",
            f"    {one} {{ type cyclic; neighbourPatch {other};",
            f"    {one} {{ type cyclicAMI; neighbourPatch {other};"
            f" transform translational; separationVector ({sign}1 0 0);",
        )
    case.run("blockMesh")
    sides = """
        "left|right" { type cyclicAMI; }
        "bottom|top" { type cyclic; }
        frontAndBack { type empty; }
    """
    case.conditions(sides, sides)
    case.controls(endTime="0.04", deltaT="0.02")
    return case


@pytest.mark.parametrize("ranks", [1, 2])
def test_bodies_refuse_patches_that_do_not_match(ranks, tmp_path):
    case = ami_case(tmp_path, "bodies")
    case.bodies("""
        disc
        {
            shape { type disc; radius 0.2; }
            densityRatio 2;
            position (0.1 0.5 0);
        }
    """)
    with pytest.raises(FoamError) as error:
        case.solve(ranks, (1, ranks, 1))
    for part in ("'left'", "'cyclicAMI'", "'type cyclic'", "polyMesh/boundary"):
        assert part in str(error.value)


def test_without_bodies_they_are_allowed(tmp_path):
    case = ami_case(tmp_path, "empty")
    case.controls(writeInterval="0.04", writeFormat="ascii")
    (case.path / "constant/immersedBodyProperties").unlink()
    file = case.path / "system/controlDict"
    file.write_text(file.read_text().split("functions")[0] + "functions {}\n")
    case.replace(
        "system/fvSchemes", "div(phi,U)          Gauss linear;",
        "div(phi,U)          Gauss linear;\n"
        "    div((nuEff*dev2(T(grad(U))))) Gauss linear;",
    )
    case.solve()
    assert case.field("U")[:, 0] == pytest.approx(1, rel=1e-6)
