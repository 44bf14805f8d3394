# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains that fall into a heap and come to rest: balance of energy, and the
time of a step by their number."""

import math
import re

import numpy as np

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform
from grainsPlot import plot_grains
from measure import Run

# Diameter, gravity and mass of a disc of the density of the fluid: 1
RATIO, CELLS, STEP, END = 1e5, 4, 0.05, 30
SPACING, JITTER = 1.06, 0.02
NUMBERS = (30, 100, 300, 1000)
PARTS = {"time of a step [ms]": "step", "of that contact [ms]": "contact"}

ENERGY = """
    energy
    {
        type            immersedBodyEnergy;
        libs            (immersedBodyFunctionObjects);
        writeControl    timeStep;
        writePrecision  12;
    }
"""


def grains(number, width):
    """Entries of a block of grains, a little out of their places."""
    random = np.random.default_rng(1)
    columns = math.ceil(math.sqrt(number))
    left = 0.5*(width - (columns - 1)*SPACING)
    place = [
        (left + SPACING*(i % columns), 0.6 + SPACING*(i//columns))
        for i in range(number)
    ]
    place = np.array(place) + random.uniform(-JITTER, JITTER, (number, 2))
    positions = " ".join(f"({x:.6f} {y:.6f} 0)" for x, y in place)
    return (
        "grain { shape { type disc; radius 0.5; }"
        f" densityRatio {RATIO}; positions ({positions}); }}"
    )


def make_case(folder, number):
    """The case, and its number of cells."""
    case = BodyCase("box", folder, f"N{number}")
    n = math.ceil(1.3*math.sqrt(number)*SPACING)
    side = uniform(0, n, n*CELLS)
    cells = boxMesh.write(case, side, side, None, {"walls": "x- x+ y- y+"})
    for field in ("U", "p"):
        case.replace(
            f"0/{field}", "boundaryField\n{",
            "boundaryField\n{\n    frontAndBack { type empty; }",
        )
    case.run("blockMesh")
    case.replace(
        "system/fvSolution", "GAMG;\n        smoother        GaussSeidel",
        "fastPoisson",
    )
    case.replace("constant/transportProperties", "0.1;", "0.001;")
    case.gravity(0, -1)
    case.replace("system/controlDict", "functions\n{", f"functions\n{{{ENERGY}")
    case.bodies(
        grains(number, n),
        "contact { type softSphere; restitution 0.5; friction 0.5;"
        " collisionTime 0.03; }",
    )
    return case, cells


def contact_part(case):
    """Part of the time that is spent in contact, by OpenFOAM's profiling."""
    (file,) = case.path.glob(f"{case.latest_time()}/uniform/profiling")
    text = file.read_text()

    def seconds(name):
        times = re.findall(
            rf'description\s+"{name}";\s+calls.*;\s+totalTime\s+(\S+);', text
        )
        return sum(map(float, times))

    return seconds("immersedBodies::contact")/seconds("application::main")


def fall(folder, number, end):
    """Rows of one heap."""
    case, cells = make_case(folder, number)
    case.controls(
        endTime=end, deltaT=STEP, profiling="{}", writeInterval=end
    )
    run = Run(case, f"{number} grains", CELLS, cells, may_fail=True)
    if run.failed:
        yield run.diverged()
        return

    (file,) = case.path.glob("postProcessing/energy/0/*.dat")
    table = np.loadtxt(file)
    kinetic = table[:, 1] + table[:, 2]
    lost = table[0, 3] - table[-1, 3]
    total = table[:, 1:].sum(axis=1)

    yield run.row("time of a step [ms]", 1000*run.cpu/run.steps)
    yield run.row("of that contact [ms]",
                  1000*run.cpu/run.steps*contact_part(case))
    yield run.row("kinetic energy at the end over the largest",
                  kinetic[-1]/kinetic.max())
    yield run.row("largest error of the balance over what is lost [%]",
                  100*np.abs(total - total[0]).max()/lost)


def rows(folder, quick):
    for number in NUMBERS[:1] if quick else NUMBERS:
        yield from fall(folder, number, END)


def draw(rows, file):
    """Time of a step, and contact's part, against the number of grains."""
    plot_grains(rows, PARTS, "heap of discs, 4 cells each", file)
