# SPDX-License-Identifier: GPL-3.0-or-later
"""A box of equal cells that repeats itself in all directions, with a
pressure that falls along x."""

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform

SIDES = {
    "left": "x-", "right": "x+", "bottom": "y-", "top": "y+",
    "back": "z-", "front": "z+",
}
BOUNDARY = """
    "left|right|bottom|top|back|front" { type cyclic; }
    "frontAndBack.*" { type empty; }
"""
JUMP = """
    left
    {{
        type        fixedJump;
        patchType   cyclic;
        jump        uniform {jump:.15g};
        value       uniform 0;
    }}
    right   {{ $left; }}
"""
FORCE = """FoamFile
{{
    version     2.0;
    format      ascii;
    class       dictionary;
    object      fvOptions;
}}

force
{{
    type            vectorSemiImplicitSource;
    selectionMode   all;
    volumeMode      specific;
    injectionRateSuSp {{ U (({force:.15g} 0 0) 0); }}
}}
"""
FLOW_RATE = """
    flowRate
    {
        type            surfaceFieldValue;
        libs            (fieldFunctionObjects);
        regionType      patch;
        name            right;
        operation       sum;
        fields          (phi);
        writeFields     false;
        log             false;
        writePrecision  15;
    }
"""


def set_fields(case, gradient):
    """Boundary conditions and the fall of the pressure; initial speed 1."""
    for field in ("U", "p"):
        path = case.path / "0" / field
        head = path.read_text().split("boundaryField", 1)[0]
        head = head.replace("uniform (0 0 0)", "uniform (1 0 0)")
        jump = JUMP.format(jump=-gradient) if field == "p" else ""
        path.write_text(f"{head}boundaryField\n{{{BOUNDARY}{jump}}}\n")


def periodic_case(
    folder, name, cells, dims, gradient, by_force=False, length=1, row=1
):
    """A cube, or in 2D a square, of this length and cells^dims cells, with a
    flow that a mean pressure gradient over density [m/s2] drives, by_force: a
    body force of that size. row: so many of them along x."""
    case = BodyCase("tube", folder, name)
    side = uniform(0, length, cells)
    names = list(SIDES)[:2*dims]
    boxMesh.write(
        case, uniform(0, row*length, row*cells), side,
        side if dims == 3 else None,
        {name: SIDES[name] for name in names},
    )
    for one, other in zip(names[::2] + names[1::2], names[1::2] + names[::2]):
        case.replace(
            "system/blockMeshDict", f"    {one} {{ type patch;",
            f"    {one} {{ type cyclic; neighbourPatch {other};",
        )
    case.run("blockMesh")
    set_fields(case, 0 if by_force else gradient)
    if by_force:
        file = case.path / "constant/fvOptions"
        file.write_text(FORCE.format(force=gradient))
    case.replace(
        "system/controlDict", "functions\n{", "functions\n{" + FLOW_RATE
    )
    return case


def superficial_speed(case, depth=1):
    """Flow rate per area of the box [m/s] in all time steps."""
    file = "postProcessing/flowRate/0/surfaceFieldValue.dat"
    return case.read_dat(file)[:, 1]/depth
