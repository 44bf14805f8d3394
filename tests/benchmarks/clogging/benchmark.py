# SPDX-License-Identifier: GPL-3.0-or-later
"""Flow rate of a tube driven by traction, with twenty grains in it that are
free, and held."""

from pathlib import Path

import numpy as np

from endCase import EndCase
from measure import DEPTH, Run, around, set_stokes

RADIUS = 0.065
HALF_LENGTH = 4

# Stokes flow is linear: so weak that no grain moves by 0.001 of its radius
FORCE = 5e-5

# Placing: Q/F of free grains, of held ones
REFERENCES = {
    1: (0.08217682, 0.01634376),
    2: (0.08326886, 0.01250722),
    6: (0.08059586, 0.03362940),
    7: (0.08518056, 0.01607492),
}
KINDS = {
    "free": "densityRatio 1; velocity ambient;",
    "held": "motion { type fixed; }",
}
FLOW_RATE = """functions
{
    flowRate
    {
        type        surfaceFieldValue;
        libs        (fieldFunctionObjects);
        writeFields false;
        regionType  patch;
        name        outlet;
        operation   sum;
        fields      (phi);
    }
"""

# Cells across the tube, placings
QUICK = ((124, (1, 6)),)
FULL = ((124, tuple(REFERENCES)), (248, (1, 6)))


def set_solvers(case):
    """The mesh is a box; diffusion over many cells in a time step."""
    case.replace(
        "system/fvSolution", "solver          GAMG;\n"
        "        smoother        GaussSeidel;", "solver          fastPoisson;"
    )
    case.replace(
        "system/fvSolution", "solver          PBiCGStab;\n"
        "        preconditioner  DILU;",
        "solver          GAMG;\n        smoother        GaussSeidel;",
    )
    case.replace("system/fvSolution", "1e-3", "0.01")


def solve(folder, placing, kind, across):
    """Flow rate over force by time step, and the run."""
    h = 2/across
    case = EndCase(
        folder, f"{placing}_{kind}_{across}", h,
        (around(0, 3.05, h), (-1, 1)), h, FORCE, half_length=HALF_LENGTH,
    )
    set_stokes(case)
    case.replace("system/fvSchemes", "default backward", "default Euler")
    set_solvers(case)
    table = np.loadtxt(
        Path(__file__).parent / "centres.csv", delimiter=",",
    )
    centres = " ".join(
        f"({x:.10g} {y:.10g} 0)" for _, x, y in table[table[:, 0] == placing]
    )
    case.bodies(f"""
        grain
        {{
            shape       {{ type disc; radius {RADIUS}; }}
            positions   ({centres});
            {KINDS[kind]}
        }}
    """)
    case.controls(endTime="6", deltaT="0.2", writeInterval="6")
    case.replace("system/controlDict", "functions\n{\n", FLOW_RATE)
    D_over_h = round(2*RADIUS/h, 2)
    run = Run(case, f"placing {placing} {kind}", D_over_h, case.cells,
              may_fail=True)
    if run.failed:
        return None, run
    (file,) = case.path.glob("postProcessing/flowRate/*/*.dat")
    return np.loadtxt(file)[:, 1]/DEPTH/FORCE, run


def rows(folder, quick):
    for across, placings in QUICK if quick else FULL:
        for placing in placings:
            for kind, reference in zip(KINDS, REFERENCES[placing]):
                rates, run = solve(folder, placing, kind, across)
                if run.failed:
                    yield run.diverged()
                    continue
                last, early = rates[-1], rates[3*len(rates)//4 - 1]
                yield run.row(f"Q/F {kind}", last, reference)
                yield run.row("last change, %", 100*abs(last/early - 1))
