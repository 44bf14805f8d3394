# SPDX-License-Identifier: GPL-3.0-or-later
"""The function object suspensionStress, against closed forms and the walls."""

import re

import numpy as np
import pytest

from foamCase import tables
from shearedBox import (
    NU, last_row, sheared_box, tighten, volume_fraction, wall_stress
)

DISC = """
    disc
    {{
        shape       {{ type disc; radius {}; }}
        densityRatio {};
        position    {};
    }}
"""
SPHERE = """
    ball
    {
        shape       { type sphere; radius 0.5; }
        densityRatio 1;
        position    (0.02 0.01 0);
    }
"""
PARTS = ("fluid", "particle", "inertia", "contact", "film", "Reynolds")
COMPONENTS = [i + j for i in "xyz" for j in "xyz"]
NAME = "suspensionStress"


def part(row, name):
    """A part of the stress as a matrix."""
    return np.array([row[f"{name}_{c}"] for c in COMPONENTS]).reshape(3, 3)


def total(row):
    return sum(part(row, name) for name in PARTS)


def run(case, end, dt, ranks=1, n=None):
    case.controls(endTime=end, deltaT=dt, writeInterval=end)
    case.solve(ranks, n)
    return last_row(case, NAME)


def test_uniform_flow_has_no_stress(tmp_path):
    case = sheared_box(tmp_path, "box", 2, 32, rate=0, stokes=False)
    path = case.path/"0/U"
    path.write_text(re.sub(r"\(-?0 0 0\)", "(1 0 0)", path.read_text()))
    case.bodies(
        DISC.format(0.25, 3, "(0.02 0.3 0)").replace(
            "densityRatio", "velocity (1 0 0); densityRatio")
    )
    row = run(case, 0.1, 0.01)

    assert case.table("motion")["velocity_x"] == pytest.approx(1, abs=1e-9)
    for name in PARTS:
        stress = part(row, name)
        if name in ("fluid", "particle"):
            stress -= np.trace(stress)/3*np.eye(3)
        assert np.abs(stress).max() < 1e-7, name


def test_without_shear_there_is_no_viscosity(tmp_path):
    """A fluid at rest around a body that is held: 0/0."""
    case = sheared_box(tmp_path, "box", 2, 16, rate=0)
    case.bodies(DISC.format(0.25, 2, "(0 0 0)").replace(
        "density", "motion { type fixed; } density"))
    row = run(case, 0.1, 0.05)
    assert row["shearRate"] == row["shearStress"] == 0
    assert np.isnan(row["viscosity"])


@pytest.mark.parametrize("stokes", [True, False], ids=["Stokes", "inertia"])
def test_stress_of_the_box_is_that_of_the_walls(stokes, tmp_path):
    case = sheared_box(tmp_path, "box", 2, 32, stokes=stokes)
    case.bodies(DISC.format(0.25, 2, "(0 0 0)"))
    row = run(case, 2 if stokes else 4, 0.05)
    walls = wall_stress(case)
    c = volume_fraction(0.25, 2, 2)

    # The rate of strain is that of the walls, and has no part of the body
    assert row["volumeFraction"] == pytest.approx(c, rel=1e-9)
    assert row["shearRate"] == pytest.approx(1, rel=1e-9)
    assert part(row, "fluid")[0, 1] == pytest.approx(NU, rel=1e-9)

    assert row["shearStress"] == pytest.approx(walls, rel=2e-5)
    assert total(row)[0, 1] == pytest.approx(row["shearStress"], rel=1e-9)
    assert row["viscosity"] == pytest.approx(row["shearStress"], rel=1e-9)

    # Force-free and free of torque
    assert total(row)[1, 0] == pytest.approx(total(row)[0, 1], rel=1e-3)
    assert 2*c < (walls - NU)/NU < 2.3*c


def test_dilute_discs(tmp_path):
    """Viscosity 1 + 2 c; the walls are 12 radii from the disc."""
    case = sheared_box(tmp_path, "box", 6, 72)
    case.bodies(DISC.format(0.5, 1, "(0 0 0)"))
    row = run(case, 15, 0.3)
    slope = (row["viscosity"]/NU - 1)/volume_fraction(0.5, 6, 6)

    assert row["viscosity"] == pytest.approx(wall_stress(case), rel=1e-4)
    assert 2 < slope < 2.1


