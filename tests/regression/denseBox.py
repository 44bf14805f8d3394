# SPDX-License-Identifier: GPL-3.0-or-later
"""Unresolved grains whose volume is part of the equations of the fluid, in
periodic boxes and in columns that fluid enters from below."""

import numpy as np

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform
from periodicBox import periodic_case
from unresolvedBox import entries, grain_box

COUPLING = "type unresolved; voidFraction yes; dragModel {{ type {drag}; }}"
TIGHT = """solver          PCG;
        preconditioner  DIC;
        tolerance       1e-16;
        relTol          0;
        maxIter         2000;"""


def ergun(Re, phi):
    """Drag over that of Stokes, of Ergun (1952); Re with the superficial
    velocity."""
    return (150*phi + 1.75*Re)/(18*(1 - phi)**3)


def gidaspow(Re, phi):
    """Of Gidaspow (1994): Ergun below a void fraction of 0.8, else Wen & Yu
    (1966), for Re below 1000."""
    if phi > 0.2:
        return ergun(Re, phi)
    return (1 + 0.15*Re**0.687)*(1 - phi)**-4.65


def drag_force(K, W, D, nu, phi):
    """Of one grain, over the density of the fluid [m4/s2]."""
    return 3*np.pi*nu*D*W*K(W*D/nu, phi)


def solve_tightly(case):
    """Equations to rounding, Euler."""
    path = case.path/"system/fvSolution"
    head, tail = path.read_text().split('"(p|pFinal)"', 1)
    tail = tail[tail.index('"(U|UFinal)"'):]
    tail = tail.replace("1e-9;", "1e-16;").replace("1e-3;", "0;")
    path.write_text(
        f'{head}"(p|pFinal)"\n    {{\n        {TIGHT}\n    }}\n    {tail}'
    )
    case.replace("system/fvSchemes", "backward", "Euler")


def write_positions(case, points):
    lines = "\n".join(f"({x:.12g} {y:.12g} {z:.12g})" for x, y, z in points)
    (case.path/"constant/grains").write_text(f"(\n{lines}\n)\n")


def lattice(number, length=1, shift=0.37):
    """number^3 places in a cube."""
    side = (np.arange(number) + shift)/number*length
    return np.stack(np.meshgrid(side, side, side, indexing="ij"), -1).reshape(
        -1, 3
    )


def grains(radius, ratio=1, motion="fixed", extra=""):
    """Entry of `bodies`."""
    return (
        f"grain {{ shape {{ type sphere; radius {radius:.12g}; }}"
        f" densityRatio {ratio}; positionsFile \"constant/grains\";"
        f" motion {{ type {motion}; }} {extra} }}"
    )


def bed(folder, phi, nu, K, drag, cells=6):
    """Fixed grains, one at the same place in each cell of a periodic cube of
    side 1, and the force at which the superficial speed should be one."""
    D = (6*phi/np.pi)**(1/3)/cells
    force = cells**3*drag_force(K, 1, D, nu, phi)
    case = periodic_case(folder, "bed", cells, 3, force, by_force=True)
    case.replace("constant/transportProperties", "0.5;", f"{nu};")
    solve_tightly(case)
    write_positions(case, lattice(cells))
    case.bodies(grains(D/2), f"coupling {{ {COUPLING.format(drag=drag)} }}")
    return case


# Density ratio, radius, position, velocity; kernels of some overlap, the first
# is on the boundary of the box and of two processors
MOVING = (
    (2.5, 0.06, (0.5, 0.5, 0.98), (3, 0, 0)),
    (0.1, 0.08, (0.3, 0.6, 0.5), (0, 1, -2)),
    (1, 0.08, (0.7, 0.2, 0.6), (0, 1, -2)),
    (40, 0.07, (0.45, 0.25, 0.3), (0.3, 0.5, 0.2)),
    (1000, 0.08, (0.65, 0.75, 0.36), (0.3, -0.5, 0.2)),
)


def moving_box(folder, name="box", nu=0.5, drag="Gidaspow"):
    """12^3 cells of side 1 with a fluid that moves along x, at a speed of 1,
    and grains that move through it. All steps are written."""
    case = grain_box(folder, name, nu)
    solve_tightly(case)
    case.bodies(
        entries(MOVING), f"coupling {{ {COUPLING.format(drag=drag)} }}"
    )
    case.controls(
        endTime=0.2, deltaT=0.02, writeControl="timeStep", writeInterval=1,
        writeFormat="ascii", writePrecision=17,
    )
    return case


def steps(case):
    """Of a run in ascii that starts from zero: names of the times."""
    return case.times()[1:]
