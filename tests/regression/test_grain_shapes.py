# SPDX-License-Identifier: GPL-3.0-or-later
"""Unresolved grains that are no spheres: drag, lift and torque by shape and
orientation, and contact by their own shape."""

import re
import sys
from pathlib import Path

import numpy as np
import pytest

import boxMesh
import refusals
import restarts
from bodyCase import BodyCase
from boxMesh import uniform
from fallingGrain import MU, RHO, falling_grain, limit, terminal_velocity
from unresolvedBox import GRAINS, grain_box, momentum, velocities

sys.path.insert(0, str(Path(__file__).parents[1]/"benchmarks"))

from report import Report  # noqa: E402

spheroidDrag = Report.load(Path(__file__).parents[1]/"benchmarks/spheroid")

# Wheat as in etc/grains: semi-axes [m], density [kg/m3]
WHEAT, WHEAT_DENSITY = np.array([3.54e-3, 1.33e-3, 1.21e-3]), 1240


def spheroid(aspect, radius):
    """Of the volume of a sphere of this radius, with its axis along y."""
    b = radius/aspect**(1/3)
    return f"type ellipsoid; semiAxes ({b:.12g} {aspect*b:.12g} {b:.12g});"


def sphericity(a):
    """Of an ellipsoid, by the area of many faces."""
    u = np.linspace(0, np.pi, 801)
    v = np.linspace(0, 2*np.pi, 801)
    u, v = np.meshgrid(0.5*(u[1:] + u[:-1]), 0.5*(v[1:] + v[:-1]))
    normal = np.array([
        a[1]*a[2]*np.sin(u)*np.cos(v), a[0]*a[2]*np.sin(u)*np.sin(v),
        a[0]*a[1]*np.cos(u),
    ])
    area = (np.sqrt((normal**2).sum(axis=0))*np.sin(u)).sum()
    area *= np.pi/800*2*np.pi/800
    return np.pi*(8*np.prod(a))**(2/3)/area


def hoelzer_sommerfeld(Re, a, axis):
    """Drag coefficient of an ellipsoid along an axis, Hoelzer & Sommerfeld
    (2008), over that of a sphere; at large Re the Stokes part counts little."""
    psi = sphericity(a)
    section = np.prod(np.delete(a, axis))/np.prod(a)**(2/3)
    shape = 0.42*10**(0.4*(-np.log10(psi))**0.2)*section
    stokes = {0: 0.9707, 1: 1.1600, 2: 1.1855}[axis]
    return (
        24*stokes/Re + 3/np.sqrt(Re)/psi**0.75 + shape
    )/(24/Re + 3/np.sqrt(Re) + 0.42)


def standard(Re):
    """Clift, Grace & Weber (1978), for Re from 1500 to 12 000, and from 260."""
    w = np.log10(Re)
    if Re <= 1500:
        return 10**(1.6435 + w*(-1.1242 + w*0.1558))
    return 10**(-2.4571 + w*(2.5558 + w*(-0.9295 + w*0.1049)))


@pytest.mark.parametrize("axis, turn", [
    (2, "axis (0 1 0); angle 90"), (0, "axis (0 0 1); angle 0"),
])
def test_wheat_falls_by_its_orientation(axis, turn, tmp_path):
    """With its smallest and with its largest axis along the path: kernels that
    fall freely have 6.81 to 8.63 m/s (Int. Agrophys. 28 (2014) 389)."""
    D = 2*np.prod(WHEAT)**(1/3)
    expected = terminal_velocity(
        D, WHEAT_DENSITY,
        drag=lambda Re: standard(Re)*hoelzer_sommerfeld(Re, WHEAT, axis),
    )
    sphere = terminal_velocity(D, WHEAT_DENSITY)
    case, _ = falling_grain(
        tmp_path, "wheat", D, 0.3, WHEAT_DENSITY, start=1.02*expected/sphere,
        coupling="type unresolved; shapeModel { type ellipsoid; }",
        shape="type ellipsoid; semiAxes ({} {} {});".format(*WHEAT),
        grain=f"orientation {{ type axisAngle; {turn}; }}", end=1.2,
    )
    case.solve()
    speed = limit(case.table("motion")["velocity_x"])
    assert speed == pytest.approx(expected, rel=0.01)
    if axis == 2:
        assert 6.31 < speed < 8.63