def test_sphere_between_walls(tmp_path):
    case = sheared_box(tmp_path, "box", 3, 30, dims=3)
    case.bodies(SPHERE)
    row = run(case, 3, 0.2)
    slope = (row["viscosity"]/NU - 1)/volume_fraction(0.5, 3, 3, dims=3)

    assert row["viscosity"] == pytest.approx(wall_stress(case), rel=1e-3)
    assert 2.5 < slope < 2.75
    assert abs(row["N1"]) + abs(row["N2"]) < 1e-3


PUSH = """
    restraints {{ push {{ type externalForce; force ({} 0 0); }} }}
    densityRatio"""
CONTACT = """
rho 1;
contact
{
    type softSphere; restitution 0.2; friction 0.3; collisionTime 0.05;
}
"""


def pressed_pair(folder, half, force):
    """Two discs with their centres at -half and half, pressed together."""
    case = sheared_box(folder, "box", 2, 32, rate=0)
    one = DISC.format(0.25, 5, f"(-{half} 0 0)").replace(
        "densityRatio", PUSH.format(force))
    other = DISC.format(0.25, 5, f"({half} 0 0)").replace(
        "densityRatio", PUSH.format(-force)).replace("disc\n", "other\n")
    case.bodies(one + other, CONTACT)
    return case


def test_two_that_are_pressed_onto_each_other(tmp_path):
    """Their contact has the force times the distance, over the volume."""
    force = 0.01
    # As deep as contact holds the force
    case = pressed_pair(tmp_path, 0.249986, force)
    row = run(case, 0.5, 0.02)
    x = [case.table("motion", body)["position_x"][-1] for body in (0, 1)]
    contact = part(row, "contact")

    pressed = case.table("forces", 1)["contactForce_x"][-1]
    assert pressed == pytest.approx(force, rel=0.002)

    volume = 2*2*0.1
    assert contact[0, 0] == pytest.approx(
        -pressed*(x[1] - x[0])/volume, rel=1e-7)
    assert np.abs(contact).max() == -contact[0, 0]
    assert row["contacts"] == 1 and row["largestCluster"] == 2
    assert row["leastGap"] == pytest.approx(x[1] - x[0] - 0.5, abs=1e-9)


@pytest.mark.parametrize("off", [0.34, 0])
def test_contact_beside_a_plane_of_symmetry(off, tmp_path):
    """Of one on the plane with one off it the whole is in the mesh, with one that
    is on it too half of it."""
    case = sheared_box(tmp_path, "box", 2, 32, 1, rate=0)
    plane = "bottom { type symmetryPlane; }"
    case.replace(
        "system/blockMeshDict", "bottom { type wall",
        "bottom { type symmetryPlane",
    )
    case.run("blockMesh")
    for field, old in (("U", "top     {"), ("p", '"bottom|top"')):
        case.replace(f"0/{field}", old, f"{plane} {old}")
    case.replace("0/U", "bottom  {", "unused {")
    case.replace("0/p", '"bottom|top"', "top")

    apart = np.array([np.sqrt(0.48**2 - off**2), off])
    places = [(-0.2, -0.5), (apart[0] - 0.2, off - 0.5)]
    case.bodies("".join(
        DISC.format(0.25, 1000, f"({x} {y} 0)").replace("disc\n", f"disc{i}\n")
        for i, (x, y) in enumerate(places)
    ), CONTACT)
    row = run(case, 0.001, 0.001)
    force = np.array([
        case.table("forces", 1)[f"contactForce_{axis}"][-1] for axis in "xy"
    ])

    assert np.linalg.norm(force) > 1
    assert np.diag(part(row, "contact"))[:2] == pytest.approx(
        -(1 if off else 0.5)*force*apart/(2*1*0.1), rel=0.01)


@pytest.mark.parametrize("half, ranks", [
    (0.24985, 1), (0.24985, 2), (0.24985, 4), (0.2498, 1)
])
def test_fluid_that_is_squeezed_lets_go(half, ranks, tmp_path):
    """Over ten times as deep at the start: they move apart, the fluid goes."""
    force = 0.01
    case = pressed_pair(tmp_path, half, force)
    run(case, 0.5, 0.02, ranks, {4: (2, 2, 1)}.get(ranks))
    pressed = case.table("forces", 1)["contactForce_x"][-1]
    assert pressed == pytest.approx(force, rel=0.02)


