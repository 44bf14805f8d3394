# SPDX-License-Identifier: GPL-3.0-or-later
"""Boxes that slide (Lees & Edwards): fluid and bodies across the pair."""

import math
import re

import numpy as np
import pytest

from foamCase import FoamError
from slidingBox import (
    centres, set_stress, set_velocity, sliding_box, stress,
)

N = 24
TIGHT = "coupling { tolerance 1e-11; nOuterCorrectors 60; }"
NAMES = "velocity_x", "velocity_y", "angularVelocity_z"


def eddies(cells, shear, size=0.3):
    """Shear about the middle, and four eddies, of a square of side 1."""
    x, y, _ = 2*np.pi*centres(cells, (1, 1)).T
    u = np.zeros((len(x), 3))
    u[:, 0] = size*np.sin(x)*np.cos(y) + shear*(y/(2*np.pi) - 0.5)
    u[:, 1] = -size*np.cos(x)*np.sin(y)
    return u


def tight(case):
    """Solve to rounding."""
    path = case.path / "system/fvSolution"
    text = re.sub(r"tolerance +1e-\d+;", "tolerance 1e-14;", path.read_text())
    path.write_text(re.sub(r"relTol +[\d.e-]+;", "relTol 0;", text))


def prepare(folder, name, nu=0.05, end=0.1, dt=0.01, velocity=None, **box):
    cells = box.pop("cells", (N, N))
    case = sliding_box(folder, name, cells, **box)
    set_velocity(case, eddies(cells, 1) if velocity is None else velocity)
    tight(case)
    case.replace("constant/transportProperties", "0.5;", f"{nu:.12g};")
    case.controls(
        endTime=end, deltaT=dt, writeFormat="ascii", writePrecision=16,
        writeControl="timeStep", writeInterval=round(end/dt),
    )
    return case


def empty(case):
    """No bodies."""
    case.replace(
        "system/fvSchemes", "div(phi,U)  ",
        "div((nuEff*dev2(T(grad(U))))) Gauss linear;\n    div(phi,U)  ",
    )
    case.bodies("")
    path = case.path / "system/controlDict"
    path.write_text(path.read_text().split("functions")[0])
    return case


def disc(x, y, speed=0, ratio=2, more=""):
    return f"""
        disc
        {{
            shape       {{ type disc; radius 0.2; }}
            densityRatio {ratio};
            position    ({x:.15g} {y:.15g} 0);
            velocity    ({speed:.15g} 0 0);
            {more}
        }}
    """


def kelvin(n, t, nu, shear=1, size=0.1):
    """Velocity of a plane wave that a uniform shear turns, an exact solution
    of Navier-Stokes (Kelvin 1887), in a square of n x n cells."""
    x, y, _ = centres((n, n), (1, 1)).T
    k = 2*np.pi
    kx, ky = k, k*(1 - shear*t)
    viscous = nu*k**2*(2*t - shear*t**2 + shear**2*t**3/3)
    amplitude = size*2*k*math.exp(-viscous)/((kx**2 + ky**2)/k**2)/k
    wave = amplitude*np.sin(kx*x + ky*(y - 0.5))
    u = np.zeros((len(x), 3))
    u[:, 0] = shear*(y - 0.5) - ky/k*wave
    u[:, 1] = kx/k*wave
    return u


def test_linear_shear(tmp_path):
    """Uniform shear stays, to rounding, whatever the shift."""
    case = empty(prepare(
        tmp_path, "shear", shift=0.123, velocity=eddies((N, N), 1, size=0),
    )).copy(tmp_path, "copy")
    case.solve()
    error = case.field("U") - eddies((N, N), 1, size=0)
    assert np.abs(error).max() < 1e-13


def test_kelvin_wave(tmp_path):
    """Second order of a flow that the pair cuts."""
    errors = []
    for n in (16, 32):
        case = empty(prepare(
            tmp_path, f"wave{n}", cells=(n, n), velocity=kelvin(n, 0, 0.005),
            nu=0.005, end=0.4, dt=0.16/n,
        ))
        case.replace("system/fvSolution", "PIMPLE\n{",
                     "PIMPLE\n{\n    nCorrectors 2;")
        case.solve()
        error = case.field("U") - kelvin(n, 0.4, 0.005)
        errors.append(np.abs(error).max())
    assert errors[1] < 1e-3
    assert errors[0]/errors[1] > 3


