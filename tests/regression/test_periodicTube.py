# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that go round in a tube with cyclic ends."""

import numpy as np
import pytest

from bodyCase import BodyCase
from foamCase import FoamError
from periodicTube import periodic_tube

CELLS = 12
LENGTH = 2
TIGHT = "coupling { tolerance 1e-10; nOuterCorrectors 30; }"
WINDOW = "window { type comoving; direction (1 0 0); }"
QUANTITIES = {
    "motion": ("velocity_x", "velocity_y", "angularVelocity_z"),
    "forces": ("fluidForce_x", "fluidForce_y", "fluidTorque_z"),
}


def disc(x, y=0.15, name="disc", speed=1, more="densityRatio 2;"):
    return f"""
        {name}
        {{
            shape       {{ type disc; radius 0.2; }}
            position    ({x + 0.3/CELLS:.15g} {y:.15g} 0);
            velocity    ({speed:.15g} 0 0);
            {more}
        }}
    """


@pytest.fixture(scope="module")
def tube(tmp_path_factory):
    folder = tmp_path_factory.mktemp("tube")
    return periodic_tube(folder, "tube", CELLS, force=24)


@pytest.fixture(scope="module")
def run(tube, tmp_path_factory):
    """Run bodies, once."""
    cache = {}

    def get(bodies, parts=(1, 1, 1), before=TIGHT, **controls):
        key = bodies, parts, before, *controls.items()
        if key not in cache:
            case = BodyCase(tube, tmp_path_factory.mktemp("run"))
            case.bodies(bodies, before)
            case.controls(**{"endTime": "1.6", "deltaT": "0.04", **controls})
            case.solve(int(np.prod(parts)), parts)
            cache[key] = case
        return cache[key]

    return get


def assert_same(a, b, tolerance=1e-8, pairs=((0, 0),)):
    """Bodies of two cases have had the same histories."""
    for table, names in QUANTITIES.items():
        for i, j in pairs:
            one, other = a.table(table, i), b.table(table, j)
            for name in names:
                scale = np.abs(one[name]).max()
                error = np.abs(one[name] - other[name]).max()
                assert error < tolerance*scale, (name, error/scale)


@pytest.mark.parametrize("parts", [(1, 1, 1), (2, 1, 1), (2, 2, 1)])
def test_several_times_round(parts, run):
    """Half a tube further along, on any number of ranks: the same."""
    end = {"endTime": "1.6" if parts == (1, 1, 1) else "0.8"}
    first, second = run(disc(0.6), **end), run(disc(1.6), parts, **end)
    motion, further = first.table("motion"), second.table("motion")

    turns = 2.5 if parts == (1, 1, 1) else 1
    assert motion["unwrapped_x"][-1] > turns*LENGTH
    for m in (motion, further):
        assert (0 <= m["position_x"]).all()
        assert (m["position_x"] < LENGTH).all()
        turns = (m["unwrapped_x"] - m["position_x"])/LENGTH
        assert turns == pytest.approx(np.round(turns), abs=1e-9)
    assert further["unwrapped_x"] - motion["unwrapped_x"] == pytest.approx(
        1, abs=1e-8
    )
    assert_same(first, second)


def test_in_a_window(run):
    """The window slides, and the disc is on its ends: as in the middle."""
    inside = run(disc(1), before=TIGHT + WINDOW)
    on_ends = run(disc(0), before=TIGHT + WINDOW)
    assert_same(inside, on_ends)
    # Also the ones that cross the mesh, but for the error of the time steps
    small = {"endTime": "0.4", "deltaT": "0.005"}
    crossing = run(disc(1.6), **small).table("motion")
    window = run(disc(1.6), before=TIGHT + WINDOW, **small).table("motion")
    assert crossing["position_x"][-1] < 1
    for name in ("velocity_x", "angularVelocity_z", "unwrapped_x"):
        assert crossing[name][-1] == pytest.approx(window[name][-1], rel=0.02)


@pytest.mark.parametrize("x", [0, 0.6, 1, 1.6])
def test_ambient_velocity(x, tube, tmp_path):
    """Of the flow at the centre, on a face between the ends or not: so heavy
    that it is as at the start after a step."""
    case = BodyCase(tube, tmp_path)
    case.replace(
        "system/setExprFieldsDict", "1.5*(1 - sqr(pos().y()))",
        f"1 + pos().y() + 0.1*sin({np.pi:.15g}*pos().x())",
    )
    case.run("setExprFields")
    heavy = "densityRatio 1e10; angularVelocity ambient;"
    case.bodies(
        disc(x - 0.3/CELLS, 0.15, more=heavy).replace("(1 0 0)", "ambient")
    )
    case.controls(endTime="1e-4", deltaT="1e-4")
    case.solve()
    motion = case.table("motion")
    # Interpolation of the sine: up to 3e-4
    assert motion["velocity_x"][0] == pytest.approx(
        1.15 + 0.1*np.sin(np.pi*x), abs=6e-4
    )
    assert motion["angularVelocity_z"][0] == pytest.approx(-0.5, abs=1e-6)


