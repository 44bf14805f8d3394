# SPDX-License-Identifier: GPL-3.0-or-later
"""So many bodies that each rank holds only those near to it, which the mesh
resolves: the same on any number of ranks, while they hit each other and go from
rank to rank."""

import re
import shutil

import numpy as np
import pytest

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform
from contactCase import box2d, discs
from periodicBox import SIDES, set_fields
from periodicTube import direct_pressure
from slidingBox import centres, set_velocity, sliding_box
from spreadRuns import (
    SURFACES, TOGETHER, motions, run_in_parts, surfaces, write_twice,
)

LENGTH, WIDTH, CELLS = 50, 8, 8
ALONG, ACROSS = 40, 5
STEP, STEPS = 0.05, 6
DISC = "shape { type disc; radius 0.5; }"
WINDOW = "window { type comoving; directions ((1 0 0) (0 1 0)); }"
FILMS = "lubrication { type leadingOrder; }"
# Shapes, and how they move
KINDS = (
    f"{DISC} densityRatio 2; velocity (1 0.3 0);",
    "shape { type ellipse; semiAxes (0.5 0.4); } densityRatio 3;"
    " velocity (-0.7 0.5 0); angularVelocity (0 0 1);",
    f"{DISC} motion {{ type prescribed; velocity (-0.1 -0.2 0); }}",
    f"{DISC} densityRatio 2; velocity (2 0 0); restraints {{ spring {{"
    " type linearSpring; stiffness (60 60 0); rotationalDamping (0 0 1); } }",
)


def on_plane():
    """Discs along y = 0, that go up and down it in turn."""
    bodies = ""
    for kind, speed in enumerate((1, -0.7)):
        at = " ".join(
            f"({1.25*i + 0.6:.12g} 0 0)" for i in range(kind, ALONG, 2)
        )
        bodies += (
            f"cut{kind}_ {{ {DISC} densityRatio 2; velocity ({speed} 0 0);"
            f" positions ({at}); }}\n"
        )
    return bodies


SPRINGS = f"softSphere; collisionTime {STEP}; friction 0.3; largestOverlap 0.9;"
PROJECTIONS = {
    model: f"{model}; tolerance 1e-10;" for model in ("inelastic", "viscous")
}


def place(case, shares, window="", first=0.5, contact=SPRINGS, bodies=""):
    """200 discs and ellipses, of each kind `shares` in so many, in a box far
    longer than it is wide, in rows, of which the first is so many of their
    distances above its lower side; and other bodies."""
    random = np.random.default_rng(3)
    # Some between two ranks, beside x = 12.5 k
    places = np.indices((ALONG, ACROSS)).reshape(2, -1).T + [0.98, first]
    places *= np.array([LENGTH/ALONG, WIDTH/ACROSS])
    places += random.uniform(-0.1, 0.1, places.shape)
    places[:, 1] %= WIDTH
    kinds = random.permutation(np.resize(
        np.repeat(np.arange(len(shares)), shares), len(places)
    ))
    places = [places[kinds == i] for i in range(len(shares))]
    for kind, (motion, of_kind) in enumerate(zip(KINDS, places)):
        at = " ".join(f"({x:.12g} {y:.12g} 0)" for x, y in of_kind)
        if at:
            bodies += f"kind{kind} {{ {motion} positions ({at}); }}\n"
    case.start = np.concatenate(places)
    case.bodies(
        bodies,
        f"rho 1; coupling {{ nOuterCorrectors 12; }} {window}"
        f" contact {{ type {contact} }}",
    )
    write_twice(case, STEP, STEPS)
    return case


