# SPDX-License-Identifier: GPL-3.0-or-later
"""Time per step against the number of grains that the mesh does not resolve."""

import sys
from pathlib import Path

import numpy as np

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parent/"cost"))

from grainsPlot import plot_grains  # noqa: E402
from timedRun import TimedRun  # noqa: E402

SIZE, QUICK_SIZE = (64, 64, 128), (32, 32, 64)
NUMBERS, QUICK_NUMBERS = (0, 10, 100, 1000, 10000), (0, 100, 1000)
DIAMETER = 0.8
# Scene with resolved spheres in one half, grains that are not in the other
MIXED_SIZE, MIXED_DIAMETER = (48, 48, 96), 0.6
MIXED_NUMBERS = (1000, 10000, 100000)
# One rank, a part with spheres and one with grains, and two that have both
CUTS = {
    "1 rank": (1, 1, 1), "2 ranks, apart": (1, 1, 2),
    "2 ranks, alike": (2, 1, 1),
}
SPHERES, SPHERE_DIAMETER = 8, 8
PARTS = {
    "ms per step": "step", "bodies ms": "bodies", "pressure ms": "pressure",
    "momentum ms": "momentum",
}
SIDES = {"left": "x-", "right": "x+", "front": "y-", "back": "y+",
         "inlet": "z-", "outlet": "z+"}
PAIRS = (("left", "right"), ("front", "back"), ("inlet", "outlet"))
CYCLIC = '\n    "left|right|front|back|inlet|outlet" { type cyclic; }\n'


def make(folder, size):
    """A box of unit cells that repeats itself, with a flow of speed 1 along
    z; nu 0.01."""
    case = BodyCase("tube", folder, "mesh")
    boxMesh.write(case, *(uniform(0, n, n) for n in size), SIDES)
    for one, other in PAIRS:
        for side, beyond in ((one, other), (other, one)):
            case.replace(
                "system/blockMeshDict", f"    {side} {{ type patch;",
                f"    {side} {{ type cyclic; neighbourPatch {beyond};",
            )
    for field in ("U", "p"):
        path = case.path/"0"/field
        head = path.read_text().split("boundaryField", 1)[0]
        head = head.replace("uniform (0 0 0)", "uniform (0 0 1)")
        path.write_text(f"{head}boundaryField\n{{{CYCLIC}}}\n")
    case.run("blockMesh")
    case.replace("constant/transportProperties", "0.5;", "0.01;")
    case.replace(
        "system/fvSchemes", "div(phi,U)          Gauss linear",
        "div(phi,U)          Gauss linearUpwind grad(U)",
    )
    # For the run without grains, which is as that of pimpleFoam
    case.replace(
        "system/fvSchemes", "default             none",
        "default             Gauss linear",
    )
    case.replace(
        "system/fvSolution", "GAMG;\n        smoother        GaussSeidel",
        "fastPoisson",
    )
    case.bodies("")
    # Tables of ten thousand rows per step are not what is timed
    path = case.path/"system/controlDict"
    path.write_text(
        path.read_text().split("functions\n{", 1)[0] + "functions\n{}\n"
    )
    return case


def positions(size, number, diameter=DIAMETER):
    """Places that do not overlap: a lattice, displaced at random."""
    pitch = (np.prod(size)/number)**(1/3)
    n = [max(1, int(np.ceil(side/pitch))) for side in size]
    lattice = np.stack(np.meshgrid(*map(np.arange, n), indexing="ij"), -1)
    lattice = lattice.reshape(-1, 3)
    random = np.random.default_rng(1)
    chosen = lattice[random.permutation(len(lattice))[:number]]
    step = np.array(size)/n
    jitter = random.uniform(-0.5, 0.5, chosen.shape)*(step - 1.1*diameter)
    return (chosen + 0.5)*step + jitter


