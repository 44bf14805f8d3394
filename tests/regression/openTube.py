# SPDX-License-Identifier: GPL-3.0-or-later
"""A plane tube, y = -1 to 1, from x = 0 to LENGTH, that bodies pass through:
mean speed 1, Re = 2.

    case = open_tube(folder, driven="pressure")
    case.bodies("", INJECTION)
    case.solve()
    passage(case)
"""

from dataclasses import dataclass

import numpy as np

from bodyCase import BodyCase
from boxMesh import uniform
from foamCase import tables

LENGTH, RADIUS, H, DT = 4, 0.25, 0.1, 0.02
DISC = f"shape {{ type disc; radius {RADIUS}; }} densityRatio 2;"
RATE = """functions
{
    rate
    {
        type            surfaceFieldValue;
        libs            (fieldFunctionObjects);
        regionType      patch;
        name            outlet;
        operation       sum;
        fields          (phi);
        writeFields     no;
        log             no;
        writeControl    timeStep;
        writePrecision  12;
    }"""


def open_tube(folder, name="openTube", driven="rate", length=LENGTH):
    """Pressure 0 at the outlet; at the inlet the parabola, or the pressure
    that drives it."""
    case = BodyCase("tube", folder, name)
    case.replace("0/U", "outlet  { $inlet; }", "outlet { type zeroGradient; }")
    ends = "outlet { type fixedValue; value uniform 0; }"
    if driven == "pressure":
        case.replace("0/U", "    inlet\n", "    unused\n")
        case.replace(
            "0/U", "    outlet {",
            "    inlet { type zeroGradient; }\n    outlet {",
        )
        ends += (
            f" inlet {{ type fixedValue; value uniform {1.5*length}; }}"
        )
    case.replace("0/p", "boundaryField\n{", f"boundaryField\n{{ {ends}")
    case.replace("system/controlDict", "functions\n{", RATE)
    case.controls(deltaT=str(DT))
    case.mesh(
        uniform(0, length, round(length/H)), uniform(-1, 1, round(2/H))
    )
    return case


@dataclass
class Event:
    """A row of the table of bodies that enter and leave."""

    time: float
    number: int
    position: np.ndarray
    velocity: np.ndarray
    spin: np.ndarray
    what: str
    name: str
    where: str


def passage(case):
    """All rows, of all parts of a run."""
    columns = tables.run_columns(case.path, "immersedBodies", "passage")
    return [
        Event(x[0], x[1], np.array(x[2:5]), np.array(x[5:8]),
              np.array(x[8:11]), *x[11:])
        for x in zip(*columns.values())
    ]


def flow_rate(case):
    """Time and flow rate of every step."""
    (file,) = case.path.glob("postProcessing/rate/0/surfaceFieldValue.dat")
    return case.read_dat(file.relative_to(case.path)).T
