# SPDX-License-Identifier: GPL-3.0-or-later
"""Rough and slipping walls (robinVelocity) against closed forms."""

import numpy as np
import pytest

import roundTube
from boxMesh import uniform
from wallFlow import (
    CASE, NU, WallFlow, annulus, channel, order, rough_profile, steps, turned,
    vector,
)

ROTATIONS = {
    "2D": (turned(33), False),
    "3D": (turned(50, (1, 2, 3)), True),
}


def rough(case, rotation, a, K, walls=("top", "bottom")):
    """Set rough walls; K along the channel."""
    for wall in walls:
        case.condition(
            wall, f"type robinVelocity; a {a:.16g}; "
            f"K {vector(rotation @ (K, 0, 0))};",
        )


def drive(a, K, Q):
    """Body force over nu of that flow."""
    return -(6*K - 3*a*Q)/(2*(3 + a))


def profile_error(case, rotation, exact):
    """Largest error of the velocity, over the largest velocity."""
    x, u = case.centres() @ rotation, case.values("U") @ rotation
    error = u - np.outer(exact(x[:, 1]), (1, 0, 0))
    return np.abs(error).max()/np.abs(exact(x[:, 1])).max()


@pytest.mark.parametrize("a, K", [(1, 0), (1, 5), (30, -20)])
@pytest.mark.parametrize("space", ROTATIONS)
def test_rough_profile_is_of_second_order(space, a, K, tmp_path):
    rotation, three_d = ROTATIONS[space]
    errors = []
    for cells in (8, 16):
        case = channel(tmp_path, f"c{cells}", cells, rotation, three_d)
        rough(case, rotation, a, K)
        case.force(rotation @ (NU*drive(a, K, 2), 0, 0))
        x = case.centres() @ rotation
        u = rough_profile(x[:, 1], a, K, 2)
        case.start(np.outer(u, rotation[:, 0]))
        steps(case, 400, 0.04)
        case.run("foamRun")
        errors.append(profile_error(
            case, rotation, lambda y: rough_profile(y, a, K, 2)
        ))
    assert errors[-1] < 6e-3
    assert order(errors) == pytest.approx(2, abs=0.15)


@pytest.mark.parametrize("entry", [
    "slipLength 0.25; wallVelocity (3 0 0)", "a 4; wallVelocity (3 1 0)",
    "a 4; K (12 0 0)", "slipLength constant 0.25; K table ((0 (12 5 0)))",
])
def test_couette_by_a_moving_rough_wall(entry, tmp_path):
    case = channel(tmp_path, "couette", 8)
    case.condition("top", f"type robinVelocity; {entry};")
    case.condition("bottom", "type robinVelocity; slipLength 0.5;")
    case.run("foamRun")
    # Linear: exact on any mesh
    shear = 3/(2 + 0.25 + 0.5)
    assert profile_error(
        case, np.eye(3), lambda y: shear*(1.5 + y)
    ) < 1e-9


@pytest.mark.parametrize("a", [1e-9, 1e-3, 1, 1e3, 1e9])
def test_from_free_slip_to_no_slip(a, tmp_path):
    case = channel(tmp_path, "limit", 8, ROTATIONS["2D"][0])
    case.condition("top", f"type robinVelocity; a {a}; "
                   f"wallVelocity {vector(ROTATIONS['2D'][0] @ (3, 0, 0))};")
    steps(case, 400, 1)
    case.run("foamRun")
    shear = 3*a/(1 + 2*a)
    assert profile_error(
        case, ROTATIONS["2D"][0], lambda y: shear*(1 + y)
    ) < 1e-6


def test_slip_length_zero_is_no_slip(tmp_path):
    results = []
    for name, entries in {
        "rough": "type robinVelocity; slipLength 0; wallVelocity (3 0 0);",
        "fixed": "type fixedValue; value uniform (3 0 0);",
    }.items():
        case = channel(tmp_path, name, 8)
        case.condition("top", entries)
        steps(case, 3, 1)
        case.run("foamRun")
        results.append(case.values("U"))
    assert np.array_equal(*results)


def rotating(case, spin):
    """Entry of the velocity of the inner cylinder."""
    x = case.centres("bottom")
    velocity = "".join(vector((-spin*y, spin*x, 0)) for x, y, _ in x)
    return f"nonuniform List<vector> {len(x)}({velocity})"


