# SPDX-License-Identifier: GPL-3.0-or-later
"""Forces on a cylinder across a square channel, steady, in 3D."""

import boxMesh
from bodyCase import BodyCase
from boxMesh import graded, uniform
from dfgChannel import DIAMETER, HEIGHT, add_probes
from measure import Run

C_D, C_L = 6.18533, 0.009401
SPEED, LENGTH = 0.2, 2.5

# The flow is symmetric about half the width: that half is computed
PATCHES = {"inlet": "x-", "outlet": "x+", "walls": "y- y+ z-", "middle": "z+"}
PROFILE = (
    "7.2*pos().y()*pos().z()*(0.41 - pos().y())*(0.41 - pos().z())"
    "/pow(0.41, 4)"
)


def make(folder, cells):
    """The case with cells per diameter, and the number of its cells."""
    h = DIAMETER/cells
    case = BodyCase("cylinder", folder, f"D{cells}")
    n = boxMesh.write(
        case,
        graded(0, LENGTH, (0.4, 0.7), h, 1.08),
        uniform(0, HEIGHT, round(HEIGHT/h)),
        # Little changes along the cylinder but next to the wall
        graded(0, 0.5*HEIGHT, (0, 2*h), h, 1.08),
        PATCHES,
    )
    case.replace(
        "system/blockMeshDict", "middle { type patch", "middle { type symmetry"
    )
    old = "1.2*pos().y()*(0.41 - pos().y())/sqr(0.41)"
    for file in ("0/U", "system/setExprFieldsDict"):
        case.replace(file, old, PROFILE)
    for file in ("0/U", "0/p"):
        case.replace(
            file, "frontAndBack { type empty; }", "middle { type symmetry; }"
        )
    case.run("blockMesh")
    case.run("setExprFields")
    # From the wall to beyond the plane of symmetry
    case.bodies(f"""
        cylinder
        {{
            shape {{ type cylinder; radius {0.5*DIAMETER}; length 0.4; }}
            position    (0.5 0.2 0.2);
            constraints {{ translate (0 0 0); rotate (0 0 0); }}
        }}
    """)
    # In the plane of symmetry
    add_probes(case, "(0.45 0.2 0.20499)", "(0.55 0.2 0.20499)")
    return case, n


def rows(folder, quick):
    for cells in (8,) if quick else (8, 12):
        case, n = make(folder, cells)
        dt = 2*DIAMETER/cells
        case.controls(endTime="8", deltaT=f"{dt:.6g}")
        run = Run(case, "steady", cells, n)

        forces = case.table("forces")
        p = case.read_dat("postProcessing/pressure/0/p")[-1]
        # Twice the half
        scale = 2*2/(SPEED**2*DIAMETER*HEIGHT)
        drag, lift = scale*forces["fluidForce_x"], scale*forces["fluidForce_y"]
        yield run.row("C_D", drag[-1], C_D)
        yield run.row("C_L", lift[-1], C_L)
        yield run.row("dp", p[1] - p[2])
        last = forces["time"] > 0.9*forces["time"][-1]
        change = max(abs(drag[last]/drag[-1] - 1))
        yield run.row("C_D last change, %", 100*change)