@pytest.mark.parametrize("direct", [True, False])
def test_whole_cells(direct, tmp_path):
    """Without sliding, the same as between cyclic patches, to rounding; a
    shift by whole cells is one of what is beyond."""
    velocity = eddies((N, N), 0)
    plain, none, shifted = (
        empty(prepare(
            tmp_path, name, velocity=velocity, direct=direct, end=0.05, **box
        ))
        for name, box in (
            ("plain", {"sliding": False}),
            ("none", {"shear": "speed 0;"}),
            # The eddies are the same six cells on, and turn the other way
            ("shifted", {"shear": "speed 0;", "shift": 1}),
        )
    )
    for case in (plain, none, shifted):
        case.solve()
        assert np.abs(case.field("U") - plain.field("U")).max() < 2e-14


def test_body_whole_cells(tmp_path):
    """A body away from the pair notices nothing of it."""
    cases = [
        prepare(
            tmp_path, name, velocity=eddies((N, N), 0), end=0.05, **box
        )
        for name, box in (
            ("plain", {"sliding": False}), ("none", {"shear": "speed 0;"}),
        )
    ]
    for case in cases:
        case.bodies(disc(0.31, 0.52), TIGHT)
        case.solve()
    for name in NAMES:
        one, other = (case.table("motion")[name] for case in cases)
        assert np.abs(one - other).max() < 1e-12


def flux(case, time, patch):
    """Fluxes through the faces of a patch, per depth [m2/s]."""
    text = (case.path / time / "phi").read_text()
    values = re.search(
        rf"{patch}\s+{{[^(]*nonuniform List<scalar>\s*\d+\s*\(([^)]*)\)",
        text,
    ).group(1)
    return np.array(values.split(), dtype=float)/0.1


@pytest.mark.parametrize("ratio", [1, 3])
@pytest.mark.parametrize("place", [(0.31, 0.52), (0.31, 0.93)])
def test_momentum(place, ratio, tmp_path):
    """What leaves one side enters the other: volume to rounding, momentum as
    far as iterations go. What flows through the pair changes its speed."""
    case = prepare(tmp_path, "momentum", shift=0.37, end=0.05)
    case.replace("system/fvSchemes", "default backward", "default Euler")
    case.controls(writeInterval=1)
    case.bodies(disc(*place, place[1] - 0.5, ratio), TIGHT)
    case.solve()
    motion = case.table("motion")
    expected, start = np.zeros(2), None
    for step, time in enumerate(case.times()[1:]):
        top, bottom = flux(case, time, "top"), flux(case, time, "bottom")
        assert abs(top.sum() + bottom.sum()) < 1e-14
        solid = [motion[f"velocity_{k}"][step] for k in "xy"]
        total = case.field("U", time).mean(axis=0)[:2]
        total += (ratio - 1)*math.pi*0.2**2*np.array(solid)
        if start is None:
            start = total
        else:
            expected[0] -= 0.01*top.sum()
        assert np.abs(total - start - expected).max() < 3e-7


def test_galilean(tmp_path):
    """All moved up by a part of the box, in the frame of the new middle."""
    histories = []
    for move in (0, 0.375):
        x, y, _ = centres((N, N), (1, 1)).T
        below = y < move
        k = 2*np.pi
        u = np.zeros((N*N, 3))
        u[:, 0] = 0.3*np.sin(k*x)*np.cos(k*(y - move)) + y - 0.5
        u[:, 1] = -0.3*np.cos(k*x)*np.sin(k*(y - move))
        case = prepare(
            tmp_path, f"moved{move}", velocity=u, end=0.2, dt=0.005,
        )
        assert below.sum() == N*N*move
        case.bodies(disc(0.31, 0.52 + move, move), TIGHT)
        case.solve()
        motion = case.table("motion")
        histories.append(
            [motion[name] - (move if i == 0 else 0)
             for i, name in enumerate(NAMES)]
        )
    for one, other in zip(*histories, strict=True):
        assert np.abs(one - other).max() < 1.5e-3


