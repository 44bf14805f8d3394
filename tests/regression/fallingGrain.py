# SPDX-License-Identifier: GPL-3.0-or-later
"""A grain that falls along x in air at rest, in a comoving window of equal
cells: rapeseed as in a seed drill."""

import math

import boxMesh
import stream
from bodyCase import BodyCase
from boxMesh import uniform

RHO, MU = 1.2, 1.81e-5          # air [kg/m3], [Pa s]
G = 9.81

PATCHES = {"inlet": "x+", "outlet": "x-", "sides": "y- y+ z- z+"}


def standard_drag(Re):
    """Drag coefficient of a sphere, Clift, Grace & Weber (1978), for Re from
    0.01 to 12 000."""
    w = math.log10(Re)
    if Re <= 20:
        return 24/Re*(1 + 0.1315*Re**(0.82 - 0.05*w))
    if Re <= 260:
        return 24/Re*(1 + 0.1935*Re**0.6305)
    if Re <= 1500:
        return 10**(1.6435 + w*(-1.1242 + w*0.1558))
    return 10**(-2.4571 + w*(2.5558 + w*(-0.9295 + w*0.1049)))


def terminal_velocity(D, rho_p, rho=RHO, mu=MU, drag=standard_drag):
    """Of a sphere [m/s]."""
    V = 1.0
    for _ in range(200):
        Re = rho*V*D/mu
        V = 0.5*(V + math.sqrt(4/3*(rho_p/rho - 1)*G*D/drag(Re)))
    return V


def set_viscosity(case, nu):
    case.replace("constant/transportProperties", "0.5;", f"{nu:.12g};")


def set_upwind(case):
    """Convection without wiggles at high Reynolds numbers of the cells."""
    case.replace(
        "system/fvSchemes", "div(phi,U)          Gauss linear",
        "div(phi,U)          Gauss linearUpwind grad(U)",
    )


def falling_grain(
    folder, name, D, cells, rho_p=1000, start=1.0, courant=4, end=0.3,
    coupling="type unresolved;", grain="", place=(0.1, 0.2, -0.3),
    width=20, ahead=8, behind=24, shape=None,
):
    """A sphere, or another shape, of `cells` cells per diameter D [m] that
    starts with `start` times the terminal velocity; place and sizes of the box
    in cells. Returns the case and its number of cells."""
    h = D/cells
    case = BodyCase("tube", folder, name)
    case.conditions(stream.velocity(0), stream.P)
    across = uniform(-0.5*width*h, 0.5*width*h, width)
    n = boxMesh.write(
        case, uniform(-behind*h, ahead*h, ahead + behind), across, across,
        PATCHES,
    )
    case.run("blockMesh")
    set_viscosity(case, MU/RHO)
    set_upwind(case)
    case.gravity(G)
    case.replace(
        "system/fvSolution", "GAMG;\n        smoother        GaussSeidel",
        "fastPoisson",
    )
    V = terminal_velocity(D, rho_p)
    x, y, z = (h*c for c in place)
    case.bodies(f"""
        grain
        {{
            shape       {{ {shape or f"type sphere; radius {0.5*D:.12g};"} }}
            densityRatio {rho_p/RHO:.12g};
            position    ({x:.12g} {y:.12g} {z:.12g});
            velocity    ({start*V:.12g} 0 0);
            {grain}
        }}
    """, f"""window {{ type comoving; direction (1 0 0); }}
        coupling {{ {coupling} }}""")
    case.controls(endTime=f"{end:.9g}", deltaT=f"{courant*h/V:.9g}")
    return case, n


def falling_dust(folder, name, cells, **settings):
    """A sphere of 60 um, Re = 0.4, for eight of its relaxation times."""
    D = 60e-6
    V = terminal_velocity(D, 1000)
    return falling_grain(
        folder, name, D, cells, courant=2, end=8*V/G + 20*D/cells/V,
        width=30, ahead=15, behind=30, **settings,
    )


def limit(values):
    """Where a relaxation leads to, from three values at equal intervals
    (Aitken)."""
    n = (len(values) - 1)//4
    a, b, c = (values[-1 - 2*n], values[-1 - n], values[-1])
    return c - (c - b)**2/((c - b) - (b - a))
