# SPDX-License-Identifier: GPL-3.0-or-later
"""A plane tube whose ends are cyclic, of length 2 and half width 0.5, with
solvers so tight that what is left is rounding."""

import re

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform
from periodicBox import FORCE

SIDES = {"left": "x-", "right": "x+", "walls": "y- y+"}
BOUNDARY = """
    "left|right" {{ type cyclic; }}
    walls {{ type {walls}; }}
    frontAndBack {{ type empty; }}
"""
FLOW_RATE = """FoamFile
{{
    version     2.0;
    format      ascii;
    class       dictionary;
    object      fvOptions;
}}

drive
{{
    type            flowRateForce;
    direction       (1 0 0);
    meanVelocity    {speed:.15g};
}}
"""


def direct_pressure(case):
    """The direct solver for the pressure, U to rounding."""
    path = case.path / "system/fvSolution"
    text = path.read_text()
    text = re.sub(
        r'"\(p\|pFinal\)"\s*{[^}]*}',
        '"(p|pFinal)" { solver fastPoisson; tolerance 1e-13; }', text,
    )
    text = re.sub(r"1e-9;", "1e-13;", text)
    text = re.sub(r"relTol +1e-3;", "relTol 0;", text)
    path.write_text(text)


def periodic_tube(folder, name, cells=16, force=None, speed=None):
    """Driven by an acceleration, or at a mean speed; initial speed 1."""
    case = BodyCase("tube", folder, name)
    boxMesh.write(
        case, uniform(0, 2, 2*cells), uniform(-0.5, 0.5, cells), None, SIDES
    )
    case.set_cyclic("left", "right")
    case.run("blockMesh")
    case.replace("0/U", "uniform (0 0 0);\nboundary",
                 "uniform (1 0 0);\nboundary")
    case.conditions(
        BOUNDARY.format(walls="noSlip"), BOUNDARY.format(walls="zeroGradient")
    )
    if force is not None:
        text = FORCE.format(force=force)
    else:
        text = FLOW_RATE.format(speed=speed)
    (case.path / "constant/fvOptions").write_text(text)
    direct_pressure(case)
    return case