@pytest.mark.parametrize("direction", spheroidDrag.STOKES)
def test_drag_of_a_resolved_spheroid_and_by_the_law(direction, tmp_path):
    """Both in Stokes flow, aspect ratio 2.5, against Oberbeck (1876); the
    resolved one has 7 cells per diameter of the sphere of its volume."""
    exact = spheroidDrag.STOKES[direction]
    law = spheroidDrag.by_law(tmp_path, direction, 1e-6, "ellipsoid")
    assert law == pytest.approx(exact, rel=1e-4)
    _, resolved = spheroidDrag.in_stokes_flow(tmp_path, direction, 32, 7)
    assert resolved == pytest.approx(exact, rel=0.015)


def shear_case(folder, name, form, angle, steps, G=1.0, model="ellipsoid"):
    """A small neutral grain in a frozen flow u = (G y, 0, 0)."""
    case = BodyCase("box", folder, name)
    boxMesh.write(
        case, *3*[uniform(-1, 1, 8)], {"walls": "x- x+ y- y+ z- z+"}
    )
    case.run("blockMesh")
    y = np.tile(np.repeat(-1 + (np.arange(8) + 0.5)/4, 8), 8)
    field = "\n".join(f"({G*v:.9g} 0 0)" for v in y)
    text = (case.path/"0/U").read_text()
    (case.path/"0/U").write_text(text.replace(
        "internalField   uniform (0 0 0);",
        f"internalField nonuniform List<vector> {len(y)}\n(\n{field}\n);",
    ))
    case.bodies(
        f"grain {{ shape {{ {form} }} densityRatio 1.0001;"
        f" position (0 0 0); orientation {{ type axisAngle; axis (0 0 1);"
        f" angle {angle}; }} }}",
        "coupling { type unresolved; fluid frozen;"
        f" shapeModel {{ type {model}; }} }}",
    )
    case.gravity()
    case.replace("constant/transportProperties", "0.1;", "100;")
    end = 2.2*18.22124/G
    case.controls(endTime=end, deltaT=end/steps, writeInterval=end)
    return case


def test_period_of_jeffery(tmp_path):
    """2 pi (r + 1/r)/G = 18.22124/G for the aspect ratio 2.5 (Jeffery 1922).
    The error is one of second order in time."""
    errors = []
    for steps in (400, 800):
        case = shear_case(
            tmp_path, f"shear{steps}", spheroid(2.5, 0.02), 0, steps
        )
        case.solve()
        motion = case.table("motion")
        # Half turns: where the spin is fastest
        spin, t = -motion["angularVelocity_z"], motion["time"]
        peaks = [
            t[i] + 0.5*(t[i+1] - t[i])*(spin[i-1] - spin[i+1])
            / (spin[i-1] - 2*spin[i] + spin[i+1])
            for i in range(1, len(t) - 1)
            if spin[i-1] < spin[i] >= spin[i+1] and spin[i] > 0.7
        ]
        assert len(peaks) >= 4
        period = 2*(peaks[-1] - peaks[0])/(len(peaks) - 1)
        errors.append(abs(period/18.22124 - 1))
        assert spin.max() == pytest.approx(2.5**2/(2.5**2 + 1), rel=1e-3)
        assert spin.min() == pytest.approx(1/(2.5**2 + 1), rel=1e-2)
    assert errors[1] < 1e-4
    assert errors[1] < 0.3*errors[0]


def shaped_box(folder, name="box", model="Zastawny", **options):
    """The grains of grain_box as spheroids of aspect 2.5."""
    case = grain_box(
        folder, name, coupling=f"shapeModel {{ type {model}; }}", **options
    )
    path = case.path/"constant/immersedBodyProperties"
    path.write_text(re.sub(
        r"type sphere; radius ([\d.]+);",
        lambda m: spheroid(2.5, float(m.group(1))), path.read_text(),
    ))
    return case


