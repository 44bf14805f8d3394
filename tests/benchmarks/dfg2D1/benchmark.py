# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag, lift and pressure difference of a cylinder in a channel, steady."""

from bodyCase import BodyCase
from boxMesh import graded, uniform
from measure import DEPTH, Run

C_D, C_L, DP = 5.57953523384, 0.010618948146, 0.11752016697
SPEED, DIAMETER = 0.2, 0.1


def add_probes(case):
    """Probes of the pressure at the front and the rear of the cylinder."""
    case.replace("system/controlDict", "functions\n{", f"""functions
{{
    pressure
    {{
        type            probes;
        libs            (sampling);
        writeControl    timeStep;
        writeInterval   10;
        fields          (p);
        interpolationScheme cellPoint;
        probeLocations  ((0.15 0.2 0) (0.25 0.2 0));
    }}""")


def rows(folder, quick):
    for cells in (10, 20) if quick else (10, 20, 40):
        h = DIAMETER/cells
        case = BodyCase("cylinder", folder, f"D{cells}")
        n = case.mesh(
            graded(0, 2.2, (0.1, 0.5), h, 1.05),
            uniform(0, 0.41, round(0.41/h)),
        )
        case.controls(endTime="8", deltaT=f"{2*h:.6g}")
        add_probes(case)
        run = Run(case, "steady", cells, n)

        forces = case.table("forces")
        scale = 2/(SPEED**2*DIAMETER*DEPTH)
        yield run.row("C_D", scale*forces["fluidForce_x"][-1], C_D)
        yield run.row("C_L", scale*forces["fluidForce_y"][-1], C_L)
        p = case.read_dat("postProcessing/pressure/0/p")[-1]
        yield run.row("dp", p[1] - p[2], DP)
