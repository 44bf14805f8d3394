# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies smaller than the cells: terminal velocity, exchange of momentum with
the fluid, processors, restart."""

import numpy as np
import pytest

from bodyCase import BodyCase
from boxMesh import uniform
from fallingGrain import (
    falling_dust, falling_grain, limit, standard_drag, terminal_velocity,
)
from periodicBox import superficial_speed
from unresolvedBox import GRAINS, bed, grain_box, momentum, velocities


def test_standard_drag_of_the_reference():
    # Clift, Grace & Weber (1978), 2 mm and 1000 kg/m3 in air
    assert terminal_velocity(0.002, 1000) == pytest.approx(6.722, abs=1e-3)


@pytest.mark.parametrize("cells", [1, 0.3])
def test_terminal_velocity_of_a_rapeseed(cells, tmp_path):
    D = 0.002
    case, _ = falling_grain(tmp_path, "fall", D, cells, start=0.97, courant=4)
    log = case.solve()

    speed = case.table("motion")["velocity_x"]
    assert limit(speed) == pytest.approx(
        terminal_velocity(D, 1000), rel=0.005
    )
    assert "outer iterations 1," in log
    assert "outer iterations 2" not in log


def test_terminal_velocity_at_low_reynolds_number(tmp_path):
    """Where a grain drags along a fifth of its speed in its kernel."""
    case, _ = falling_dust(tmp_path, "dust", 1)
    case.solve()
    assert case.table("motion")["velocity_x"][-1] == pytest.approx(
        terminal_velocity(60e-6, 1000), rel=0.005
    )


def haider_levenspiel(Re, psi):
    """Drag coefficient, Haider & Levenspiel (1989), for a sphericity."""
    A = np.exp(2.3288 - 6.4581*psi + 2.4486*psi**2)
    B = 0.0964 + 0.5565*psi
    C = np.exp(4.905 - 13.8944*psi + 18.4222*psi**2 - 10.2599*psi**3)
    D = np.exp(1.4681 + 12.2584*psi - 20.7322*psi**2 + 15.8855*psi**3)
    return 24/Re*(1 + A*Re**B) + C/(1 + D/Re)


def test_a_cube_falls_by_its_sphericity(tmp_path):
    D = 0.002
    side, psi = (np.pi/6)**(1/3)*D, (np.pi/6)**(1/3)

    def drag(Re):
        return standard_drag(Re)*(
            haider_levenspiel(Re, psi)/haider_levenspiel(Re, 1)
        )

    expected = terminal_velocity(D, 1000, drag=drag)
    assert expected < 0.8*terminal_velocity(D, 1000)

    case, _ = falling_grain(
        tmp_path, "cube", D, 0.3,
        start=1.03*expected/terminal_velocity(D, 1000),
        shape=f"type box; size ({side:.9g} {side:.9g} {side:.9g});",
    )
    case.solve()
    assert limit(case.table("motion")["velocity_x"]) == pytest.approx(
        expected, rel=0.005
    )


def test_drag_model_that_is_selected_acts(tmp_path):
    def schiller_naumann(Re):
        return 24/Re*(1 + 0.15*Re**0.687)

    case, _ = falling_grain(
        tmp_path, "fall", 0.002, 0.3, start=1.03,
        coupling="type unresolved; dragModel { type SchillerNaumann; }",
    )
    case.solve()
    assert limit(case.table("motion")["velocity_x"]) == pytest.approx(
        terminal_velocity(0.002, 1000, drag=schiller_naumann), rel=0.005
    )


@pytest.mark.parametrize("nu, scheme", [
    (0.5, "backward"), (1e-4, "Euler"), (50, "backward"),
])
def test_momentum_is_conserved(nu, scheme, tmp_path):
    case = grain_box(tmp_path, nu=nu, scheme=scheme)
    case.solve()

    total = momentum(case)
    change = sum(
        (ratio - 1)*4/3*np.pi*radius**3
        * np.ptp(velocities(case, i), axis=0)
        for i, (ratio, radius, _, _) in enumerate(GRAINS)
    )
    assert np.abs(change).max() > 1e-4
    assert total == pytest.approx(
        np.broadcast_to(total[0], total.shape), abs=1e-11
    )


def test_drag_brings_grains_to_the_fluid(tmp_path):
    """However stiff: relaxation times of 1e-5 of the time step."""
    case = grain_box(tmp_path, nu=50)
    case.solve()

    for i in range(len(GRAINS)):
        U = velocities(case, i)
        assert np.abs(U).max() < 1.2
        assert U[-1] == pytest.approx([1, 0, 0], abs=0.01)


@pytest.mark.parametrize("phi, nu, number", [
    (0.2, 0.5, 12), (0.4, 0.005, 12), (0.2, 0.5, 6),
])
def test_bed_has_the_pressure_gradient_of_its_drag_law(
    phi, nu, number, tmp_path
):
    case = bed(tmp_path, phi, nu, number)
    case.solve()
    assert superficial_speed(case)[-1] == pytest.approx(1, abs=2e-3)


@pytest.mark.parametrize("ranks, parts", [(2, (1, 1, 2)), (4, (2, 1, 2))])
def test_same_on_several_ranks(ranks, parts, tmp_path):
    one = grain_box(tmp_path)
    several = BodyCase(one, tmp_path, "several")
    one.solve()
    several.solve(ranks, parts)

    for i in range(len(GRAINS)):
        a, b = one.table("motion", i), several.table("motion", i)
        for column in a:
            assert b[column] == pytest.approx(a[column], abs=1e-9)


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("scheme", ["backward", "Euler"])
def test_restart_is_exact(scheme, ranks, tmp_path):
    at_once = grain_box(tmp_path, scheme=scheme)
    # The sums of fastPoisson may differ in the last bit from run to run
    at_once.replace(
        "system/fvSolution", "fastPoisson", "PCG; preconditioner DIC"
    )
    at_once.controls(
        endTime=0.2, writeControl="timeStep", writeInterval=5,
        writePrecision=17, timePrecision=15,
    )
    if ranks > 1:
        at_once.decompose(ranks)
    parts = BodyCase(at_once, tmp_path, "parts")
    at_once.solve(ranks)
    parts.controls(endTime=0.1)
    parts.solve(ranks)
    parts.controls(endTime=0.2)
    parts.solve(ranks)

    place = "processor0" if ranks > 1 else "."
    for name in ("U", "phi", "p", "bodyFraction", "uniform/immersedBodies"):
        a, b = (
            (case.path/place/case.latest_time(place)/name).read_bytes()
            for case in (at_once, parts)
        )
        assert a == b, name


def test_a_grain_enters_where_the_cells_grow(tmp_path):
    """Fine enough for it at its centre, 0.100 m, but not at its surface, 0.121
    m; there is no body before."""
    case = BodyCase("box", tmp_path)
    case.mesh(uniform(-1, 1, 20), uniform(-1, 1, 20),
              [-1, (2, 20, 1.1**19)])
    case.bodies("", """
        coupling { type auto; }
        injection
        {
            one
            {
                shape { type sphere; radius 0.225; }
                densityRatio 2;
                position (0 0 -0.3034);
                times (0.02);
            }
        }
    """)
    case.controls(endTime=0.02, deltaT=0.02, writeInterval=0.02,
                  writeFormat="ascii")
    log = case.solve()
    assert "bodies 1," in log
    assert "resolved from now on" not in log

    # It is seen at once
    assert case.field("bodyFraction").max() > 0
