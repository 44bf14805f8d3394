# SPDX-License-Identifier: GPL-3.0-or-later
"""A sphere held near a wall in shear flow, Re = 10."""

import math

import boxMesh
from bodyCase import BodyCase
from boxMesh import graded
from measure import LOCKED, Run, set_viscosity

# Height of the centre over the diameter: C_D, C_L, C_M of direct simulations,
# C_D and C_L of the correlation
REFERENCES = {
    0.505: (6.5, 1.3, 1.8, 6.4587, 1.3189),
    1: (5.1, 0.75, 0.8, 5.1835, 0.79573),
}
# Of the speed at the height of the centre, 1, and the diameter, 1
REYNOLDS = 10
END, STEP = 16, 0.1
# Size of the box
FAR = 8

U = """
    inlet
    {{
        type        exprFixedValue;
        valueExpr   "vector({shear:.15g}*pos().y(), 0, 0)";
        value       uniform (0 0 0);
    }}
    top         {{ $inlet; }}
    outlet      {{ type zeroGradient; }}
    wall        {{ type noSlip; }}
    "middle|side" {{ type symmetryPlane; }}
"""
P = """
    "inlet|top|wall" { type zeroGradient; }
    outlet      { type fixedValue; value uniform 0; }
    "middle|side" { type symmetryPlane; }
"""
PATCHES = {
    "inlet": "x-", "outlet": "x+", "wall": "y-", "top": "y+",
    "middle": "z-", "side": "z+",
}


def set_fields(case, shear):
    """Conditions of the box; undisturbed flow at the start."""
    for field, conditions in (("U", U.format(shear=shear)), ("p", P)):
        path = case.path / "0" / field
        head = path.read_text().split("boundaryField", 1)[0]
        path.write_text(f"{head}boundaryField\n{{{conditions}}}\n")
    case.replace(
        "system/setExprFieldsDict", "1.5*(1 - sqr(pos().y()))",
        f"{shear:.15g}*pos().y()",
    )
    case.run("setExprFields")


def solve(folder, height, cells):
    """Loads on the sphere after each step, and the run."""
    h = 1/cells
    case = BodyCase("tube", folder, f"L{height}_D{cells}")
    # Off the sphere by 0.3 cells along the flow
    n = round(1.1/h)
    total = boxMesh.write(
        case,
        graded(-2*FAR, 4*FAR, (-(n + 0.3)*h, (n - 0.3)*h), h),
        graded(0, 2*FAR, (0, math.ceil((height + 0.9)/h)*h), h),
        graded(0, 1.5*FAR, (0, math.ceil(0.9/h)*h), h),
        PATCHES,
    )
    for name in ("middle", "side"):
        case.replace(
            "system/blockMeshDict", f"{name} {{ type patch;",
            f"{name} {{ type symmetryPlane;",
        )
    case.run("blockMesh")
    set_fields(case, 1/height)
    set_viscosity(case, 1/REYNOLDS)
    case.bodies(f"""
        sphere
        {{
            shape       {{ type sphere; radius 0.5; }}
            position    (0 {height} 0);
            {LOCKED}
        }}
    """)
    case.controls(endTime=f"{END}", deltaT=f"{STEP}")
    run = Run(case, f"L/D {height}", cells, total)
    forces = case.table("forces")
    area = math.pi/4
    return run, {
        "C_D": forces["fluidForce_x"]/(0.5*area),
        "C_L": forces["fluidForce_y"]/(0.5*area),
        "C_M": -forces["fluidTorque_z"]/(0.25*area),
    }


def rows(folder, quick):
    for height, references in REFERENCES.items():
        for cells in (8,) if quick else (8, 12, 16):
            run, loads = solve(folder, height, cells)
            for name, reference in zip(loads, references):
                yield run.row(name, loads[name][-1], reference)
            for name, reference in zip(("C_D", "C_L"), references[3:]):
                yield run.row(
                    f"{name} (correlation)", loads[name][-1], reference
                )
            drag = loads["C_D"]
            last = abs(drag[3*len(drag)//4:]/drag[-1] - 1).max()
            yield run.row("last change, %", 100*last)