@pytest.mark.parametrize("model", ["ellipsoid", "Zastawny"])
@pytest.mark.parametrize("nu", [0.5, 1e-3])
def test_momentum_is_conserved(model, nu, tmp_path):
    case = shaped_box(tmp_path, model=model, nu=nu)
    case.controls(endTime=0.2)
    case.solve()
    total = momentum(case)
    assert total == pytest.approx(
        np.broadcast_to(total[0], total.shape), abs=1e-11
    )
    spheres = grain_box(tmp_path, "spheres", nu=nu)
    spheres.controls(endTime=0.2)
    spheres.solve()
    assert np.abs(velocities(case, 3) - velocities(spheres, 3)).max() > 1e-4


def test_same_on_two_ranks(tmp_path):
    one = shaped_box(tmp_path)
    two = BodyCase(one, tmp_path, "two")
    one.solve()
    two.solve(2, (1, 1, 2))
    for i in range(len(GRAINS)):
        a, b = one.table("motion", i), two.table("motion", i)
        for column in a:
            assert b[column] == pytest.approx(a[column], abs=1e-9)


def test_restart_is_exact(tmp_path):
    case = shaped_box(tmp_path)
    case.controls(
        writeControl="timeStep", writeInterval=5, writePrecision=17,
        timePrecision=15,
    )
    restarts.check_exact(case, tmp_path, 0.1, 0.2)


def test_a_long_grain_turns_its_broad_side_to_the_stream(tmp_path):
    """With the torque of Zastawny et al. (2012): at Re of about 70."""
    D = 0.6e-3
    case, _ = falling_grain(
        tmp_path, "long", D, 0.3, 1000, coupling="type unresolved;"
        " shapeModel { type Zastawny; }", shape=spheroid(2.5, 0.5*D),
        grain="orientation { type axisAngle; axis (0 0 1); angle 70; }",
        end=0.6,
    )
    case.solve()
    motion = case.table("motion")
    turned = np.cumsum(
        motion["angularVelocity_z"][1:]*np.diff(motion["time"])
    )
    # Its axis is at 20 degrees to the path, and goes to 90, about which it
    # swings
    final = 160 + np.degrees(turned[-len(turned)//4:])
    assert np.abs(np.abs(final - 180).mean() - 90) < 25
    speed = motion["velocity_x"][-1]
    assert 20 < speed*D*RHO/MU < 300 and speed < terminal_velocity(D, 1000)


@pytest.mark.parametrize("turn, height", [("0", 0.04), ("90", 0.1)])
def test_contact_is_that_of_its_own_shape(turn, height, tmp_path):
    """A grain of the half lengths 0.1, 0.04, 0.04 bounces off the wall where
    its surface is."""
    case = BodyCase("box", tmp_path)
    case.mesh(*3*[uniform(-0.75, 0.75, 6)])
    case.bodies(
        "grain { shape { type ellipsoid; semiAxes (0.1 0.04 0.04); }"
        " densityRatio 1e4; position (0 0 -0.5); velocity (0 0 -1);"
        f" orientation {{ type axisAngle; axis (0 1 0); angle {turn}; }} }}",
        "coupling { type unresolved; shapeModel { type ellipsoid; } }"
        " contact { type softSphere; restitution 1; friction 0;"
        " collisionTime 0.004; }",
    )
    case.gravity()
    case.controls(endTime=0.3, deltaT=0.002)
    case.solve()
    motion = case.table("motion")
    # As deep as v T/pi
    assert motion["position_z"].min() == pytest.approx(
        -0.75 + height - 0.004/np.pi, abs=2e-3
    )
    assert motion["velocity_z"][-1] == pytest.approx(1, rel=0.01)


WRONG = {
    "type ellipsoids;": "nearest valid one is 'ellipsoid'",
    "type ellipsoid; psi 0.8;": "'psi'",
    "typ ellipsoid;": "nearest valid one is 'type'",
    "type Zastawny;": "1.1 to 3.5",
}


@pytest.fixture(scope="module")
def refused(tmp_path_factory):
    folder = tmp_path_factory.mktemp("refused")
    case = grain_box(folder, "right", coupling="shapeModel { type ellipsoid; }")
    return refusals.of_copies(case, folder, {
        entry: lambda case, entry=entry: case.replace(
            "constant/immersedBodyProperties", "type ellipsoid;", entry
        )
        for entry in WRONG
    })


@pytest.mark.fast
@pytest.mark.parametrize("entry", WRONG)
def test_wrong_shape_models_are_refused(entry, refused):
    refused[entry].names(WRONG[entry])
