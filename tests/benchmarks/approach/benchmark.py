# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that approach a wall or each other in Stokes flow: the gap that the
mesh has instead of the true one."""

import math

import numpy as np

import boxMesh
from bodyCase import BodyCase
from boxMesh import graded
from measure import Run, set_viscosity

VISCOSITY, RADIUS = 10, 0.5
# In cells
GAPS = (0.1, 0.5, 1, 1.5)
# Shape: offset and slope of the gap of the mesh, as in the code
LAWS = {"sphere": (0.5, 0.72), "disc": (0.65, 0.68)}
# Gap over radius, and force over 6 pi mu a V of each of two equal spheres that
# approach each other with the speeds V (Brenner 1961)
PAIR = np.array([
    (1, 2.0386546), (0.8, 2.2349157), (0.6, 2.5408835), (0.4, 3.1045909),
    (0.2, 4.6255431), (0.1, 7.4132976), (0.05, 12.711288), (0.02, 28.114022),
    (0.01, 53.422294),
])[::-1]

U = """
    wallBelow { type noSlip; }
    outlet  { type zeroGradient; }
    sides   { type slip; }
"""
P = """
    wallBelow { type zeroGradient; }
    outlet  { type fixedValue; value uniform 0; }
    sides   { type slip; }
"""


def leading(shape, gap):
    """Leading term of the force over its scale; gap over the radius of a body
    that has the same one with a plane."""
    return 1/gap if shape == "sphere" else 3*math.sqrt(2)*gap**-1.5


def exact(shape, pair, gap):
    """Force over its scale, at a gap over the radius."""
    if pair:
        rest = np.interp(
            math.log(gap), np.log(PAIR[:, 0]), PAIR[:, 1] - 0.5/PAIR[:, 0]
        )
        return 0.5/gap + rest
    if shape == "sphere":
        return 1/gap - 0.2*math.log(gap) + 0.97128
    alpha = math.acosh(1 + gap)
    return 4/(alpha - math.tanh(alpha))


def make_case(folder, shape, pair, cells):
    """The case, and its number of cells."""
    h, flat = 1/cells, shape == "disc"
    case = BodyCase("tube", folder, f"{shape}{pair}{cells}")
    planes = ["middleY"] if flat else ["middleY", "middleZ"]
    sides = {
        "wallBelow": "x-", "outlet": "x+", "sides": "y+" if flat else "y+ z+",
        **{plane: plane[-1].lower() + "-" for plane in planes},
    }
    empty = "frontAndBack { type empty; }" if flat else ""
    case.conditions(U + empty, P + empty)

    width, core = 15 if flat else 4, h*round(1.8/h)
    across = graded(0, width, (0, h*round(0.75/h)), h)
    along = (
        graded(-4, 4, (-core + 0.3*h, core + 0.3*h), h)
        if pair else graded(0, width + 2, (0, core), h)
    )
    n = boxMesh.write(case, along, across, None if flat else across, sides)
    for plane in planes:
        case.set_symmetry(plane)
    case.run("blockMesh")
    set_viscosity(case, VISCOSITY)
    case.replace("system/fvSchemes", "div(phi,U)", "div(phi,U) none; //")

    # The gap closes at the speed of one
    speed, start = (0.5, 1.25*h) if pair else (1, 2.5*h)
    case.bodies("\n".join(
        f"body{i} {{ shape {{ type {shape}; radius {RADIUS}; }}"
        f" densityRatio 1; position ({side*(RADIUS + start)} 0 0);"
        f" motion {{ type prescribed; velocity ({-side*speed} 0 0);"
        " angularVelocity (0 0 0); } }"
        for i, side in enumerate((1, -1) if pair else (1,))
    ))
    case.controls(endTime=2.45*h, deltaT=0.05*h)
    return case, n


def mesh_gaps(case, shape, pair, cells):
    """Gaps and those of the mesh, both in cells."""
    h = 1/cells
    x = case.table("motion")["position_x"]
    force = case.table("forces")["fluidForce_x"]
    # Over the leading term's factor: relative speed 1, depth 0.1
    scale = math.pi*VISCOSITY*(6*RADIUS if shape == "sphere" else 0.1)
    if pair:
        scale *= 0.5
    gap = (x - RADIUS)*(2 if pair else 1)/RADIUS
    inside = (gap > 1e-6) & (gap < 2*h/RADIUS)

    found = []
    for e, f in zip(gap[inside], force[inside]/scale, strict=True):
        # Half the radius, twice the force over that
        term = 0.5/e if pair else leading(shape, e)
        resolved = f - (exact(shape, pair, e) - term)
        if shape == "sphere":
            seen = (0.5 if pair else 1)/resolved
        else:
            seen = (3*math.sqrt(2)/resolved)**(2/3)
        found.append((e*RADIUS/h, seen*RADIUS/h))
    return np.array(sorted(found))


def approach(folder, shape, pair, cells):
    """Rows of one approach."""
    case, n = make_case(folder, shape, pair, cells)
    settings = shape + (", pair" if pair else ", wall")
    run = Run(case, settings, cells, n)
    offset, slope = LAWS[shape]
    table = mesh_gaps(case, shape, pair, cells)
    for gap in GAPS:
        yield run.row(
            f"gap of the mesh at {gap} h, over h",
            np.interp(gap, *table.T), offset + slope*gap,
        )


def rows(folder, quick):
    runs = [("sphere", False, 8)]
    if not quick:
        runs += [
            ("sphere", True, 8), ("disc", False, 8), ("disc", False, 16),
        ]
    for shape, pair, cells in runs:
        yield from approach(folder, shape, pair, cells)
