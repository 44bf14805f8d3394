# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact of bodies with each other and with walls, in a fluid so light that
the closed forms of a collision hold."""

import numpy as np
import pytest

import roundTube
from bodyCase import BodyCase
from boxMesh import uniform
from contactCase import RATIO, box2d, contact, discs
from foamCase import FoamError


@pytest.mark.parametrize("e, more, dt", [
    (0.88, "", 0.005), (0.5, "", 0.005), (0.88, "collisionTime 0.0005;", 0.005),
    (0.88, "collisionTime 0.02;", 0.001),
])
def test_sphere_bounces_off_a_wall(e, more, dt, tmp_path):
    case = BodyCase("box", tmp_path)
    case.mesh(*3*[uniform(-0.75, 0.75, 12)])
    case.bodies(
        f"ball {{ shape {{ type sphere; radius 0.25; }} densityRatio {RATIO};"
        " position (0.3 0.03 0.02); velocity (6 0 0); }",
        contact(e=e, more=more),
    )
    case.controls(endTime=0.1, deltaT=dt)
    case.solve()

    motion, forces = case.table("motion"), case.table("forces")
    assert motion["velocity_x"][-1] == pytest.approx(-6*e, rel=0.02)
    assert max(motion["position_x"]) < 0.5 + 0.2*0.25

    mass = RATIO*4/3*np.pi*0.25**3
    impulse = dt*sum(forces["contactForce_x"])
    assert impulse == pytest.approx(-mass*6*(1 + e), rel=0.02)


@pytest.mark.parametrize("scheme", ["Euler", "backward"])
def test_pair_is_the_same_on_two_ranks(scheme, tmp_path):
    case = box2d(tmp_path, 20)
    case.replace("system/fvSchemes", "backward", scheme)
    case.replace(
        "system/fvSolution", "GAMG;\n        smoother        GaussSeidel",
        "fastPoisson",
    )
    case.bodies(
        discs([(-0.35, 0.02), (0.3, -0.03)], velocities=[(2, 1), (-1, 0)]),
        contact(),
    )
    case.controls(endTime=0.3, deltaT=0.01)
    two = BodyCase(case, tmp_path, "two")
    case.solve()
    two.solve(ranks=2)

    for body in (0, 1):
        a, b = case.table("motion", body), two.table("motion", body)
        for column in ("position_x", "velocity_y", "angularVelocity_z"):
            assert b[column] == pytest.approx(a[column], abs=1e-4)
    first, second = (case.table("motion", i) for i in (0, 1))
    apart = second["velocity_x"] - first["velocity_x"]
    assert apart[0] < -2.9 and apart[20] > 2
    for k in ("velocity_x", "velocity_y"):
        total = (first[k] + second[k])[:25]
        assert total == pytest.approx(total[0], abs=0.01)


def test_restart_within_a_contact_is_exact(tmp_path):
    case = box2d(tmp_path, 20)
    case.bodies(
        discs([(0.6, 0.5)], velocities=[(2, -1)]),
        contact(e=0.7, more="collisionTime 0.06;"),
    )
    case.controls(
        endTime=0.24, deltaT=0.01, writeControl="timeStep", writeInterval=12,
        writePrecision=17, timePrecision=15,
    )
    parts = BodyCase(case, tmp_path, "parts")
    case.solve()
    parts.controls(endTime=0.12)
    parts.solve()

    state = parts.path/"0.12/uniform/immersedBodies"
    assert "springContacts ( (" in " ".join(state.read_text().split())
    parts.controls(endTime=0.24)
    parts.solve()

    for file in ("U", "p", "uniform/immersedBodies"):
        expected = (case.path/case.latest_time()/file).read_bytes()
        assert (parts.path/parts.latest_time()/file).read_bytes() == expected


def test_round_tube_has_no_jumps(tmp_path):
    case = BodyCase("tube", tmp_path)
    roundTube.write(case, uniform(-0.6, 0.6, 8), 0.15)
    # Closed: inside it is all but vacuum
    for field, condition in (("U", "noSlip"), ("p", "zeroGradient")):
        path = case.path/"0"/field
        head = path.read_text().split("boundaryField", 1)[0]
        path.write_text(
            f'{head}boundaryField {{ ".*" {{ type {condition}; }} }}\n'
        )
    case.run("blockMesh")
    radius, u = 0.4, 1.0
    case.bodies(
        f"ball {{ shape {{ type sphere; radius {radius}; }} densityRatio 1e5;"
        f" position (0.01 0 -0.597); velocity (0 {u} 0); }}",
        contact(e=0.5, mu=0, more="collisionTime 0.02;"),
    )
    case.controls(endTime=1.5, deltaT=0.02)
    case.solve()

    motion, forces = case.table("motion"), case.table("forces")
    late = motion["time"] > 0.3
    r = np.array([motion["position_y"], motion["position_z"]])[:, late]
    f = np.array([forces["contactForce_y"], forces["contactForce_z"]])[:, late]
    speed = np.hypot(motion["velocity_y"], motion["velocity_z"])[late]
    assert speed == pytest.approx(u, rel=0.03)

    inward = -r/np.hypot(*r)
    touching = np.hypot(*f) > 0
    cosine = (inward*f).sum(axis=0)[touching]/np.hypot(*f)[touching]
    assert touching.mean() > 0.5
    assert np.degrees(np.arccos(cosine.clip(-1, 1))).max() < 4


def test_heap_comes_to_rest(tmp_path):
    case = box2d(tmp_path, 40)
    positions = [
        (-0.8 + 0.27*i + 0.05*(j % 2), -0.85 + 0.27*j)
        for j in range(5) for i in range(6)
    ]
    case.gravity(y=-10)
    case.bodies(
        discs(positions, radius=0.12, ratio=1000), contact(e=0.5)
    )
    case.controls(endTime=4, deltaT=0.005)
    case.solve()

    energies = sum(
        case.table("motion", i)["velocity_x"]**2
        + case.table("motion", i)["velocity_y"]**2
        for i in range(len(positions))
    )
    assert energies[-20:].max() < 1e-4*energies.max()


def test_too_much_overlap_stops_the_run(tmp_path):
    case = box2d(tmp_path, 20)
    case.bodies(
        discs([(0.6, 0)], velocities=[(3, 0)]),
        contact(more="collisionTime 1;"),
    )
    case.controls(endTime=0.4, deltaT=0.01)
    with pytest.raises(FoamError, match="bodies overlap: disc0 and a wall"):
        case.solve()
