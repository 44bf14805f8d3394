# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs that end when the bodies have come to a steady state."""

import re

import numpy as np
import pytest

from bodyCase import BodyCase
from boxMesh import graded, uniform

RADIUS, Y = 0.065, -0.3
# Re 2, body-fitted finite elements in the frame of the disc: see the benchmark
# freeDisc
SPEED, SPIN = 1.36128741, -0.44864746
WINDOW = "window { type comoving; direction (1 0 0); }"


def residuals(log):
    """Residual of each step from the second on."""
    found = re.findall(r"Steady state: residual (\S+) \(", log)
    return np.array(found, dtype=float)


def steps(log):
    """Number of steps of a run that has found the steady state."""
    return int(re.search(r"\nSteady after (\d+) steps", log).group(1))


@pytest.fixture(scope="module")
def free_disc(tmp_path_factory):
    """Disc of eight cells, free but for its height, in a window; meshed."""
    h = 2*RADIUS/8
    core = 4*RADIUS
    case = BodyCase("tube", tmp_path_factory.mktemp("steady"))
    case.mesh(
        graded(-3, 3, (-core, core), h), graded(-1, 1, (Y - core, Y + core), h)
    )
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius {RADIUS}; }}
            densityRatio 2;
            position    (0 {Y} 0);
            velocity    ambient;
            constraints {{ translate (1 0 0); }}
        }}
    """, f"{WINDOW}\nsteady {{ tolerance 1e-4; }}")
    case.controls(endTime="100", deltaT="0.1", writePrecision="15")
    # Or the residual does not fall smoothly at the end
    case.replace("system/fvSolution", "relTol          1e-3", "relTol 1e-6")
    return case


@pytest.mark.parametrize("scheme", ["Euler", "backward"])
def test_free_disc_ends_by_itself(scheme, free_disc, tmp_path):
    case = BodyCase(free_disc, tmp_path, "tube")
    case.replace("system/fvSchemes", "backward", scheme)
    log = case.solve()

    n = steps(log)
    assert 20 < n < 200
    assert set(re.findall(r"outer iterations (\d+)", log)) == {"1"}
    assert "not converged" not in log
    left = residuals(log)
    assert len(left) == n - 1
    assert (left[:-1] > 1e-4).all() and left[-1] < 1e-4

    motion = case.table("motion")
    assert len(motion["time"]) == n
    assert motion["velocity_x"][-1] == pytest.approx(SPEED, rel=1e-3)
    assert motion["angularVelocity_z"][-1] == pytest.approx(SPIN, rel=1e-3)

    # With all fields, and to go on from
    last = case.path / case.latest_time()
    assert float(last.name) == pytest.approx(0.1*n)
    for field in ("U", "p", "phi", "bodyFraction", "uniform/immersedBodies"):
        assert (last / field).exists(), field
    log = case.solve()
    assert steps(log) == 2


def test_a_short_time_step_is_not_a_steady_state(free_disc, tmp_path):
    case = BodyCase(free_disc, tmp_path, "tube")
    case.controls(endTime="1e-3", deltaT="1e-4")
    log = case.solve()

    assert "\nSteady after" not in log
    assert (residuals(log) > 1e-2).all()
    assert "Not steady after 10 steps: residual" in log


def test_fixed_body_on_any_number_of_ranks(tmp_path):
    """Stokes flow, in which diffusion sets the time scale."""
    mesh = BodyCase("tube", tmp_path, "mesh")
    mesh.mesh(uniform(-3, 3, 60), uniform(-1, 1, 20))
    mesh.bodies("""
        disc
        {
            shape       { type disc; radius 0.25; }
            position    (-0.03 -0.3 0);
            motion      { type fixed; }
        }
    """, "steady { tolerance 1e-3; }")
    # The solvers' errors, which depend on the ranks, are far below it
    for old, new in (
        ("GAMG;", "PCG;"),
        ("smoother        GaussSeidel", "preconditioner  DIC"),
        ("1e-8", "1e-12"), ("0.01", "0"), ("1e-9", "1e-12"), ("1e-3", "0"),
    ):
        mesh.replace("system/fvSolution", old, new)
    mesh.replace(
        "system/fvSchemes", "div(phi,U)          Gauss linear",
        "div(phi,U)          none",
    )
    mesh.controls(endTime="100", deltaT="0.1")

    found = []
    for ranks, parts in ((1, None), (2, (2, 1, 1)), (4, (2, 2, 1))):
        case = BodyCase(mesh, tmp_path, f"ranks{ranks}")
        log = case.solve(ranks, parts)
        folder = "processor0" if ranks > 1 else "."
        assert float(case.latest_time(folder)) \
            == pytest.approx(0.1*steps(log))
        found.append((steps(log), case.table("forces")["fluidForce_x"][-1]))

    assert len({n for n, _ in found}) == 1
    for _, force in found[1:]:
        assert force == pytest.approx(found[0][1], rel=1e-7)


def test_bodies_that_part_are_not_steady(free_disc, tmp_path):
    """Their window follows both: neither is at rest in it."""
    case = BodyCase(free_disc, tmp_path, "tube")
    case.replace(
        "constant/immersedBodyProperties",
        f"position    (0 {Y} 0);", f"positions   ((-0.6 {Y} 0) (0.6 0 0));",
    )
    case.controls(endTime="3")
    log = case.solve()

    assert "Not steady after 30 steps" in log
    assert residuals(log)[-1] > 0.01
