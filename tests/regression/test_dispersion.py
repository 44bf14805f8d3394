# SPDX-License-Identifier: GPL-3.0-or-later
"""Unresolved grains that turbulence disperses and shear lifts: diffusivity of
tracers, momentum, processors, restart, a frozen fluid."""

import numpy as np
import pytest

import refusals
from bodyCase import BodyCase
from unresolvedBox import GRAINS, grain_box, momentum, velocities

WALK = """
    dispersion { type discreteRandomWalk; }
    lift { type (SaffmanMei OesterleBuiDinh); }
"""
HEADER = """FoamFile
{{
    version     2.0;
    format      ascii;
    class       {kind};
    object      {name};
}}
"""
FIELD = """
dimensions      [0 2 {seconds} 0 0 0 0];

internalField   uniform {value};

boundaryField {{ ".*" {{ type cyclic; }} }}
"""


def turbulent(case, k, epsilon):
    """The case with kEpsilon, and these values at the start."""
    (case.path/"constant/turbulenceProperties").write_text(
        HEADER.format(kind="dictionary", name="turbulenceProperties")
        + "simulationType RAS;\n"
          "RAS { RASModel kEpsilon; turbulence on; printCoeffs off; }\n")
    for name, seconds, value in (
            ("k", -2, k), ("epsilon", -3, epsilon),
            ("nut", -1, 0.09*k**2/epsilon)):
        (case.path/"0"/name).write_text(
            HEADER.format(kind="volScalarField", name=name)
            + FIELD.format(seconds=seconds, value=value))
    case.replace(
        "system/fvSchemes", "div(phi,U)          Gauss linear;",
        "div(phi,U)          Gauss linear;\n"
        "    div((nuEff*dev2(T(grad(U))))) Gauss linear;\n"
        '    "div\\(phi,(k|epsilon)\\)" Gauss upwind;',
    )
    case.replace(
        "system/fvSolution", '"(U|UFinal)"', '"(U|k|epsilon).*"'
    )
    return case


def tracers(folder, number, sigma, lifetime):
    """Grains that go with the fluid, along x at a speed of 1."""
    k = 1.5*sigma**2
    case = turbulent(
        grain_box(folder, "tracers", nu=1e-3), k, 0.3*k/lifetime
    )
    side = (np.arange(number) + 0.5)/number
    lines = "\n".join(
        f"({x:.9g} {y:.9g} {z:.9g})" for x in side for y in side for z in side
    )
    (case.path/"constant/places").write_text(f"(\n{lines}\n)\n")
    case.bodies(
        "grain { shape { type sphere; radius 1e-5; } densityRatio 1;"
        ' positionsFile "constant/places"; velocity (1 0 0); }',
        "coupling { type unresolved; fluid frozen;"
        " dispersion { type discreteRandomWalk; } }",
    )
    return case


def unwrapped(case, bodies):
    """Positions by body and time step."""
    paths = []
    for i in range(bodies):
        motion = case.table("motion", i)
        paths.append(
            np.stack([motion[f"unwrapped_{k}"] for k in "xyz"], axis=1))
    return np.array(paths)


def test_tracers_spread_by_the_lifetime_of_eddies(tmp_path):
    """Of constant lifetime t: variance n (sigma t)^2 after n eddies, that is a
    diffusivity of sigma^2 t/2; sigma^2 = 2k/3."""
    sigma, lifetime, steps = 0.5, 0.05, 4
    case = tracers(tmp_path, 6, sigma, lifetime)
    case.controls(endTime=2, deltaT=lifetime/steps)
    log = case.solve()
    assert "frozen fluid" in log
    assert "Solving for" not in log

    paths = unwrapped(case, 6**3)
    eddies = 8
    moved = np.diff(paths[:, ::eddies*steps], axis=1)
    samples = moved.reshape(-1, 3) - [eddies*lifetime, 0, 0]
    expected = eddies*(sigma*lifetime)**2
    # 4 standard deviations
    assert np.mean(samples**2) == pytest.approx(
        expected, rel=4*np.sqrt(2/samples.size)
    )
    assert np.mean(samples, axis=0) == pytest.approx(
        0, abs=4*np.sqrt(expected/len(samples))
    )


def test_momentum_is_conserved(tmp_path):
    case = turbulent(grain_box(tmp_path, nu=1e-2, coupling=WALK), 0.5, 0.5)
    plain = turbulent(grain_box(tmp_path, "plain", nu=1e-2), 0.5, 0.5)
    case.solve()
    plain.solve()

    total = momentum(case)
    for i in range(len(GRAINS)):
        change = velocities(case, i) - velocities(plain, i)
        assert np.abs(change).max() > 1e-3
    assert total == pytest.approx(
        np.broadcast_to(total[0], total.shape), abs=1e-11
    )


@pytest.mark.parametrize("ranks, parts", [(2, (1, 1, 2)), (4, (2, 1, 2))])
def test_same_on_several_ranks(ranks, parts, tmp_path):
    one = turbulent(grain_box(tmp_path, coupling=WALK), 0.5, 2)
    several = BodyCase(one, tmp_path, "several")
    one.solve()
    several.solve(ranks, parts)

    for i in range(len(GRAINS)):
        a, b = one.table("motion", i), several.table("motion", i)
        for column in a:
            assert b[column] == pytest.approx(a[column], abs=1e-7), column


@pytest.mark.parametrize("ranks", [1, 2])
def test_restart_is_exact(ranks, tmp_path):
    at_once = turbulent(
        grain_box(tmp_path, scheme="Euler", coupling=WALK), 0.5, 2
    )
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
    for name in ("U", "phi", "p", "k", "uniform/immersedBodies"):
        a, b = (
            (case.path/place/case.latest_time(place)/name).read_bytes()
            for case in (at_once, parts)
        )
        assert a == b, name
        if name == "uniform/immersedBodies":
            assert b"eddy" in a


WRONG = {
    "type unresolved; dispersion { type discreteRandomWalk; }":
        "needs a turbulence model",
    "type auto; fluid frozen;":
        "all unresolved",
    "type unresolved; fluid frosen;":
        "frozen",
    "type unresolved; lifts { type SaffmanMei; }":
        "nearest valid one",
}


@pytest.fixture(scope="module")
def refused(tmp_path_factory):
    folder = tmp_path_factory.mktemp("refused")
    return refusals.of_copies(grain_box(folder), folder, {
        coupling: lambda case, coupling=coupling: case.replace(
            "constant/immersedBodyProperties", "type unresolved; ", coupling
        )
        for coupling in WRONG
    })


@pytest.mark.fast
@pytest.mark.parametrize("coupling", WRONG)
def test_what_cannot_be_is_refused(coupling, refused):
    refused[coupling].names(WRONG[coupling])
