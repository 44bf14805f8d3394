# SPDX-License-Identifier: GPL-3.0-or-later
"""Boxes that slide (Lees & Edwards): the pair of patches."""

import math
import re

import numpy as np
import pytest

from foamCase import FoamError
from slidingBox import NAMES, TIGHT, N, centres, disc, eddies, prepare


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
    cuts = [(2, 1, 1), (1, 2, 1), (2, 2, 1)]
    for parts in [(1, 1, 1), *(cuts if direct else cuts[-1:])]:
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


def test_restart(tmp_path):
    """Byte for byte, in the middle of a passage."""
    whole = prepare(tmp_path, "whole", shift=0.37, end=0.08, dt=0.01)
    whole.bodies(disc(0.31, 0.93, 0.43), TIGHT)
    whole.controls(
        writeFormat="binary", writeInterval=4, writePrecision=17,
    )
    parts = whole.copy(tmp_path, "parts")
    whole.solve()
    parts.controls(endTime=0.04)
    parts.solve()
    parts.controls(endTime=0.08)
    parts.solve()
    assert parts.results() == whole.results()


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


def test_wrong_neighbour(tmp_path):
    """A neighbour that does not exist."""
    case = empty(prepare(tmp_path, "wrong", shear="speed 1;"))
    case.replace("constant/polyMesh/boundary", "neighbourPatch  top;",
                 "neighbourPatch  tpo;")
    with pytest.raises(FoamError) as error:
        case.solve()
    assert "'neighbourPatch tpo' of the patch" in str(error.value)


def test_needs_rows(tmp_path):
    """Cells along the direction have to be equal."""
    case = empty(prepare(tmp_path, "graded", shear="speed 1;"))
    case.replace("system/blockMeshDict", f"((1 {N} 1))\n        ((1 {N} 1))",
                 f"((1 {N} 2))\n        ((1 {N} 1))")
    with pytest.raises(FoamError) as error:
        case.run("blockMesh")
        case.solve()
    assert "need equal cells" in str(error.value)