def crowd(
    folder, shares=(12, 0, 1), window="", walls=False, contact=SPRINGS
):
    """In a box that repeats itself, or between a plane of symmetry, on which
    others are, and a wall."""
    case = BodyCase("tube", folder, "crowd")
    names = list(SIDES)[:4]
    boxMesh.write(
        case, uniform(0, LENGTH, LENGTH*CELLS), uniform(0, WIDTH, WIDTH*CELLS),
        None, {side: SIDES[side] for side in names},
    )
    case.set_cyclic(*names[:2])
    if not walls:
        case.set_cyclic(*names[2:])
    for side, kind in zip(names[2:], ("symmetryPlane", "wall") if walls else ()):
        case.replace(
            "system/blockMeshDict", f"{side} {{ type patch;",
            f"{side} {{ type {kind};",
        )
    case.run("blockMesh")
    set_fields(case, 0)
    if walls:
        case.conditions(*(
            f'".*" {{ type cyclic; }} {names[3]} {{ type {kind}; }}'
            f" {names[2]} {{ type symmetryPlane; }}"
            " frontAndBack { type empty; }" for kind in ("noSlip", "zeroGradient")
        ))
    case.replace("0/U", "uniform (1 0 0)", "uniform (0 0 0)")
    case.replace("constant/transportProperties", "0.5;", "0.02;")
    direct_pressure(case)
    if walls:
        return place(
            case, shares, window, 0.66, f"{contact} wallRoughness 5; seed 3;",
            on_plane(),
        )
    return place(case, shares, window, contact=contact)


def sheared_crowd(folder):
    """In one whose upper side slides along the lower one."""
    cells, sides = (LENGTH*CELLS, WIDTH*CELLS), (LENGTH, WIDTH)
    case = sliding_box(folder, "crowd", cells, sides, "shearRate 0.1;")
    velocity = 0*centres(cells, sides)
    velocity[:, 0] = 0.1*(centres(cells, sides)[:, 1] - WIDTH/2)
    set_velocity(case, velocity)
    case.replace("constant/transportProperties", "0.5;", "0.02;")
    # This solver of U is another one on each number of ranks
    case.replace("system/fvSolution", "relTol          1e-3", "relTol 1e-9")
    return place(case, (1, 1), first=0)


def rank_of(x):
    """Of four."""
    return np.floor(4*x/LENGTH)


def check_ranks(one, folder, position="position", parts=(4, 1), number=200):
    """The same on one rank and on four; position: in the mesh; parts: in which
    it is divided; number: of bodies."""
    start = one.start[:, 0]
    results = []
    for ranks in (1, 4):
        case = BodyCase(one, folder, f"ranks{ranks}")
        log = case.solve(ranks, (*parts, 1))
        spread = f"Bodies are spread over the ranks: {number}" in log
        assert spread == (ranks > 1)
        results.append((case, re.findall(r"outer iterations (\d+)", log)))
    (one, iterations), (several, as_many) = results

    end = one.columns("motion")[f"{position}_x"].reshape(2, -1)[-1]
    assert (rank_of(end[-len(start):]) != rank_of(start)).any()

    motion = motions(one)
    largest = np.maximum(np.abs(motion).max(axis=1, keepdims=True), 1e-6)
    assert as_many == iterations
    assert np.max(np.abs(motions(several) - motion)/largest) < 1e-6
    return one, several


def state_of(case, part):
    """Of the bodies at the end."""
    folder = case.path/part/case.latest_time(part)
    return (folder/"uniform/immersedBodies").read_text()


@pytest.mark.parametrize("shares", [
    (12, 0, 1), pytest.param((1, 1), marks=pytest.mark.nightly), (1, 1, 0, 1),
])
def test_same_on_several_ranks(shares, tmp_path):
    """With some that are towed, and without: then later iterations are those of
    few. With some on springs: the master, which writes their anchors, has got
    most of them from other ranks."""
    runs = check_ranks(crowd(tmp_path, shares), tmp_path)
    state, as_good = map(state_of, runs, (".", "processor0"))
    assert "crowd " in state
    anchors = re.findall("startPosition .*", state)
    assert len(anchors) == (66 if len(shares) == 4 else 0)
    assert re.findall("startPosition .*", as_good) == anchors


@pytest.mark.parametrize("model", [
    pytest.param("inelastic", marks=pytest.mark.nightly), "viscous",
])
def test_projection(model, tmp_path):
    """Contact of all at once, of bodies of several ranks as well."""
    one, several = check_ranks(
        crowd(tmp_path, (1, 1), contact=PROJECTIONS[model]), tmp_path
    )
    force, as_much = (
        np.abs(case.columns("forces")["contactForce_x"])
        for case in (one, several)
    )
    assert (force[-200:] > 0).sum() > 20
    assert as_much == pytest.approx(force, abs=1e-6*force.max())


