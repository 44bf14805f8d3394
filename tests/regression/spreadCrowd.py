# SPDX-License-Identifier: GPL-3.0-or-later
"""A crowd of discs and ellipses that the mesh resolves, so many that each rank
holds only those near to it."""

import re

import numpy as np

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform
from periodicBox import SIDES, set_fields
from periodicTube import direct_pressure
from slidingBox import centres, set_velocity, sliding_box
from spreadRuns import motions, write_twice

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
