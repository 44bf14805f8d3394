# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag of a sphere that is held on the axis of a round tube, Stokes flow."""

import math

import roundTube
from bodyCase import BodyCase
from boxMesh import graded
from measure import (
    LOCKED, Run, around, number_of_cells, set_profile, set_stokes,
)

# Radius over that of the tube: drag over 6 pi mu a U_max
FACTORS = {0.3: 2.2289766, 0.5: 4.9953386}
SPEED, NU = 1.5, 0.5


def rows(folder, quick):
    for radius, factor in FACTORS.items():
        for cells in (8, 12) if quick else (8, 12, 16):
            h = 2*radius/cells
            case = BodyCase("tube", folder, f"a{radius}_D{cells}")
            set_stokes(case)
            set_profile(
                case, "1 - sqr(pos().y())",
                "1 - sqr(pos().y()) - sqr(pos().z())",
            )
            core = around(0, radius + 0.45, h, 0.2)
            roundTube.write(case, graded(-3, 3, core, h, 1.15), h)
            case.run("blockMesh")
            case.run("setExprFields")
            # Off the symmetry of the mesh
            case.bodies(f"""
                sphere
                {{
                    shape {{ type sphere; radius {radius}; }}
                    position (0 {0.1*h} {0.3*h});
                    {LOCKED}
                }}
            """)
            case.controls(endTime="1.2", deltaT="0.04")
            run = Run(case, f"a/R {radius}", cells, number_of_cells(case))

            force = case.table("forces")["fluidForce_x"][-1]
            drag = force/(6*math.pi*NU*radius*SPEED)
            yield run.row("drag/(6 pi mu a U)", drag, factor)