def heap(folder, contact):
    """Discs in three layers, which fall onto each other and the floor of a long
    box with a light fluid."""
    half, radius = 16, 0.245
    case = box2d(folder, 20)
    boxMesh.write(
        case, uniform(-half, half, 20*half), uniform(-1, 1, 20), None,
        {"walls": "x- x+ y- y+"},
    )
    case.run("blockMesh")
    case.gravity(y=-10)
    places = [
        (i/2 + 0.25*(1 + layer % 2) - half, -0.74 + 0.47*layer)
        for layer in range(3) for i in range(4*half - 1)
    ]
    case.bodies(
        discs(places, radius, ratio=1000), f"contact {{ type {contact} }}"
    )
    write_twice(case, 0.005, 40)
    return case


def test_films(tmp_path):
    """Of fluid in the gaps, one after the other from rank to rank, also where
    bodies touch walls."""
    one, several = check_ranks(
        crowd(tmp_path, (1, 1), FILMS, walls=True), tmp_path, number=240
    )
    losses, as_much = (
        float(re.search(
            "contactLosses .*", state_of(case, part)
        )[0].rstrip(");").split()[-1])
        for case, part in ((one, "."), (several, "processor0"))
    )
    assert losses > 0 and as_much == pytest.approx(losses, rel=1e-6)


@pytest.mark.parametrize("model", [
    "inelastic", pytest.param("viscous", marks=pytest.mark.nightly),
])
def test_projected_heap(model, tmp_path):
    """As many contacts at once, found by each rank for its own discs, move them
    as they do where all ranks have all, in the same flow."""
    spread = heap(tmp_path, PROJECTIONS[model])
    together = BodyCase(spread, tmp_path, "together")
    together.replace("system/controlDict", "functions\n{", TOGETHER)
    log, _ = (case.solve(4, (4, 1, 1)) for case in (spread, together))
    assert "Bodies are spread over the ranks: 189" in log
    assert "complementarity" not in log

    one, several = (motions(case)[:, -189:] for case in (together, spread))
    force = np.abs(spread.columns("forces")["contactForce_y"][-189:])
    assert (force > 0).mean() > 0.9
    largest = np.maximum(np.abs(one).max(axis=1, keepdims=True), 1e-6)
    assert np.max(np.abs(several - one)/largest) < 1e-6


def test_window(tmp_path):
    """It follows all of them."""
    runs = check_ranks(
        crowd(tmp_path, (1, 1), WINDOW), tmp_path, "windowPosition"
    )
    way, as_far = (
        case.columns("motion")["position_x"]
        - case.columns("motion")["windowPosition_x"] for case in runs
    )
    assert np.ptp(way[-200:]) < 1e-9 and abs(way[-1]) > 0.01
    assert as_far == pytest.approx(way, abs=1e-8)


@pytest.mark.nightly
def test_walls(tmp_path):
    """Rough ones; a rank finds those beside its bodies, among them walls of
    other ranks, and knows how often a body has met them. A plane of symmetry,
    on which bodies are that are in no cell."""
    one, several = check_ranks(
        crowd(tmp_path, (1, 1), walls=True), tmp_path, number=240
    )
    y, v = (
        one.columns("motion")[name].reshape(2, -1)
        for name in ("position_y", "velocity_y")
    )
    assert ((y[-1] > WIDTH - 1) & (v[-1] < -0.05)).sum() > 10
    impacts, as_many = (
        re.findall("wallImpacts +([0-9]+);", state_of(case, part))
        for case, part in ((one, "."), (several, "processor0"))
    )
    assert len(impacts) >= 10 and as_many == impacts


