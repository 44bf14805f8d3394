# SPDX-License-Identifier: GPL-3.0-or-later
"""Forces and motions against reference values, on meshes of 8 to 16 cells per
diameter. The figures go to figures.txt beside this file."""

import time
from pathlib import Path

import numpy as np
import pytest

import roundTube
from bodyCase import BodyCase
from boxMesh import around, graded, uniform

FIXED = "constraints { translate (0 0 0); rotate (0 0 0); }"
DEPTH = 0.1


@pytest.fixture(scope="module")
def figures():
    """Table of all figures, written at the end."""
    lines = []
    yield lines
    if not lines:
        return
    width = max(len(line[0]) for line in lines)
    head = f"{'case':<{width}}  {'measured':>12}  {'reference':>12}  " \
        "error %  within %    run s"
    text = "\n".join([head] + [
        f"{name:<{width}}  {value:12.7g}  {reference:12.7g}  "
        f"{100*(value/reference - 1):7.3f}  {100*tolerance:8.3f}  {run:7.1f}"
        for name, value, reference, tolerance, run in lines
    ])
    print("\n" + text)
    (Path(__file__).parent / "figures.txt").write_text(text + "\n")


@pytest.fixture
def compare(figures):
    """Note a figure and compare it to the reference."""
    def compare(name, value, reference, tolerance, run):
        figures.append((name, value, reference, tolerance, run))
        assert value == pytest.approx(reference, rel=tolerance)

    return compare


def solve(case):
    """Run the solver, return the time it takes [s]."""
    start = time.perf_counter()
    case.solve()
    return time.perf_counter() - start


def steady(values, tolerance):
    """The last of the values, which must not change in the last quarter."""
    last = values[-1]
    quarter = values[3*len(values)//4:]
    assert np.abs(quarter/last - 1).max() < tolerance
    return last


# Body-fitted finite elements (Taylor-Hood, extrapolated) at Re = 2: half width
# 1, mean speed 1, ends at x = -3 and 3, R = 0.065
TUBE_DRAG = {-0.3: 4.5869025, 0: 5.2104927}


@pytest.mark.parametrize("y, cells, offset, tolerance", [
    (-0.3, (8, 8), (0, 0), 3e-3),
    (-0.3, (8, 8), (0.3, 0.4), 3e-3),
    (0, (8, 8), (0, 0), 3e-3),
    (-0.3, (16, 16), (0.3, 0.4), 8e-4),
    # Stretched cells
    (-0.3, (16, 8), (0.3, 0.4), 3e-3),
    (-0.3, (6, 12), (0, 0), 3e-3),
])
def test_drag_of_a_disc_in_a_tube(
    y, cells, offset, tolerance, compare, tmp_path
):
    radius = 0.065
    fine = min(cells) > 8 or cells[0] != cells[1]
    case = BodyCase("tube", tmp_path)
    case.mesh(*(
        graded(
            -size, size,
            around(centre, (5 if fine else 4)*radius, 2*radius/n, shift),
            2*radius/n, 1.05 if fine else 1.08,
        )
        for size, centre, shift, n in zip((3, 1), (0, y), offset, cells)
    ))
    case.bodies(f"""
        disc
        {{
            shape {{ type disc; radius {radius}; }}
            position (0 {y} 0);
            {FIXED}
        }}
    """)
    case.controls(endTime="4", deltaT="0.05")
    run = solve(case)

    # What is left of the transient is small beside the tolerance
    force = case.table("forces")["fluidForce_x"]
    drag = steady(force, max(1e-4, 0.1*tolerance))/DEPTH
    compare(
        f"disc in a tube, drag, y {y}, D/h {cells}, offset {offset}",
        drag, TUBE_DRAG[y], tolerance, run,
    )


def test_drag_of_a_cylinder_in_a_channel(compare, tmp_path):
    """Benchmark 2D-1 of Schaefer & Turek 1996."""
    radius, h = 0.05, 0.01
    case = BodyCase("cylinder", tmp_path)
    case.mesh(
        graded(0, 2.2, (0.1, 0.5), h, 1.05), uniform(0, 0.41, 41)
    )
    case.controls(endTime="8", deltaT="0.02")
    run = solve(case)

    force = steady(case.table("forces")["fluidForce_x"], 1e-4)/DEPTH
    compare(
        "cylinder in a channel (2D-1), C_D, D/h 10",
        2*force/(0.2**2*2*radius), 5.57953523384, 2e-3, run,
    )


def test_free_disc_in_a_tube(compare, tmp_path):
    """Carried at its height through the mesh, turning freely."""
    radius, y = 0.065, -0.3
    h = 2*radius/8
    case = BodyCase("tube", tmp_path)
    case.mesh(
        graded(-3, 3, (-0.7 - 12*h, -0.7 + 96*h), h),
        graded(-1, 1, around(y, 4*radius, h, 0.2), h),
    )
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius {radius}; }}
            density     2;
            position    (-0.7 {y} 0);
            velocity    ambient;
            constraints {{ translate (1 0 0); }}
        }}
    """, "rho 1;")
    case.controls(endTime="1", deltaT="0.0025")
    run = solve(case)

    motion = case.table("motion")
    half = motion["time"] > 0.5
    for name, column, reference, tolerance in (
        ("V_x", "velocity_x", 1.3612906, 1e-3),
        ("spin", "angularVelocity_z", -0.4486122, 2e-3),
    ):
        compare(
            f"free disc in a tube, {name}, D/h 8",
            motion[column][half].mean(), reference, tolerance, run,
        )
    assert motion["velocity_y"] == pytest.approx(0, abs=0)
    assert np.ptp(motion["position_x"]) > 80*h


@pytest.mark.parametrize("offset", [(0, 0), (0.3, 0.4)])
def test_free_disc_in_a_comoving_window(offset, compare, tmp_path):
    """Held at its height, else free; it travels 40 diameters on a mesh that
    moves with it. Finite elements in the co-moving frame, Re = 2."""
    radius, y = 0.065, -0.3
    h = 2*radius/8
    case = BodyCase("tube", tmp_path)
    case.mesh(
        graded(-3, 3, around(0, 6.4*radius, h, offset[0]), h, 1.04),
        graded(-1, 1, around(y, 6.4*radius, h, offset[1]), h, 1.04),
    )
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius {radius}; }}
            densityRatio 2;
            position    (0 {y} 0);
            velocity    ambient;
            constraints {{ translate (1 0 0); }}
        }}
    """, "window { type comoving; direction (1 0 0); }")
    case.controls(endTime="4", deltaT="0.02")
    run = solve(case)

    motion, forces = case.table("motion"), case.table("forces")
    assert motion["position_x"][-1] > 40*2*radius
    assert np.abs(motion["windowPosition_x"]).max() < 1e-12
    for name, values, reference, tolerance in (
        ("V_x", motion["velocity_x"], 1.36128741, 4e-4),
        ("spin", motion["angularVelocity_z"], -0.44864746, 4e-4),
        ("lift", forces["fluidForce_y"]/DEPTH, -1.019145e-3, 2e-2),
    ):
        compare(
            f"free disc in a comoving window, {name}, D/h 8, offset {offset}",
            steady(values, 1e-2), reference, tolerance, run,
        )


