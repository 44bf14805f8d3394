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


def write_positions(case, points, name="grains"):
    lines = "\n".join(f"({x:.12g} {y:.12g} {z:.12g})" for x, y, z in points)
    (case.path/"constant"/name).write_text(f"(\n{lines}\n)\n")


def lattice(number, length=1, shift=0.37):
    """number^3 places in a cube."""
    side = (np.arange(number) + shift)/number*length
    return np.stack(np.meshgrid(side, side, side, indexing="ij"), -1).reshape(
        -1, 3
    )


def grains(radius, ratio=1, motion="fixed", name="grain"):
    """Entry of `bodies`, with places from constant/grains or constant/name."""
    file = "grains" if name == "grain" else name
    return (
        f"{name} {{ shape {{ type sphere; radius {radius:.17g}; }}"
        f" densityRatio {ratio}; positionsFile \"constant/{file}\";"
        f" motion {{ type {motion}; }} }}"
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


SIDES = {"left": "x-", "right": "x+", "front": "y-", "back": "y+",
         "inlet": "z-", "outlet": "z+"}


def column(
    folder, name, width, height, h, speed, nu, tight=True, slab=None
):
    """A column of width^2 * height cells of size h, along it `slab`, periodic
    across; the fluid enters from below with a speed that is a number or text
    for `uniformValue`."""
    slab = slab or h
    case = BodyCase("tube", folder, name)
    side = uniform(0, width*h, width)
    boxMesh.write(case, side, side, uniform(0, height*slab, height), SIDES)
    case.set_cyclic("left", "right")
    case.set_cyclic("front", "back")
    cyclic = '"left|right|front|back" { type cyclic; }'
    given = (
        f"type fixedValue; value uniform (0 0 {speed});"
        if not isinstance(speed, str) else
        f"type uniformFixedValue; uniformValue {speed};"
    )
    case.conditions(
        f"{cyclic} inlet {{ {given} }} outlet {{ type zeroGradient; }}",
        f"{cyclic} inlet {{ type zeroGradient; }}"
        " outlet { type fixedValue; value uniform 0; }",
    )
    case.run("blockMesh")
    case.replace("constant/transportProperties", "0.5;", f"{nu};")
    if tight:
        solve_tightly(case)
    else:
        case.replace("system/fvSchemes", "backward", "Euler")
    return case


def suspension(folder, phi, ratio, nu, g, drag, cells=6):
    """Free grains, one at the same place in each cell of a periodic cube of
    side 1, under gravity against x, with a force that balances their weight.
    Returns the case and the diameter of the grains."""
    D = (6*phi/np.pi)**(1/3)/cells
    case = periodic_case(
        folder, "suspension", cells, 3, phi*(ratio - 1)*g, by_force=True
    )
    case.replace("0/U", "uniform (1 0 0)", "uniform (0 0 0)")
    case.replace("constant/transportProperties", "0.5;", f"{nu};")
    solve_tightly(case)
    write_positions(case, lattice(cells))
    case.bodies(
        grains(D/2, ratio, "free"),
        f"coupling {{ {COUPLING.format(drag=drag)} }}",
    )
    case.gravity(-g)
    case.controls(
        endTime=20, deltaT=0.5, writeInterval=20, writeFormat="ascii",
        writePrecision=15,
    )
    return case, D


def lone_grain(folder, name, nu, ratio, dense):
    """One grain of a quarter of a cell in the box of moving_box, that moves
    across the fluid at first; dense: with the void fraction."""
    grain = ((ratio, 0.01, (0.52, 0.47, 0.5), (0, 1, 0)),)
    case = grain_box(folder, name, nu)
    solve_tightly(case)
    case.bodies(
        entries(grain),
        "coupling { type unresolved; dragModel { type SchillerNaumann; }"
        f" voidFraction {'yes' if dense else 'no'}; }}",
    )
    relaxation = ratio*(2*0.01)**2/18/nu
    case.controls(endTime=3*relaxation, deltaT=relaxation/20)
    return case


def probe_pressure(case, points):
    """Write the pressure at these points in each time step."""
    places = " ".join("({:.12g} {:.12g} {:.12g})".format(*x) for x in points)
    case.replace(
        "system/controlDict", "functions\n{", f"""functions
{{
    probes
    {{
        type            probes;
        libs            (sampling);
        fields          (p);
        probeLocations  ({places});
    }}""",
    )
    case.controls(writePrecision=15)


def packed_column(folder, D, ratio, nu, g, layers, speed, duration):
    """Spheres of the diameter D in the closest packing, nine per layer, of
    which the lowest six layers are fixed, in a periodic column of three cells
    of their width; the fluid enters from below with a speed that rises linearly
    through the values of `speed`. In each cell grains are at the same places.
    Returns the case, the volume fraction and the height of a cell."""
    grate, pitch = 6, 1.0001*D
    phi, height = np.pi/6*np.sqrt(2)*(D/pitch)**3, np.sqrt(2)*pitch
    cells = (layers + grate)//2 + 10
    low, high = speed
    case = column(
        folder, "column", 3, cells, pitch,
        f"table ((0 (0 0 {low:.9g})) ({duration} (0 0 {high:.9g})))",
        nu, tight=False, slab=height,
    )
    i, k = np.arange(3), np.arange(layers + grate)
    places = np.array([
        ((x + 0.25 + 0.5*(n % 2))*pitch, (y + 0.25 + 0.5*(n % 2))*pitch,
         (n/2 + 4.25)*height) for n in k for x in i for y in i
    ])
    write_positions(case, places[9*grate:])
    write_positions(case, places[:9*grate], "grate")
    case.bodies(
        grains(D/2, ratio, "free") + grains(D/2, name="grate"),
        "contact { type softSphere; collisionTime 5e-4; restitution 0.1;"
        " friction 0.5; } coupling { kernel { cells 1.5; diameters 1.5; }"
        f" minVoidFraction 0.2; {COUPLING.format(drag='Ergun')} }}",
    )
    case.gravity(0, 0, -g)
    middle = ((layers + grate)//4 + 4)*height
    probe_pressure(case, [
        (pitch, pitch, middle + n*height) for n in (-2.5, 2.5)
    ])
    return case, phi, height
