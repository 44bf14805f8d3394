# SPDX-License-Identifier: GPL-3.0-or-later
"""Half a plane channel with a turbulence model, driven by a uniform force: half
width, friction velocity and force are 1. Periodic, one cell long.

    y, U = solve("case", tmp_path, 395, cells=20, offset=0.3)

The wall at y = 0 is a patch, or the face of an immersed slab.
"""

import numpy as np

import boxMesh
from bodyCase import BodyCase
from boxMesh import HEADER, uniform
from turbulence import header

LENGTH = 20
# Cells below the immersed wall
BELOW = 8

FIELDS = {
    # class, dimensions, value, at the mesh's wall, in the middle
    "U": ("volVectorField", "0 1 -1 0 0 0 0", "(15 0 0)", "noSlip", "slip"),
    "p": ("volScalarField", "0 2 -2 0 0 0 0", 0, "zeroGradient",
          "zeroGradient"),
    "k": ("volScalarField", "0 2 -2 0 0 0 0", 1, None, "zeroGradient"),
    "omega": ("volScalarField", "0 0 -1 0 0 0 0", 50,
              "omegaWallFunction; value uniform 50", "zeroGradient"),
    "epsilon": ("volScalarField", "0 2 -3 0 0 0 0", 5,
                "epsilonWallFunction; value uniform 5", "zeroGradient"),
    "nuTilda": ("volScalarField", "0 2 -1 0 0 0 0", 0.05,
                "fixedValue; value uniform 0", "zeroGradient"),
    "nut": ("volScalarField", "0 2 -1 0 0 0 0", 0.01, None,
            "calculated; value uniform 0"),
}
MODELS = {
    "kOmegaSST": ("k", "omega"),
    "kEpsilon": ("k", "epsilon"),
    "SpalartAllmaras": ("nuTilda",),
}
WALLS = {
    "low Re": {"k": "fixedValue; value uniform 1e-12",
               "nut": "nutLowReWallFunction; value uniform 0"},
    "wall functions": {"k": "kqRWallFunction; value uniform 1",
                       "nut": "nutkWallFunction; value uniform 0"},
    "wall functions of U": {"nut": "nutUSpaldingWallFunction; value uniform 0"},
}
SLAB = """
    slab
    {
        shape       { type box; size (19.99 2 1); }
        position    (10 -1 0);
        motion      { type fixed; }
    }
"""
# The same algorithm for a mesh that has no body: one that never comes
NO_BODY = """
injection
{
    none { shape { type disc; radius 0.3; } densityRatio 1;
           position (10 0.5 0); times (1e30); }
}
"""


def write_mesh(case, y, wall):
    patches = {"left": "x-", "right": "x+", wall: "y-", "middle": "y+"}
    boxMesh.write(case, uniform(0, LENGTH, 1), y, None, patches)
    for name, other in (("left", "right"), ("right", "left")):
        case.replace(
            "system/blockMeshDict", f"{name} {{ type patch;",
            f"{name} {{ type cyclic; neighbourPatch {other};",
        )
    case.run("blockMesh")


def write_fields(case, wall, walls, model):
    for name in ("U", "p", *MODELS[model], "nut"):
        kind, dimensions, value, at_wall, middle = FIELDS[name]
        if wall == "below":
            at_wall = middle
        elif at_wall is None:
            at_wall = WALLS[walls][name]
        (case.path / "0" / name).write_text(
            header(kind, name) + f"""
dimensions [{dimensions}];
internalField uniform {value};
boundaryField
{{
    "(left|right)" {{ type cyclic; }}
    {wall} {{ type {at_wall}; }}
    middle {{ type {middle}; }}
    frontAndBack {{ type empty; }}
}}
""")


def set_model(case, Re, model):
    case.replace("constant/transportProperties", "1e-3;", f"{1/Re:.10g};")
    case.replace(
        "constant/turbulenceProperties", "simulationType  laminar;",
        "simulationType RAS;\n"
        f"RAS {{ RASModel {model}; turbulence on; printCoeffs off; }}\n",
    )
    case.replace("system/fvSchemes", "default backward", "default Euler")
    case.replace(
        "system/fvSchemes", "    div(phi,U)          Gauss linear;\n",
        '    "div\\(phi,.*\\)" Gauss upwind;\n'
        "    div((nuEff*dev2(T(grad(U))))) Gauss linear;\n",
    )
    (case.path / "system/fvSchemes").open("a").write(
        "wallDist { method meshWave; }\n"
    )
    case.replace(
        "system/fvSolution", '"(U|UFinal)"',
        f'"(U|{"|".join(MODELS[model])})(Final)?"',
    )
    case.replace("system/fvSolution", "relTol          1e-3", "relTol 1e-8")
    (case.path / "constant/fvOptions").write_text(
        HEADER.replace("blockMeshDict", "fvOptions") + """
drive
{
    type            vectorSemiImplicitSource;
    selectionMode   all;
    volumeMode      specific;
    injectionRateSuSp { U ((1 0 0) 0); }
}
""")


def solve(
    name, folder, Re, cells, offset=None, walls="wall functions", before="",
    grading=1, dt=0.05, steps=800, ranks=1, model="kOmegaSST",
):
    """Cell centres and velocity in units of the friction velocity. offset: of
    the immersed wall from a face, in cells; None: the wall is a patch."""
    case = BodyCase("cylinder", folder, name)
    (case.path / "system/setExprFieldsDict").unlink()
    h = 1/cells
    immersed = offset is not None
    # The middle stays at 1 to half a cell; U is scaled by the force below it
    low = -(BELOW + offset)*h if immersed else 0
    n = cells + BELOW if immersed else cells
    wall = "below" if immersed else "walls"
    write_mesh(case, [low, (n*h if immersed else 1, n, grading)], wall)
    write_fields(case, wall, walls, model)
    set_model(case, Re, model)
    case.bodies(SLAB if immersed else "", before if immersed else NO_BODY)
    case.controls(
        endTime=f"{steps*dt:g}", deltaT=dt, writeFormat="ascii",
        writeControl="timeStep", writeInterval=steps,
    )
    log = case.solve(ranks)
    if ranks > 1:
        case.run("reconstructPar", "-latestTime")
    ratio = grading**(1/(n - 1)) if n > 1 else 1
    edges = np.r_[0, np.cumsum(ratio**np.arange(n))]
    edges = low + edges/edges[-1]*(n*h if immersed else 1)
    y = 0.5*(edges[1:] + edges[:-1])
    U = case.field("U")[:, 0]/np.sqrt(edges[-1])
    return y, U, case, log
