# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs that end when the bodies have come to a steady state."""

import re

import numpy as np
import pytest

from bodyCase import BodyCase
from boxMesh import graded, uniform
from spreadRuns import write_twice

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


def fixed(folder, length, bodies, tolerance=1e-3):
    """A tube with fixed discs."""
    mesh = BodyCase("tube", folder, "mesh")
    mesh.mesh(uniform(-length/2, length/2, 10*length), uniform(-1, 1, 20))
    mesh.bodies(bodies, f"steady {{ tolerance {tolerance}; }}")
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
    return mesh


def check_ranks(mesh, folder, *ranks):
    """As many steps and the same forces; returns the logs."""
    found, logs = [], []
    for n, parts in ((1, None), *ranks):
        case = BodyCase(mesh, folder, f"ranks{n}")
        log = case.solve(n, parts)
        time = case.latest_time("processor0" if n > 1 else ".")
        assert float(time) == pytest.approx(0.1*steps(log))
        found.append((steps(log), case.columns("forces")["fluidForce_x"]))
        logs.append(log)

    assert len({n for n, _ in found}) == 1
    for _, force in found[1:]:
        assert force == pytest.approx(found[0][1], rel=1e-7)
    return logs


def test_fixed_body_on_any_number_of_ranks(tmp_path):
    """Stokes flow, in which diffusion sets the time scale."""
    mesh = fixed(tmp_path, 6, """
        disc
        {
            shape       { type disc; radius 0.25; }
            position    (-0.03 -0.3 0);
            motion      { type fixed; }
        }
    """)
    check_ranks(mesh, tmp_path, (2, (2, 1, 1)), (4, (2, 2, 1)))


def test_many_fixed_bodies(tmp_path):
    """Each rank holds those near to it, and knows when all are steady."""
    at = " ".join(
        f"({0.78*i - 15.1} {y} 0)" for i in range(40) for y in (-0.5, 0.53)
    )
    mesh = fixed(tmp_path, 32, f"""
        disc
        {{
            shape       {{ type disc; radius 0.2; }}
            positions   ({at});
            motion      {{ type fixed; }}
        }}
    """, 0.1)
    write_twice(mesh, 0.1, 1000)
    one, four = check_ranks(mesh, tmp_path, (4, (4, 1, 1)))
    assert "Bodies are spread over the ranks: 80" in four
    # Differences of forces from step to step
    assert residuals(four) == pytest.approx(residuals(one), rel=1e-5)
    names = [re.findall(r"residual \S+ \((.*)\)", log) for log in (one, four)]
    assert names[0] == names[1]


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
