# SPDX-License-Identifier: GPL-3.0-or-later
"""The channel with a cylinder of the DFG benchmarks, in 2D."""

from bodyCase import BodyCase
from boxMesh import graded, uniform

DIAMETER, LENGTH, HEIGHT = 0.1, 2.2, 0.41


def add_probes(case, front, rear, interval=1):
    """Probes of the pressure at two points of the surface."""
    case.replace("system/controlDict", "functions\n{", f"""functions
{{
    pressure
    {{
        type            probes;
        libs            (sampling);
        writeControl    timeStep;
        writeInterval   {interval};
        fields          (p);
        interpolationScheme cellPoint;
        probeLocations  ({front} {rear});
    }}""")


def make(folder, name, cells, mean_speed=0.2):
    """The case with cells per diameter, and the number of its cells."""
    h = DIAMETER/cells
    case = BodyCase("cylinder", folder, name)
    for file in ("0/U", "system/setExprFieldsDict"):
        case.replace(file, "1.2*pos", f"{6*mean_speed:.12g}*pos")
    n = case.mesh(
        graded(0, LENGTH, (0.1, 0.5), h, 1.05),
        uniform(0, HEIGHT, round(HEIGHT/h)),
    )
    add_probes(case, "(0.15 0.2 0)", "(0.25 0.2 0)")
    return case, n
