# SPDX-License-Identifier: GPL-3.0-or-later
"""So many grains that each rank holds only those near to it: the same on any
number of ranks, while they hit each other and go from rank to rank."""

import numpy as np
import pytest

from bodyCase import BodyCase
from denseBox import column, grains, write_positions
from foamCase import FoamError
from openTube import passage
from slidingBox import centres, set_velocity, sliding_box
from spreadRuns import motions, run_in_parts, write_twice

DIAMETER, CELL, WIDTH, HEIGHT = 1e-3, 2e-3, 6, 34
ACROSS, LAYERS = 10, 22
STEP = 1e-4
DENSE = "type unresolved; voidFraction yes; dragModel { type Gidaspow; }"
CONTACT = "collisionTime 4e-5; friction 0.4; largestOverlap 0.9;"
TRAFFIC = f"""
leaving
{{
    inlet  {{ type reinject; shift (0 0 {(HEIGHT - 1)*CELL}); }}
    outlet {{ type remove; }}
}}
injection
{{
    injected
    {{
        shape    {{ type sphere; radius {DIAMETER/2}; }}
        size
        {{
            type uniform;
            uniformDistribution {{ minValue 0.7; maxValue 1; }}
        }}
        densityRatio
        {{
            type uniform;
            uniformDistribution {{ minValue 800; maxValue 1200; }}
        }}
        velocity (0 0 1);
        region
        {{
            type box;
            min  (0.001 0.001 0.01);
            max  (0.011 0.011 0.05);
        }}
        rate     3e4;
        tries    200;
        seed     3;
    }}
}}
"""
PARTS = {2: (1, 1, 2), 4: (1, 1, 4)}


def rain(
    folder, name="rain", speed=8, gravity=9.81, steps=8, height=HEIGHT,
    contact="", traffic="",
):
    """2200 grains in a periodic column of air: half of them fall among the
    others, which rise."""
    case = column(folder, name, WIDTH, height, CELL, 0.4, 1.5e-5)
    across = (np.arange(ACROSS) + 0.5)*WIDTH*CELL/ACROSS
    along = (np.arange(LAYERS) + 3)*2.6e-3
    places = np.array(
        [(x, y, z) for z in along for y in across for x in across]
    )
    random = np.random.default_rng(4)
    places += random.uniform(-9e-5, 9e-5, places.shape)
    falls = random.random(len(places)) < 0.5
    write_positions(case, places[~falls])
    write_positions(case, places[falls], "falling")
    case.bodies(
        "\n".join(
            grains(DIAMETER/2, ratio, "free", name).replace(
                "motion", f"velocity ({u}); motion"
            ) for name, ratio, u in (
                ("grain", 2000, f"-1 0.3 {speed/3}"),
                ("falling", 1000, f"0.3 0.1 -{speed}"),
            )
        ),
        f"contact {{ type softSphere; {contact or CONTACT} }}"
        f" coupling {{ {DENSE} }} {traffic}",
    )
    case.gravity(0, 0, -gravity)
    write_twice(case, STEP, steps)
    return case


def sheared(folder):
    """2400 grains in a box whose upper side slides along the lower one, half of
    them go up among the others."""
    cells, sides, shear = (24, 8, 6), (12, 4, 3), 2
    case = sliding_box(folder, "sheared", cells, sides, f"shearRate {shear};")
    x = centres(cells, sides)
    velocity = 0*x
    velocity[:, 0] = shear*(x[:, 1] - 2)
    set_velocity(case, velocity)
    case.replace("system/fvSolution", "relTol          1e-3", "relTol 1e-9")
    places = np.indices((40, 10, 6)).reshape(3, -1).T*[0.3, 0.4, 0.5]
    places += [0.1, 0.3, 0.1]
    random = np.random.default_rng(5)
    places += random.uniform(-0.05, 0.05, places.shape)
    up = random.random(len(places)) < 0.5
    write_positions(case, places[~up])
    write_positions(case, places[up], "going")
    case.bodies(
        "\n".join(
            grains(0.08, 50, "free", name).replace(
                "motion", f"velocity ({u}); motion"
            ) for name, u in (("grain", "0.3 -1 0.2"), ("going", "-0.5 3 0"))
        ),
        "contact { type softSphere; collisionTime 0.02; friction 0.4;"
        " largestOverlap 0.9; } coupling { type unresolved; }",
    )
    write_twice(case, 0.01, 16)
    return case


def on_ranks(case, folder, ranks, parts=None):
    """A copy that has run on so many ranks, where the grains were spread."""
    several = BodyCase(case, folder, f"ranks{ranks}")
    log = several.solve(ranks, parts or PARTS[ranks])
    assert "Bodies are spread over the ranks: 2200" in log
    return several


def difference(one, other):
    a, b = motions(one), motions(other)
    return np.max(np.abs(a - b)/np.abs(a).max(axis=1, keepdims=True))