def test_two_that_see_each_other(run):
    """A pair across the ends: as in the middle, and unlike a single one."""
    heavy = "densityRatio 20;"
    pair = disc(0.6, 0.1, "a", 1, heavy) + disc(1.1, -0.1, "b", 1, heavy)
    across = disc(1.6, 0.1, "a", 1, heavy) + disc(0.1, -0.1, "b", 1, heavy)
    # Several bodies take more iterations
    end = {"endTime": "0.4", "before": TIGHT.replace("30", "100")}
    assert_same(
        run(pair, **end), run(across, **end), 1e-7, ((0, 0), (1, 1))
    )
    alone = run(disc(0.6, 0.1, "a", 1, heavy), **end).table("motion")
    both = run(pair, **end).table("motion")
    assert abs(both["velocity_x"][-1]/alone["velocity_x"][-1] - 1) > 0.01


@pytest.mark.parametrize("shape", ["disc; radius 0.2", "box; size (0.4 0.4 1)"])
def test_overlap_across_the_ends_is_refused(shape, run):
    bodies = disc(0.05, 0, "a") + disc(1.8, 0.1, "b")
    with pytest.raises(FoamError, match="'bodies' must not overlap.*a and b"):
        run(bodies.replace("disc; radius 0.2", shape))


def test_a_body_as_long_as_the_tube_is_refused(run):
    body = disc(0.5, 0).replace("disc; radius 0.2", "box; size (2.1 0.3 1)")
    with pytest.raises(FoamError, match="must not overlap.*disc and disc"):
        run(body)


def test_overlap_across_the_ends_stops_a_run(run):
    bodies = disc(1.5, 0, "a", 6, "densityRatio 100;")
    bodies += disc(0.1, 0, "b").split("velocity")[0]
    bodies += "motion { type fixed; } }"
    with pytest.raises(FoamError, match="bodies overlap: .*a and b") as stop:
        run(bodies, endTime="0.4", deltaT="0.01", before="")
    assert "Stopped at time 0.0" in str(stop.value)


def test_outside_across_walls_is_refused(run):
    with pytest.raises(FoamError, match="outside the mesh"):
        run(disc(0.5, 2))


@pytest.mark.parametrize("parts", [(1, 1, 1), (2, 1, 1)])
@pytest.mark.parametrize("drive", ["force", "flow rate"])
def test_restart_while_crossing(drive, parts, tube, tmp_path):
    at_once = BodyCase(tube, tmp_path, "atOnce")
    if drive == "flow rate":
        at_once = periodic_tube(tmp_path, "flowRate", CELLS, speed=2)
    at_once.bodies(disc(1.75, speed=2))
    # The direct solver's last bit depends on more than its argument
    at_once.replace(
        "system/fvSolution", "fastPoisson;", "PCG; preconditioner DIC;"
    )
    at_once.controls(
        endTime="0.16", deltaT="0.01", writeControl="timeStep",
        writeInterval="4", writePrecision="17", timePrecision="15",
    )
    ranks = int(np.prod(parts))
    if ranks > 1:
        at_once.decompose(ranks, parts)
    in_parts = BodyCase(at_once, tmp_path, "inParts")
    at_once.solve(ranks)
    folder = "processor0" if ranks > 1 else "."
    half = at_once.times(folder)[-3]
    in_parts.controls(endTime=half)
    in_parts.solve(ranks)
    in_parts.controls(endTime="0.16")
    in_parts.solve(ranks)

    # The state in between has the disc on the end
    motion = at_once.table("motion")
    x = motion["position_x"][motion["time"] < float(half) + 1e-9][-1]
    assert min(x, LENGTH - x) < 0.2
    assert motion["unwrapped_x"][-1] > LENGTH

    time = at_once.latest_time(folder)
    names = ["U", "phi", "p", "uniform/immersedBodies"]
    if drive == "flow rate":
        names += ["uniform/driveProperties"]
    for name in names:
        file = f"{folder}/{time}/{name}"
        expected = (at_once.path / file).read_bytes()
        assert (in_parts.path / file).read_bytes() == expected, name


def test_images_may_appear_within_a_time_step(tmp_path):
    """Discs that move by half a cell in the first step, so that some of them
    come into reach of the ends in its later iterations only."""
    n, radius, dt = 64, 0.045, 0.01
    case = periodic_tube(tmp_path, "images", n, force=0)
    positions = " ".join(
        f"({LENGTH - radius - (0.45*i + 4)/n:.12g} {(i - 3.5)/9:.12g} 0)"
        for i in range(8)
    )
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius {radius}; }}
            densityRatio 100;
            positions   ({positions});
            velocity    (0 0 0);
        }}
    """)
    case.gravity(0.5/n/dt**2)
    case.controls(endTime=f"{2*dt}", deltaT=f"{dt}")
    log = case.solve()
    assert "repeated" not in log
