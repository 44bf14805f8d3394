# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact by projection of the velocities, inelastic and viscous, in fluid."""

import re

import numpy as np
import pytest

from bodyCase import BodyCase
from boxMesh import uniform
from contactCase import box2d, discs
from foamCase import FoamError
from periodicBox import periodic_case
from periodicTube import direct_pressure

MODELS = ("inelastic", "viscous")
RADIUS = 0.25


def contact(model, more=""):
    return f"contact {{ type {model}; {more} }}"


def pushed(density, force, turns=90):
    """Two discs that forces push towards each other, and apart after a
    time."""
    return "\n".join(
        f"disc{i} {{ shape {{ type disc; radius {RADIUS}; }}"
        f" density {density}; position ({-f/force*0.3} 0 0); restraints {{"
        f" push {{ type externalForce; force table ((0 ({f} 0 0))"
        f" ({turns} ({f} 0 0)) ({turns + 1e-4} ({-f} 0 0)) (99 ({-f} 0 0)));"
        " } } }"
        for i, f in enumerate((force, -force))
    )


def gap(case):
    """Between the discs 0 and 1, in all steps."""
    a, b = (case.table("motion", i) for i in (0, 1))
    return np.hypot(*(
        b[f"position_{c}"] - a[f"position_{c}"] for c in "xy"
    )) - 2*RADIUS


def direct(case):
    case.replace(
        "system/fvSolution", "GAMG;\n        smoother        GaussSeidel",
        "fastPoisson",
    )


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("density", [0.1, 1, 1000])
def test_discs_pushed_together_stay_together(model, density, tmp_path):
    case = box2d(tmp_path, 30)
    force = max(density, 1)
    case.bodies(pushed(density, force), f"rho 1; {contact(model)}")
    case.controls(endTime=0.5, deltaT=0.01)
    log = case.solve()

    assert gap(case)[0] > 0.05
    assert abs(gap(case)[-20:]).max() < 1e-7
    assert gap(case).min() > -1e-8*RADIUS
    iterations = re.findall(r"outer iterations (\d+)", log)[-20:]
    assert max(int(n) for n in iterations) < 15
    for body in (0, 1):
        motion = case.table("motion", body)
        forces = case.table("forces", body)
        assert abs(motion["velocity_x"][-20:]).max() < 2e-4
        # What contact pushes back with, but for the fluid
        assert abs(forces["contactForce_x"][-1]) == pytest.approx(
            force, rel=0.02
        )


@pytest.mark.parametrize("model", MODELS)
def test_pair_in_a_fluid_as_viscous_as_syrup(model, tmp_path):
    """Pressed together, it turns. Viscosity resists contact with two hundred times
    the inertia of the discs: with inertia alone half of the steps did not converge,
    and contact pushed back with more than what presses."""
    push = 100
    case = box2d(tmp_path, 30)
    case.bodies(
        "\n".join(
            f"disc{i} {{ shape {{ type disc; radius {RADIUS}; }} density 1;"
            f" position ({x} {y} 0); restraints {{ push {{ type externalForce;"
            f" force constant ({f} {-0.3*f} 0); }} }} }}"
            for i, (x, y, f) in enumerate((
                (-0.2501, 0, push), (0.2501, 0.02, -push)
            ))
        ),
        f"rho 1; {contact(model)}",
    )
    case.replace("constant/transportProperties", "nu              0.1;", "nu 100;")
    case.controls(endTime=0.4, deltaT=0.01)
    log = case.solve()

    iterations = [int(n) for n in re.findall(r"outer iterations (\d+)", log)]
    assert len(iterations) == 40
    assert max(iterations[25:]) <= 20
    for body, sign in ((0, -1), (1, 1)):
        force = sign*case.table("forces", body)["contactForce_x"][20:]
        assert force.min() > 0.6*push
        assert force.max() < push


