# SPDX-License-Identifier: GPL-3.0-or-later
"""kOmegaSST for the channel with a cylinder, without wall functions that
bridge the layers at walls."""

from boxMesh import HEADER

NU = 5e-5
# At the inlet: nut of 50 nu
K, OMEGA = 0.05, 20
BETA1 = 0.075

FIELDS = {
    "k": ("0 2 -2 0 0 0 0", K, "fixedValue; value uniform 1e-12"),
    "omega": ("0 0 -1 0 0 0 0", OMEGA,
              f"omegaWallFunction; value uniform {OMEGA}"),
    "nut": ("0 2 -1 0 0 0 0", K/OMEGA,
            "nutLowReWallFunction; value uniform 0"),
}
MODEL = """simulationType RAS;
RAS { RASModel kOmegaSST; turbulence on; printCoeffs off; }
"""


def header(kind, name):
    return HEADER.replace("dictionary", kind).replace("blockMeshDict", name)


def set_model(case, body=""):
    """kOmegaSST at high Re; body: its patch, if the mesh has one."""
    case.replace("constant/transportProperties", "1e-3;", f"{NU};")
    case.replace(
        "constant/turbulenceProperties", "simulationType  laminar;", MODEL
    )
    walls = f"walls|{body}" if body else "walls"
    for name, (dimensions, value, wall) in FIELDS.items():
        inlet = (f"calculated; value uniform {value}" if name == "nut"
                 else f"fixedValue; value uniform {value}")
        outlet = (f"calculated; value uniform {value}" if name == "nut"
                  else "zeroGradient")
        (case.path / "0" / name).write_text(
            header("volScalarField", name) + f"""
dimensions [{dimensions}];
internalField uniform {value};
boundaryField
{{
    inlet {{ type {inlet}; }}
    outlet {{ type {outlet}; }}
    "({walls})" {{ type {wall}; }}
    frontAndBack {{ type empty; }}
}}
""")
    case.replace(
        "system/fvSchemes", "    div(phi,U)          Gauss linear;\n",
        "    div(phi,U)          Gauss linearUpwind grad(U);\n"
        '    "div\\(phi,(k|omega)\\)" Gauss limitedLinear 1;\n',
    )
    (case.path / "system/fvSchemes").open("a").write(
        "wallDist { method meshWave; }\n"
    )
    case.replace(
        "system/fvSolution", '"(U|UFinal)"', '"(U|k|omega)(Final)?"'
    )