def test_files(tmp_path):
    """State, tables and surfaces have all bodies in the order of their numbers,
    and the master alone writes them; it is told of some at a time."""
    case = crowd(tmp_path, (1, 1))
    case.replace("system/controlDict", "functions\n{", SURFACES)
    case.controls(endTime=STEP, writeInterval=1)
    one, several = (BodyCase(case, tmp_path, name) for name in ("one", "four"))
    one.solve(1)
    assert "Bodies are spread over the ranks" in several.solve(4, (4, 1, 1))

    table, same = (case.columns("motion") for case in (one, several))
    times = np.unique(table["time"])
    numbers = len(times)*list(range(200))
    assert list(same["body"]) == list(table["body"]) == numbers
    assert same["position_x"] == pytest.approx(table["position_x"], rel=1e-6)

    arrays, as_many = surfaces(one), surfaces(several)
    assert len(arrays) == len(as_many) == 10*(1 + len(times))
    for array, same in zip(arrays, as_many):
        assert same == pytest.approx(array, rel=1e-4, abs=1e-4)

    states = [state_of(several, f"processor{rank}") for rank in range(4)]
    assert [state.count("number ") for state in states] == [200, 0, 0, 0]
    names = re.findall(r"\n    (kind\S+)\n", state_of(one, "."))
    assert len(names) == 200
    assert re.findall(r"\n    (kind\S+)\n", states[0]) == names


def test_ambient(tmp_path):
    """They begin with the velocity of the flow at their centres."""
    case = sheared_crowd(tmp_path)
    case.replace(
        "constant/immersedBodyProperties", "velocity (1 0.3 0);",
        "velocity ambient;",
    )
    one, _ = check_ranks(case, tmp_path, parts=(2, 2))
    first = {name: one.columns("motion")[name][:100] for name in (
        "position_y", "velocity_x"
    )}
    flow = 0.1*(first["position_y"] - WIDTH/2)
    assert np.corrcoef(first["velocity_x"], flow)[0, 1] > 0.9


def test_sliding_sides(tmp_path):
    """Some pass the sides that slide."""
    one, _ = check_ranks(sheared_crowd(tmp_path), tmp_path, parts=(2, 2))
    y = one.columns("motion")["position_y"].reshape(2, -1)
    assert (np.abs(y[1] - y[0]) > WIDTH/2).any()


def test_goes_on_on_other_ranks(tmp_path):
    """What four ranks have written together is what one or two go on from."""
    case = crowd(tmp_path, (1, 1))
    half = BodyCase(case, tmp_path, "half")
    half.controls(endTime=STEP*STEPS/2)
    assert "Bodies are spread over the ranks" in half.solve(4, (4, 1, 1))
    half.run("reconstructPar")
    for folder in half.path.glob("processor*"):
        shutil.rmtree(folder)
    half.replace("system/decomposeParDict", "Subdomains 4", "Subdomains 2")
    half.replace("system/decomposeParDict", "(4 1 1)", "(2 1 1)")
    case.solve(4, (4, 1, 1))
    motion = motions(case)[:, -200:]
    largest = np.maximum(np.abs(motion).max(axis=1, keepdims=True), 1e-6)
    for ranks in (1, 2):
        other = BodyCase(half, tmp_path, f"on{ranks}")
        other.controls(endTime=STEP*STEPS)
        if ranks > 1:
            other.run("decomposePar", "-latestTime")
        other.solve(ranks)
        difference = motions(other)[:, -200:] - motion
        assert np.max(np.abs(difference)/largest) < 1e-6


@pytest.mark.parametrize("more, contact", [
    ("", SPRINGS),
    pytest.param("", PROJECTIONS["viscous"], marks=pytest.mark.nightly),
    pytest.param(FILMS, SPRINGS, marks=pytest.mark.nightly),
])
def test_restart_is_exact(more, contact, tmp_path):
    at_once = crowd(tmp_path, (12, 0, 1), more, contact=contact)
    parts = run_in_parts(at_once, tmp_path, STEP, STEPS, (4, 1, 1))

    # The sums of fastPoisson may differ in the last bit from run to run
    a, b = motions(at_once), motions(parts)
    assert a.shape == b.shape
    assert np.max(np.abs(a - b)) < 1e-10