@pytest.mark.parametrize("direct", [True, False])
def test_ranks(direct, tmp_path):
    """The same on 1, 2 and 4 ranks, however the mesh is cut."""
    tables = []
    for parts in ((1, 1, 1), (2, 1, 1), (1, 2, 1), (2, 2, 1)):
        case = prepare(
            tmp_path, "x".join(map(str, parts)), shift=0.23, direct=direct,
            end=0.02, cells=(16, 16),
        )
        case.bodies(disc(0.31, 0.93, 0.43),
                    "coupling { tolerance 1e-11; nOuterCorrectors 5; }")
        case.solve(math.prod(parts), parts)
        tables.append(case.table("motion"))
    for table in tables[1:]:
        for name in NAMES:
            assert np.abs(table[name] - tables[0][name]).max() < 1e-9


def test_passes(tmp_path):
    """A body that passes the pair goes on with the velocity of what is
    beyond."""
    case = prepare(
        tmp_path, "passes", velocity=eddies((N, N), 1, size=0), end=0.3,
        dt=0.01, shear="shearRate 1;", shift=0.4,
    )
    case.bodies(disc(0.31, 0.95, 0.45).replace("(0.45 0", "(0.45 0.5"), TIGHT)
    case.solve()
    motion = case.table("motion")
    y, u = motion["position_y"], motion["velocity_x"]
    step = int(np.argmax(np.diff(y) < -0.5)) + 1
    assert y[step - 1] - y[step] == pytest.approx(1, abs=0.02)
    assert u[step - 1] - u[step] == pytest.approx(1, abs=0.02)
    # Otherwise smooth
    change = np.abs(np.delete(np.diff(u), step - 1))
    assert change.max() < 0.03


def test_restart(tmp_path):
    """Byte for byte, in the middle of a passage."""
    whole = prepare(tmp_path, "whole", shift=0.37, end=0.08, dt=0.01)
    whole.bodies(disc(0.31, 0.93, 0.43), TIGHT)
    whole.controls(writeFormat="binary", writeInterval=4)
    parts = whole.copy(tmp_path, "parts")
    whole.solve()
    parts.controls(endTime=0.04)
    parts.solve()
    parts.controls(endTime=0.08)
    parts.solve()
    assert parts.results() == whole.results()