@pytest.mark.parametrize("density", [0.5, 20])
def test_viscous_discs_are_torn_apart_later(density, tmp_path):
    """Pulled for as long as they were pushed: only the viscous ones hold."""
    apart = {}
    for model in MODELS:
        case = box2d(tmp_path, 30, model)
        case.bodies(
            pushed(density, max(density, 1), turns=0.4),
            f"rho 1; {contact(model)}",
        )
        case.controls(endTime=0.9, deltaT=0.01)
        case.solve()
        times = case.table("motion")["time"]
        apart[model] = times[(times > 0.4) & (gap(case) > 1e-6)][0]

    assert apart["inelastic"] < 0.43
    # Of the momentum the fluid takes its part
    assert 0.6 < apart["viscous"] < 0.82


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("ranks", [2, pytest.param(
    4, marks=pytest.mark.nightly
)])
def test_contact_is_the_same_on_several_ranks(model, ranks, tmp_path):
    case = box2d(tmp_path, 20)
    direct(case)
    case.bodies(
        discs(
            [(-0.35, 0.02), (0.3, -0.03), (0.3, 0.6)],
            velocities=[(2, 1), (-1, 0), (0, -1)],
        ),
        contact(model),
    )
    case.controls(endTime=0.2, deltaT=0.01)
    several = BodyCase(case, tmp_path, "several")
    case.solve()
    several.solve(ranks=ranks, n=(2, ranks//2, 1))

    for body in range(3):
        a, b = case.table("motion", body), several.table("motion", body)
        for column in ("position_x", "velocity_y", "angularVelocity_z"):
            assert b[column] == pytest.approx(a[column], abs=1e-6)
    assert abs(case.table("forces")["contactForce_x"]).max() > 0


def test_restart_of_contact_that_holds_is_exact(tmp_path):
    """Two discs and a wall, while forces pull them off."""
    case = box2d(tmp_path, 20)
    case.gravity(y=4)
    case.bodies(
        discs([(0.1, -0.6), (0.6, -0.55)], velocities=[(1, -3), (0, -3)]),
        contact("viscous"),
    )
    case.controls(
        endTime=0.32, deltaT=0.01, writeControl="timeStep", writeInterval=16,
        writePrecision=17, timePrecision=15,
    )
    parts = BodyCase(case, tmp_path, "parts")
    case.solve()
    parts.controls(endTime=0.16)
    parts.solve()

    state = parts.path/"0.16/uniform/immersedBodies"
    kept = re.search(r"contactMultipliers \(([^;]*)\);", state.read_text())
    numbers = np.array(re.sub("[()]", " ", kept[1]).split(), dtype=float)
    gammas = numbers.reshape(-1, 9)[:, 7]
    assert len(gammas) >= 2
    assert gammas.max() < 0
    parts.controls(endTime=0.32)
    parts.solve()

    for file in ("U", "p", "uniform/immersedBodies"):
        expected = (case.path/case.latest_time()/file).read_bytes()
        assert (parts.path/parts.latest_time()/file).read_bytes() == expected


@pytest.mark.parametrize("model", MODELS)
def test_pair_across_a_cyclic_patch(model, tmp_path):
    """The same as in the middle of the box, to what the solvers leave, while
    one of them goes on through the patch."""
    motions = []
    for name, x in (("middle", 0.5), ("across", 0)):
        case = periodic_case(tmp_path, name, 24, 2, 0, True)
        direct_pressure(case)
        for field in ("U", "p"):
            path = case.path/"0"/field
            path.write_text(path.read_text().replace("(1 0 0)", "(0 0 0)"))
        case.bodies(
            "\n".join(
                f"disc{i} {{ shape {{ type disc; radius 0.2; }}"
                f" densityRatio 300; position ({(x + side*0.21) % 1} {y} 0);"
                f" velocity ({1 - side} 0 0); }}"
                for i, (side, y) in enumerate(((-1, 0.5), (1, 0.53)))
            ),
            contact(model),
        )
        case.controls(endTime=0.3, deltaT=0.01)
        case.solve()
        motions.append([case.table("motion", i) for i in (0, 1)])
        assert abs(case.table("forces")["contactForce_x"]).max() > 0

    for a, b in zip(*motions, strict=True):
        for column in ("velocity_x", "velocity_y", "angularVelocity_z"):
            assert b[column] == pytest.approx(a[column], abs=1e-5)


@pytest.mark.parametrize("model", MODELS)
def test_ball_stops_at_a_wall(model, tmp_path):
    case = BodyCase("box", tmp_path)
    case.mesh(*3*[uniform(-0.75, 0.75, 12)])
    case.gravity()
    case.bodies(
        f"ball {{ shape {{ type sphere; radius {RADIUS}; }} densityRatio 1e4;"
        " position (0.3 0.03 0.02); velocity (6 0 1); }",
        contact(model),
    )
    case.controls(endTime=0.08, deltaT=0.005)
    case.solve()

    motion, forces = case.table("motion"), case.table("forces")
    assert abs(motion["velocity_x"][-1]) < 1e-3
    assert motion["velocity_z"][-1] == pytest.approx(1, rel=0.01)
    assert motion["position_x"].max() < 0.5 + 1e-8*RADIUS
    mass = 1e4*4/3*np.pi*RADIUS**3
    impulse = 0.005*sum(forces["contactForce_x"])
    assert impulse == pytest.approx(-mass*6, rel=0.01)


def test_overlaps_at_the_start(tmp_path):
    """They are taken away without a push; too large ones are refused."""
    case = box2d(tmp_path, 20)
    small = BodyCase(case, tmp_path, "small")
    case.bodies(discs([(0, 0), (0.46, 0)]), contact("inelastic"))
    with pytest.raises(FoamError, match="'largestOverlap 0.1' in 'contact'"):
        case.solve()

    small.bodies(discs([(0, 0), (0.49, 0)]), contact("inelastic"))
    small.controls(endTime=0.1, deltaT=0.01)
    small.solve()
    assert gap(small)[-1] == pytest.approx(0, abs=1e-8)
    assert abs(small.table("motion")["velocity_x"]).max() < 1e-3
