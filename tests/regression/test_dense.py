# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains whose volume is part of the equations of the fluid: volume, momentum,
pressure drop of beds, settling, limits, ranks, restart. Fluidisation is in
test_dense_columns."""

import numpy as np
import pytest
from scipy.optimize import brentq

import refusals
from bodyCase import BodyCase
from denseBox import (
    MOVING, bed, drag_force, ergun, gidaspow, lone_grain, moving_box,
    suspension,
)
from periodicBox import superficial_speed
from unresolvedBox import tenneti, velocities

VOLUMES = [4/3*np.pi*radius**3 for _, radius, _, _ in MOVING]


@pytest.mark.parametrize("phi, nu, drag, K", [
    (0.45, 0.5, "Ergun", ergun), (0.6, 0.0005, "Ergun", ergun),
    (0.1, 0.05, "Gidaspow", gidaspow), (0.45, 0.05, "Tenneti", tenneti),
])
def test_bed_has_the_pressure_gradient_of_its_drag_law(
    phi, nu, drag, K, tmp_path
):
    case = bed(tmp_path, phi, nu, K, drag)
    case.controls(endTime=10, deltaT=0.2)
    case.solve()
    assert superficial_speed(case)[-1] == pytest.approx(1, abs=1e-6)


@pytest.mark.parametrize("nu", [1e-4, 0.5, 50])
def test_volume_and_momentum_are_kept(nu, tmp_path):
    """By grains that move through the fluid, however stiff the drag."""
    case = moving_box(tmp_path, nu=nu)
    log = case.solve()

    errors = [
        float(line.split("local = ")[1].split(",")[0])
        for line in log.splitlines() if "continuity errors" in line
    ]
    assert max(errors) < 1e-14

    V = 1/12**3
    times = case.times()[1:]
    voids = [case.field("voidFraction", time)[:, 0] for time in times]
    for void in voids:
        assert (1 - void).sum()*V == pytest.approx(sum(VOLUMES), rel=1e-13)
    assert np.abs(voids[-1] - voids[0]).max() > 0.01

    # That of the fluid with the void fraction at the begin of the step
    U = [velocities(case, i) for i in range(len(MOVING))]
    total = np.array([
        (void[:, None]*case.field("U", time)).sum(axis=0)*V + sum(
            grain[0]*volume*speed[n + 1]
            for grain, volume, speed in zip(MOVING, VOLUMES, U)
        )
        for n, (void, time) in enumerate(zip(voids, times[1:]))
    ])
    assert np.ptp(U[0], axis=0).max() > 0.1
    assert total == pytest.approx(
        np.broadcast_to(total[0], total.shape), abs=1e-11
    )


@pytest.mark.parametrize("phi, ratio, nu, drag, K", [
    (0.15, 2.5, 0.01, "Gidaspow", gidaspow),
    (0.45, 1000, 1, "Gidaspow", gidaspow), (0.3, 0.1, 0.01, "Tenneti", tenneti),
])
def test_suspension_settles_by_its_drag_law(
    phi, ratio, nu, drag, K, tmp_path
):
    """A force holds it: the fluid rises as the grains fall."""
    g = 1
    case, D = suspension(tmp_path, phi, ratio, nu, g, drag)
    case.solve()
    W = brentq(
        lambda W: drag_force(K, W, D, nu, phi)
        - abs(ratio - 1)*np.pi/6*D**3*g, 1e-9, 100,
    )
    fluid = case.field("U")
    grain = velocities(case, 0)[-1]
    slip = (fluid.mean(axis=0) - grain)*(1 - phi)
    assert slip[0] == pytest.approx(np.sign(ratio - 1)*W, rel=1e-6)
    assert slip[1:] == pytest.approx(0, abs=1e-9)

    # What began at rest has no momentum
    assert (1 - phi)*fluid.mean(axis=0)[0] == pytest.approx(
        -ratio*phi*grain[0], abs=1e-10
    )


@pytest.mark.parametrize("nu, ratio", [(0.01, 1000), (0.1, 2.5)])
def test_one_small_grain_is_as_without_void_fraction(nu, ratio, tmp_path):
    speeds = []
    for dense in (False, True):
        case = lone_grain(tmp_path, f"{dense}", nu, ratio, dense)
        case.solve()
        speeds.append(velocities(case, 0))
    assert np.ptp(speeds[0][:, 0]) > 0.5
    assert speeds[1] == pytest.approx(speeds[0], abs=1e-3)


@pytest.mark.parametrize("ranks, parts", [(2, (1, 1, 2)), (4, (2, 1, 2))])
def test_same_on_several_ranks(ranks, parts, tmp_path):
    one = moving_box(tmp_path)
    several = BodyCase(one, tmp_path, "several")
    one.solve()
    several.solve(ranks, parts)

    for i in range(len(MOVING)):
        a, b = one.table("motion", i), several.table("motion", i)
        for column in a:
            assert b[column] == pytest.approx(a[column], abs=1e-9)


@pytest.mark.parametrize("ranks", [1, 2])
def test_restart_is_exact(ranks, tmp_path):
    at_once = moving_box(tmp_path)
    at_once.controls(writeInterval=5, timePrecision=15)
    if ranks > 1:
        at_once.decompose(ranks)
    parts = BodyCase(at_once, tmp_path, "parts")
    at_once.solve(ranks)
    for end in (0.1, 0.2):
        parts.controls(endTime=end)
        parts.solve(ranks)

    place = "processor0" if ranks > 1 else "."
    for name in ("U", "phi", "p", "voidFraction", "uniform/immersedBodies"):
        a, b = (
            (case.path/place/case.latest_time(place)/name).read_bytes()
            for case in (at_once, parts)
        )
        assert a == b, name


WRONG = {
    "word": ("voidFraction maybe;", ["'voidFraction maybe'", "yes", "no"]),
    "type": (
        "type auto;", ["'voidFraction yes'", "'type unresolved'", "'auto'"]
    ),
    "frozen": (
        "fluid frozen;", ["'voidFraction yes'", "'fluid solved'", "'frozen'"]
    ),
    "limit": ("minVoidFraction 1;", ["'minVoidFraction 1'", "less than 1"]),
}
WRONG_BODIES = {
    "resolved": (
        "coupling resolved;",
        ["'voidFraction yes'", "all 'unresolved'", "'resolved'"],
    ),
    "constraints": (
        "constraints { translate (1 0 1); rotate (1 1 1); }",
        ["'translate'", "(1 0 1)", "allowed are (1 1 1) and (0 0 0)"],
    ),
}
GRAIN = """one
{{
    shape           {{ type sphere; radius 0.05; }}
    densityRatio    2;
    position        (0.5 0.5 0.5);
    {}
}}"""


def wrong_scheme(case):
    case.replace("system/fvSchemes", "Euler", "backward")



def wrong_window(case):
    path = case.path/"constant/immersedBodyProperties"
    path.write_text(
        path.read_text() + "window { type comoving; direction (1 0 0); }\n"
    )


def with_entry(entry, grain=""):
    def change(case):
        first = "" if entry.startswith("type") else "type unresolved;"
        second = "" if entry.startswith("voidF") else "voidFraction yes;"
        case.bodies(
            GRAIN.format(grain), f"coupling {{ {first} {second} {entry} }}"
        )
    return change


@pytest.fixture(scope="module")
def refused(tmp_path_factory):
    folder = tmp_path_factory.mktemp("refused")
    case = moving_box(folder, "base")
    with_entry("")(case)
    return refusals.of_copies(case, folder, {
        "scheme": wrong_scheme,
        "window": wrong_window,
        **{name: with_entry(entry) for name, (entry, _) in WRONG.items()},
        **{
            name: with_entry("", entry)
            for name, (entry, _) in WRONG_BODIES.items()
        },
    })


@pytest.mark.fast
@pytest.mark.parametrize("wrong", [*WRONG, *WRONG_BODIES])
def test_wrong_entries_are_refused(wrong, refused):
    parts = {**WRONG, **WRONG_BODIES}[wrong][1]
    refused[wrong].names(*parts, "immersedBodyProperties")


@pytest.mark.fast
def test_what_does_not_go_with_a_void_fraction_is_refused(refused):
    refused["scheme"].names("'backward'", "allowed is 'Euler'", "fvSchemes")
    refused["window"].names(
        "'type comoving'", "allowed is 'type fixed'", "immersedBodyProperties"
    )