@pytest.mark.parametrize("motion, speed, reference", [
    ("held", 1.5, 21.2947029),
    ("towed", 0.02, 21.963553),
])
def test_drag_of_a_disc_between_plates(
    motion, speed, reference, compare, tmp_path
):
    """Stokes flow, D/H = 0.25; force over viscosity and speed, exact."""
    case = BodyCase("tube", tmp_path)
    case.replace(
        "system/fvSchemes", "div(phi,U)          Gauss linear",
        "div(phi,U)          none",
    )
    if motion == "held":
        case.mesh(uniform(-3, 3, 96), uniform(-1, 1, 32))
    else:
        # At rest: no inflow, the disc is moved along the centre line
        case.replace("0.orig/U", "1.5*(1 - sqr(pos().y()))", "0")
        case.replace("0/U", "1.5*(1 - sqr(pos().y()))", "0")
        case.replace(
            "system/setExprFieldsDict", "1.5*(1 - sqr(pos().y()))", "0"
        )
        case.mesh(uniform(-3, 3, 96), uniform(-1, 1, 32))
    velocity = f"({speed} 0 0)" if motion == "towed" else "(0 0 0)"
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius 0.25; }}
            position    (-0.05 0 0);
            velocity    {velocity};
            {FIXED}
        }}
    """)
    # The disc is towed over two cells
    case.controls(endTime="6", deltaT="0.05")
    run = solve(case)

    force = case.table("forces")["fluidForce_x"]/DEPTH/0.5/speed
    if motion == "towed":
        force *= -1
    compare(
        f"disc between plates, {motion}, F/(mu U), D/h 8",
        steady(force, 2e-3), reference, 1e-2, run,
    )


@pytest.mark.parametrize("cells, tolerance", [(8, 3e-2), (12, 1e-2)])
def test_drag_of_a_sphere_in_a_round_tube(cells, tolerance, compare, tmp_path):
    """Held on the axis in Poiseuille flow, Stokes, radius 0.3 of the tube's:
    6 pi mu a U_max K2 with K2 from the exact series of Haberman and Sayre
    (1958), converged to 13 digits."""
    radius, speed, nu, factor = 0.3, 1.5, 0.5, 2.2289766
    h = 2*radius/cells
    case = BodyCase("tube", tmp_path)
    case.replace(
        "system/fvSchemes", "div(phi,U)          Gauss linear",
        "div(phi,U)          none",
    )
    for file in ("0.orig/U", "0/U", "system/setExprFieldsDict"):
        case.replace(
            file, "1 - sqr(pos().y())", "1 - sqr(pos().y()) - sqr(pos().z())"
        )

    # Off the symmetry of the mesh
    x = graded(-3, 3, around(0, 0.75, h, 0.2), h, growth=1.15)
    roundTube.write(case, x, h)
    case.run("blockMesh")
    case.run("setExprFields")
    case.bodies(f"""
        sphere
        {{
            shape       {{ type sphere; radius {radius}; }}
            position    (0 {0.1*h} {0.3*h});
            {FIXED}
        }}
    """)
    case.controls(endTime="1.2", deltaT="0.04")
    run = solve(case)

    force = case.table("forces")["fluidForce_x"]
    compare(
        f"sphere in a round tube, drag, D/h {cells}",
        steady(force, 1e-3),
        6*np.pi*nu*radius*speed*factor,
        tolerance,
        run,
    )