@pytest.mark.parametrize("height", [0.5, 0.9])
def test_square_array(height, tmp_path):
    """A free disc in Stokes flow: viscosity and spin of a square array, area
    fraction 0.24, shifted by a quarter; exact 1.5194296 and -0.4870028. Wherever
    the disc is."""
    n, R, nu = 29, math.sqrt(0.24/math.pi), 200
    case = prepare(
        tmp_path, "array", cells=(n, n), velocity=eddies((n, n), 1, size=0),
        shift=0.15, end=0.1, dt=0.005, nu=nu,
    )
    case.replace(
        "system/fvSchemes", "div(phi,U)          Gauss linear",
        "div(phi,U)          none",
    )
    set_stress(case)
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius {R:.12g}; }}
            densityRatio 1;
            position    (0.51 {height + 0.01:.12g} 0);
            velocity    ({height - 0.49:.12g} 0 0);
            angularVelocity (0 0 -0.5);
        }}
    """)
    case.solve()
    assert stress(case)["viscosity"][-1]/nu == pytest.approx(1.5194, rel=1e-3)
    spin = case.table("motion")["angularVelocity_z"][-1]
    assert spin == pytest.approx(-0.4870, rel=2e-3)


def test_spheres(tmp_path):
    """In three dimensions, off the middle of the box, as in the middle."""
    spins = []
    for height in (0.5, 0.9):
        n = 12
        case = sliding_box(tmp_path, f"at{height}", (n, n, n), (1, 1, 1))
        x = centres((n, n, n), (1, 1, 1))
        velocity = 0*x
        velocity[:, 0] = x[:, 1] - 0.5
        set_velocity(case, velocity)
        case.controls(endTime=0.1, deltaT=0.01)
        case.bodies(f"""
            sphere
            {{
                shape       {{ type sphere; radius 0.25; }}
                densityRatio 1;
                position    (0.52 {height + 0.02:.12g} 0.52);
                velocity    ({height - 0.48:.12g} 0 0);
                angularVelocity (0 0 -0.5);
            }}
        """)
        case.solve()
        spins.append(case.table("motion")["angularVelocity_z"][-1])
    assert spins[0] == pytest.approx(spins[1], rel=3e-3)
    assert spins[0] == pytest.approx(-0.5, rel=0.03)


@pytest.mark.parametrize(
    "entries, message",
    [
        ("direction (1 0 0);", "None of 'speed'"),
        ("direction (1 0 0); speed 1; shearRate 1;", "Both of 'speed'"),
        ("direction (0 1 0); speed 1;", "along them"),
        ("direction (1 0 0); speed 1; shft 0;", "Unknown keyword 'shft'"),
        ("", "None of the patches"),
    ],
)
def test_refusals(entries, message, tmp_path):
    """Entries of the pair that are wrong."""
    with pytest.raises(FoamError) as error:
        case = empty(prepare(tmp_path, "wrong", shear="speed 1;"))
        path = case.path / "constant/polyMesh/boundary"
        text = re.sub(
            r"direction .*?;\s*speed .*?;\s*shift .*?;", entries,
            path.read_text(), flags=re.DOTALL,
        )
        path.write_text(text)
        case.solve()
    assert message in str(error.value)


def test_needs_rows(tmp_path):
    """Cells along the direction have to be equal."""
    case = empty(prepare(tmp_path, "graded", shear="speed 1;"))
    case.replace("system/blockMeshDict", f"((1 {N} 1))\n        ((1 {N} 1))",
                 f"((1 {N} 2))\n        ((1 {N} 1))")
    with pytest.raises(FoamError) as error:
        case.run("blockMesh")
        case.solve()
    assert "need equal cells" in str(error.value)


def pair_case(folder, move, contact):
    """Two discs that shear and a push bring together, moved up by `move`."""
    case = prepare(
        folder, f"moved{move:g}", velocity=eddies((N, N), 1, size=0), nu=1, end=0.2,
        dt=0.005,
    )
    text = ""
    for name, x, y in (("a", 0.35, 0.56), ("b", 0.64, 0.44)):
        up = y + move
        above = up > 1
        text += f"""
            {name}
            {{
                shape       {{ type disc; radius 0.14; }}
                densityRatio 1;
                position    ({x} {up - above:.15g} 0);
                velocity    ({up - above - 0.5:.15g} 0 0);
                restraints
                {{
                    push
                    {{
                        type externalForce;
                        force ({3 if name == "a" else -3} 0 0);
                    }}
                }}
            }}
        """
    case.bodies(text, f"rho 1;\n{TIGHT}\n{contact}")
    case.solve()
    return case


@pytest.mark.parametrize(
    "contact",
    [
        "contact { type softSphere; }",
        "contact { type softSphere; } lubrication { type leadingOrder; }",
        "contact { type inelastic; }",
    ],
)
def test_contact_across(contact, tmp_path):
    """Two that collide across the pair of patches, as two in the middle."""
    apart = []
    for move in (0, 0.5):
        case = pair_case(tmp_path, move, contact)
        a, b = case.table("motion", 0), case.table("motion", 1)
        x = b["position_x"] - a["position_x"]
        y = b["position_y"] - a["position_y"]
        above = np.round(y)
        x, y = x - above*a["time"], y - above
        x -= np.round(x)
        apart.append(np.hypot(x, y))
    # Films keep them apart
    assert apart[0].min() < (0.295 if "lubrication" in contact else 0.285)
    assert np.abs(apart[1] - apart[0]).max() < 1e-3


def test_unresolved_across(tmp_path):
    """A grain that moves with a uniform shear goes on with it, wherever the
    pair cuts its kernel."""
    n = 10
    case = sliding_box(tmp_path, "grain", (n, n, n), (1, 1, 1), shift=0.37)
    velocity = np.zeros((n**3, 3))
    velocity[:, 0] = centres((n, n, n), (1, 1, 1))[:, 1] - 0.5
    set_velocity(case, velocity)
    case.controls(endTime=0.2, deltaT=0.01)
    case.bodies("""
        grain
        {
            shape       { type sphere; radius 0.002; }
            densityRatio 5;
            position    (0.9 0.97 0.5);
            velocity    (0.47 0 0);
            angularVelocity (0 0 -0.5);
            coupling    unresolved;
        }
    """)
    case.solve()
    motion = case.table("motion")
    assert np.abs(motion["velocity_x"] - 0.47).max() < 1e-9
    assert np.abs(motion["velocity_y"]).max() < 1e-9
    assert np.abs(motion["angularVelocity_z"] + 0.5).max() < 1e-8