def test_same_on_several_ranks(tmp_path):
    one = rain(tmp_path)
    several = [on_ranks(one, tmp_path, ranks) for ranks in PARTS]
    one.solve()

    # Many have been hit, and have gone to another rank
    table = one.columns("motion")
    spins = table["angularVelocity_x"].reshape(2, -1)
    z = table["position_z"].reshape(2, -1)
    assert (np.abs(spins[-1]) > 10).mean() > 0.5
    parts = np.floor(4*z/(HEIGHT*CELL))
    assert (parts[0] != parts[1]).sum() > 50

    for case in several:
        assert difference(one, case) < 1e-8


def test_grains_that_go_further_than_expected(tmp_path):
    """From rest, under a large force: what a rank holds is too little for the
    first time step, as found in it."""
    one = rain(tmp_path, speed=0, gravity=1e5, steps=2)
    several = on_ranks(one, tmp_path, 4)
    one.solve()

    falls = one.columns("motion")["velocity_z"].reshape(2, -1)
    assert falls[-1].min() < -10
    assert difference(one, several) < 1e-8


def test_leaving_and_injection(tmp_path):
    """They fall out of the column, and enter again above; others rise out of
    it."""
    one = rain(tmp_path, speed=12, steps=16, traffic=TRAFFIC)
    several = on_ranks(one, tmp_path, 4)
    one.solve()

    happened, as_good = (
        [(e.time, e.number, e.what, e.name, e.where) for e in passage(case)]
        for case in (one, several)
    )
    assert happened == as_good
    for what, where in (
        ("leaves", "inlet"), ("leaves", "outlet"), ("enters", "again"),
        ("enters", "injected"),
    ):
        assert sum(e[2] == what and e[4] == where for e in happened) > 40
    # Twice as many steps as in the others
    assert difference(one, several) < 1e-7


def test_sliding_sides(tmp_path):
    """Many pass them."""
    one = sheared(tmp_path)
    several = BodyCase(one, tmp_path, "ranks4")
    log = several.solve(4, (4, 1, 1))
    assert "Bodies are spread over the ranks: 2400" in log
    one.solve()

    table = one.columns("motion")
    passed = np.abs(table["unwrapped_y"] - table["position_y"]) > 2
    spins = table["angularVelocity_z"].reshape(2, -1)
    assert passed.reshape(2, -1)[-1].sum() > 30
    assert (np.abs(spins[-1]) > 3).mean() > 0.2
    assert difference(one, several) < 1e-8


def test_restart_is_exact(tmp_path):
    """Also of grains of all sizes that have been injected."""
    at_once = rain(tmp_path, speed=12, traffic=TRAFFIC)
    parts = run_in_parts(at_once, tmp_path, STEP, 8, PARTS[4])

    for name in ("U", "p", "uniform/immersedBodies"):
        a, b = (
            (
                case.path/"processor0"/case.latest_time("processor0")/name
            ).read_bytes() for case in (at_once, parts)
        )
        assert a == b, name


def test_goes_on_from_collated_files(tmp_path):
    """One file for all ranks, of which each reads a part."""
    handler = ("-fileHandler", "collated")
    at_once = rain(tmp_path)
    parts = BodyCase(at_once, tmp_path, "parts")
    at_once.solve(1)

    parts.replace("system/decomposeParDict", "Subdomains 2", "Subdomains 4")
    parts.replace("system/decomposeParDict", "(2 1 1)", "(1 1 4)")
    parts.run("decomposePar", *handler)
    for end in (4*STEP, 8*STEP):
        parts.controls(endTime=end)
        log = parts.run("foamRun", *handler, ranks=4)
        assert "Bodies are spread over the ranks: 2200" in log
    assert motions(parts) == pytest.approx(
        motions(at_once), rel=1e-7, abs=1e-7
    )


@pytest.mark.parametrize("speed, contact, message", [
    (12, "", "a body has left the mesh"),
    (8, "largestOverlap 0.01;", "bodies overlap: "),
])
def test_a_run_stops(speed, contact, message, tmp_path):
    """On all ranks, with a message and the state of all grains."""
    case = rain(tmp_path, speed=speed, steps=16, contact=contact)
    case.decompose(4, PARTS[4])
    with pytest.raises(FoamError):
        case.solve(4)

    log = (case.path/"log.foamRun").read_text()
    assert "Bodies are spread over the ranks: 2200" in log
    assert message in log
    assert "The state has been written" in log

    time = case.latest_time("processor0")
    assert float(time) > 0
    state = (
        case.path/"processor0"/time/"uniform/immersedBodies"
    ).read_text()
    assert state.count("number ") == 2200


def test_a_grain_outside_is_refused(tmp_path):
    """However far away: nobody looks for its images there."""
    case = rain(tmp_path)
    path = case.path/"constant/grains"
    first, rest = path.read_text().split(")", 1)
    path.write_text(f"{first.rsplit(' ', 1)[0]} 900){rest}")
    with pytest.raises(FoamError, match="'grain1' is outside the mesh"):
        case.solve(4, PARTS[4])