def add_grains(case, size, number):
    """Grains 1000 times as dense as the fluid, at half of its speed."""
    lines = "\n".join(
        f"({x:.9g} {y:.9g} {z:.9g})" for x, y, z in positions(size, number)
    )
    (case.path/"constant/grains").write_text(f"(\n{lines}\n)\n")
    case.bodies(f"""
        grain
        {{
            shape           {{ type sphere; radius {DIAMETER/2}; }}
            densityRatio    1000;
            positionsFile   "constant/grains";
            velocity        (0 0.1 0.5);
        }}
    """, "contact { type softSphere; } coupling { type auto; }")


def add_mixed(case, number):
    """Resolved spheres in the upper half, grains that are not below."""
    x, y, z = MIXED_SIZE
    kinds = [("sphere", SPHERE_DIAMETER, 2, [
        (x*(i + 0.5)/2, y*(j + 0.5)/2, z*(0.62 + 0.22*k))
        for i in (0, 1) for j in (0, 1) for k in (0, 1)
    ])]
    if number:
        below = positions((x, y, 0.46*z), number, MIXED_DIAMETER)
        kinds.append(("grain", MIXED_DIAMETER, 1000, below))
    text = ""
    for name, diameter, ratio, places in kinds:
        lines = "\n".join("({:.9g} {:.9g} {:.9g})".format(*p) for p in places)
        (case.path/f"constant/{name}s").write_text(f"(\n{lines}\n)\n")
        text += f"""
            {name}
            {{
                shape           {{ type sphere; radius {diameter/2}; }}
                densityRatio    {ratio};
                positionsFile   "constant/{name}s";
                velocity        (0 0.1 0.5);
            }}
        """
    case.bodies(text, "contact { type softSphere; } coupling { type auto; }")


def timed_mixed(mesh, number, cut):
    parts = CUTS[cut]
    ranks = int(np.prod(parts))
    case = BodyCase(mesh, mesh.path.parent, f"mixed{number}_{parts[0]}{ranks}")
    add_mixed(case, number)
    if ranks > 1:
        case.decompose(ranks, parts)
    return TimedRun(
        case, ["foamRun", "-solver", "immersedFluid"],
        f"{SPHERES} spheres, {number} grains, {cut}",
        MIXED_DIAMETER, int(np.prod(MIXED_SIZE)), ranks,
    )


def mixed_rows(folder):
    """Resolved spheres and grains that are not in one scene."""
    mesh = make(folder/"mixed", MIXED_SIZE)
    for cut in CUTS:
        for number in (0, *MIXED_NUMBERS):
            run = timed_mixed(mesh, number, cut)
            yield run.row("mixed, ms per step", run.step)
            yield run.row("mixed, outer iterations", run.outers)


def timed(mesh, size, number, ranks):
    case = BodyCase(mesh, mesh.path.parent, f"{number}_{ranks}")
    if number:
        add_grains(case, size, number)
    if ranks > 1:
        case.decompose(ranks, (1, 1, ranks))
    return TimedRun(
        case, ["foamRun", "-solver", "immersedFluid"],
        f"{number} grains, {ranks} rank{'s'*(ranks > 1)}",
        DIAMETER if number else None, int(np.prod(size)), ranks,
    )


def rows(folder, quick):
    size = QUICK_SIZE if quick else SIZE
    numbers = QUICK_NUMBERS if quick else NUMBERS
    mesh = make(folder, size)
    for ranks in (1, 2):
        for number in numbers:
            run = timed(mesh, size, number, ranks)
            yield run.row("ms per step", run.step)
            yield run.row("memory MB", run.memory*run.cells/1024)
            if number:
                for name, time in zip(("momentum", "pressure", "bodies"),
                                      run.parts):
                    yield run.row(f"{name} ms", time)
                yield run.row("outer iterations", run.outers)
    if not quick:
        yield from mixed_rows(folder)


def draw(rows, file):
    """Time of a step, and its parts, against the number of grains."""
    cells = f"{rows[0]['cells']:,}".replace(",", " ") if rows else ""
    plot_grains(rows, PARTS, f"grains of {DIAMETER} cells, {cells} cells", file)