def test_ranks(tmp_path):
    rows = []
    for ranks, n in ((1, None), (2, (2, 1, 1)), (4, (2, 2, 1))):
        case = sheared_box(tmp_path, f"on{ranks}", 2, 32, stokes=False)
        # Held, as where iterations of the velocity end differs a little
        case.bodies(DISC.format(0.25, 2, "(0.9 0.3 0)").replace(
            "density", "motion { type fixed; } density"))
        tighten(case)
        rows.append(run(case, 0.08, 0.02, ranks, n))

    for row in rows[1:]:
        for name in rows[0]:
            assert row[name] == pytest.approx(
                rows[0][name], rel=1e-6, abs=1e-7), name


def test_means_go_on_after_a_restart(tmp_path):
    cases = []
    for name in ("once", "parts"):
        case = sheared_box(tmp_path, name, 2, 16, stokes=False,
                           entries="start 0.1;")
        case.bodies(DISC.format(0.25, 2, "(0.3 0.3 0)"))
        case.controls(endTime=0.4, deltaT=0.01, writeInterval=0.2,
                      writeFormat="binary")
        if name == "parts":
            case.controls(endTime=0.2)
            case.solve()
            case.controls(endTime=0.4)
        case.solve()
        cases.append(last_row(case, NAME, NAME + "Means"))

    once, parts = cases
    assert once["samples"] == 31
    for name in once:
        assert once[name] == parts[name] or np.isnan(once[name]), name

    # Of correlated numbers: more than if all were independent
    assert once["errorOf_shearStress"] > 0


def test_means_are_those_of_the_rows(tmp_path):
    case = sheared_box(tmp_path, "box", 2, 16)
    case.bodies(DISC.format(0.25, 2, "(0.3 0.3 0)"))
    run(case, 0.2, 0.01)
    rows = tables.run_columns(case.path, NAME, NAME)
    means = last_row(case, NAME, NAME + "Means")

    for name in ("shearStress", "N1", "nearestGap"):
        assert means[name] == pytest.approx(rows[name].mean(), rel=1e-9)
        error = rows[name].std(ddof=1)/np.sqrt(20)
        assert means[f"errorOf_{name}"] == pytest.approx(error, rel=1e-9)


WALL = """
    on{0}
    {{
        type            forces;
        libs            (forces);
        patches         ({0});
        rho             rhoInf;
        rhoInf          1;
        CofR            (0 0 0);
        writeControl    timeStep;
        log             no;
    }}
"""
FILMS = """
contact
{
    type softSphere; restitution 0.5; friction 0.2; collisionTime 0.02;
}
lubrication { type leadingOrder; }
"""


def force_on(case, wall):
    """Force of the fluid along x on a wall, at all times."""
    folder = case.path/f"postProcessing/on{wall}/0"
    (file,) = (f for f in folder.glob("force*.dat") if f.stem == "force")
    return case.read_dat(file.relative_to(case.path))[:, 1]


def test_suspension_with_films(tmp_path):
    """Twelve discs that come close to each other: over time, their stress is
    that of the walls, by OpenFOAM's own forces."""
    case = sheared_box(tmp_path, "box", 2, 64, stokes=False,
                       entries="clusterGap 0.02;")
    walls = WALL.format("top") + WALL.format("bottom")
    case.replace("system/controlDict", "functions\n{", "functions\n{" + walls)
    random = np.random.default_rng(3)
    places = [
        ((0.25 + 0.5*i + 0.1*j + random.uniform(-0.04, 0.04)) % 2 - 1,
         -2/3 + 2/3*j + random.uniform(-0.1, 0.1))
        for i in range(4) for j in range(3)
    ]
    case.bodies("".join(
        DISC.format(0.16, 1, f"({x} {y} 0)").replace(
            "disc\n", f"disc{i}\n").replace(
            "density", f"velocity ({y} 0 0); density")
        for i, (x, y) in enumerate(places)), FILMS)
    run(case, 4, 0.02)
    rows = tables.run_columns(case.path, NAME, NAME)
    stress = (force_on(case, "bottom") - force_on(case, "top"))/2/(2*0.1)
    late = rows["time"] > 1

    assert rows["film_xy"][late].mean() > 0.005
    assert rows["shearStress"][late].mean() == pytest.approx(
        stress[late].mean(), rel=0.01)
    assert rows["largestCluster"].max() > 1