def test_free_slip_is_symmetry(tmp_path):
    results = []
    for name, entries in {
        "rough": "type robinVelocity; a 0;", "slip": "type slip;",
    }.items():
        case = annulus(tmp_path, name, 0.5, 1, 6)
        case.condition("top", entries)
        case.condition("bottom", f"type fixedValue; value {rotating(case, 3)};")
        case.force((1, 0, 0))
        steps(case, 10, 0.01)
        case.run("foamRun")
        results.append(case.values("U"))
    assert np.abs(results[0] - results[1]).max() < 1e-12


def test_round_tube_with_slip(tmp_path):
    """u = G ((1 - r^2)/4 + 1/(2 a)), G the pressure gradient over nu."""
    a, errors = 3, []
    for h in (0.2, 0.1):
        case = WallFlow(CASE, tmp_path, f"tube{h}")
        roundTube.write(case, uniform(0, 0.4, 2), h)
        case.run("blockMesh")
        case.condition("inlet", f"type fixedValue; value uniform {NU*0.4};",
                       "p")
        case.condition("walls", f"type robinVelocity; a {a};")
        steps(case, 300, 0.02)
        case.run("foamRun")
        r2 = (case.centres()[:, 1:]**2).sum(axis=1)
        exact = (1 - r2)/4 + 1/(2*a)
        u = case.values("U")
        errors.append(np.abs(u[:, 0] - exact).max()/exact.max())
        assert np.abs(u[:, 1:]).max() < 1e-3
    assert errors[-1] < 6e-3
    assert order(errors)[0] > 1.5


def test_flow_between_rotating_rough_cylinders(tmp_path):
    """u = A r + C/r: of the Cartesian components, the normal derivative along
    the wall is du/dr at the outer cylinder, -du/dr at the inner one.

    By icoFoam: the transposed stress of others, from gradients in the cells,
    has an error of first order on walls that are curved and slip."""
    inner, outer, a, b, spin = 0.5, 1, 4, 2, 3
    # -u' + a u = a spin inner;  u' + b u = 0
    A, C = np.linalg.solve(
        [[-1 + a*inner, inner**-2 + a/inner],
         [1 + b*outer, -outer**-2 + b/outer]], [a*spin*inner, 0],
    )
    errors = []
    for cells in (5, 10):
        case = annulus(tmp_path, f"r{cells}", inner, outer, cells)
        case.condition("bottom", f"type robinVelocity; a {a}; "
                       f"wallVelocity {rotating(case, spin)};")
        case.condition("top", f"type robinVelocity; a {b};")
        steps(case, 400, 0.01)
        case.replace("system/fvSolution", "PIMPLE", "PISO")
        case.run("icoFoam")
        x, u = case.centres(), case.values("U")
        r = np.hypot(x[:, 0], x[:, 1])
        along = (x[:, 0]*u[:, 1] - x[:, 1]*u[:, 0])/r
        exact = A*r + C/r
        errors.append(np.abs(along - exact).max()/exact.max())
    assert errors[-1] < 4e-3
    assert order(errors)[0] > 1.7


def test_wall_shear_stress(tmp_path):
    """nu (K - a u_t) of the velocity at the wall, and what drives the flow."""
    a, K, rotation = 2, 1, turned(33)
    case = channel(tmp_path, "stress", 8, rotation)
    rough(case, rotation, a, K)
    case.force(rotation @ (0.3, 0, 0))
    case.replace("system/controlDict", "functions\n{\n", """functions
{
    wallShearStress
    {
        type        wallShearStress;
        libs        (fieldFunctionObjects);
        writeControl writeTime;
    }
""")
    steps(case, 200, 1)
    case.run("foamRun")
    along = rotation[:, 0]
    for wall in ("top", "bottom"):
        u = case.values("U", patch=wall) @ along
        stress = case.values("wallShearStress", patch=wall) @ rotation
        # Force on the fluid per area
        assert stress[:, 0] == pytest.approx(NU*(K - a*u), rel=1e-8)
        assert stress[:, 0] == pytest.approx(-0.3, rel=1e-6)
        assert np.abs(stress[:, 1]).max() < 1e-9


def test_nothing_flows_through(tmp_path):
    case = annulus(tmp_path, "flux", 0.5, 1, 6)
    case.condition("bottom", "type robinVelocity; a 2; K (1 0 0);")
    case.condition("top", "type robinVelocity; a 1; K (0 2 0);")
    steps(case, 20, 0.01)
    log = case.run("foamRun")
    assert "cumulative" in log
    for wall in ("top", "bottom"):
        assert np.abs(case.values("phi", patch=wall)).max() < 1e-15
    assert np.abs(case.values("U")).max() > 0.01
