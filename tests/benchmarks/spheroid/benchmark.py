# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag of a spheroid of aspect ratio 2.5: resolved, exact in Stokes flow, and
by the laws for grains that are not resolved."""

import math

import boxMesh
import stream
from bodyCase import BodyCase
from boxMesh import graded, uniform
from fallingGrain import standard_drag
from measure import (
    LOCKED, Result, Run, around, set_direct, set_stokes, set_viscosity,
)
from periodicBox import periodic_case, superficial_speed

ASPECT = 2.5
# Axis along the stream, across it: f = F/(6 pi mu a U) in Stokes flow, a of the
# sphere of the same volume
STOKES = {"along": 0.961568, "across": 1.146631}
REYNOLDS = (1, 10, 50)
LAWS = ("ellipsoid", "Zastawny", "sphericity")
# Of the box, in diameters of that sphere
SIDE, UPSTREAM, DOWNSTREAM = 8, 8, 12


def shape(direction, radius):
    """Entries of the spheroid with its axis along x or along y, or of the
    sphere of its volume."""
    if direction == "sphere":
        return f"type sphere; radius {radius};"
    b = radius/ASPECT**(1/3)
    semi = [b, b, b]
    semi[0 if direction == "along" else 1] = ASPECT*b
    return "type ellipsoid; semiAxes ({:.12g} {:.12g} {:.12g});".format(*semi)


def alone(drag, ratio):
    """F/(6 pi mu a U) without the neighbours of a cubic array of side L
    (Hasimoto 1959), from that with them; ratio: a/L."""
    return 1/(1/drag + 2.8373*ratio - 4.19*ratio**3 + 27.4*ratio**6)


def in_stokes_flow(folder, direction, n, D_over_h, steps=60):
    """The run in a periodic cube of side 1 and n^3 cells, and f."""
    a, h = 0.5*D_over_h/n, 1/n
    scale = 6*math.pi*a
    case = periodic_case(folder, f"{direction}_n{n}", n, 3, scale)
    set_stokes(case)
    set_viscosity(case, 1)
    place = "({:.12g} {:.12g} {:.12g})".format(
        *(0.5 + s*h for s in (0.3, 0.4, 0.2)))
    case.bodies(
        f"body {{ shape {{ {shape(direction, a)} }} position {place};"
        f" {LOCKED} }}"
    )
    dt = 200*h**2
    case.controls(endTime=f"{steps*dt:.12g}", deltaT=f"{dt:.12g}")
    run = Run(case, f"{direction}, Re 0", D_over_h, n**3)
    drag = 1/superficial_speed(case)
    # What is left falls as one over the number of steps
    return run, alone(2*drag[-1] - drag[len(drag)//2 - 1], a)


def resolved(folder, direction, Re, D_over_h):
    """The run in a stream of speed 1, D = 1, a quarter of the box between two
    planes of symmetry, and f."""
    h = 1/D_over_h
    case = BodyCase("tube", folder, f"{direction}_Re{Re}_D{D_over_h}")
    core = ASPECT**(2/3)/2 + 2*h
    across = graded(0, SIDE/2, (0, math.ceil(core/h)*h), h)
    n = boxMesh.write(
        case, graded(-UPSTREAM, DOWNSTREAM, around(0, core + h, h), h),
        across, across, {"inlet": "x-", "outlet": "x+", "sides": "y+ z+",
                         "south": "y-", "middle": "z-"},
    )
    case.conditions(stream.velocity(1), stream.P)
    case.set_symmetry("south")
    case.set_symmetry("middle")
    case.run("blockMesh")
    set_viscosity(case, 1/Re)
    set_direct(case)
    case.bodies(
        f"body {{ shape {{ {shape(direction, 0.5)} }} position (0 0 0);"
        " motion { type fixed; } }", "steady {}",
    )
    case.controls(endTime="100", deltaT="0.1")
    run = Run(case, f"{direction}, Re {Re}", D_over_h, n)
    force = case.table("forces")["fluidForce_x"][-1]
    return run, force/(3*math.pi/Re)


def by_law(folder, direction, Re, law):
    """f of a spheroid that is not resolved, held in a frozen stream; D = 1."""
    case = BodyCase("tube", folder, f"{law}_{direction}_Re{Re}")
    case.conditions(stream.velocity(1), stream.P)
    side = uniform(-8, 8, 8)
    boxMesh.write(case, side, side, side,
                  {"inlet": "x-", "outlet": "x+", "sides": "y- y+ z- z+"})
    case.replace("0/U", "uniform (0 0 0);", "uniform (1 0 0);")
    case.run("blockMesh")
    set_viscosity(case, 1/Re)
    case.bodies(
        f"body {{ shape {{ {shape(direction, 0.5)} }} position (0 0 0);"
        f" densityRatio 1e6; {LOCKED} }}",
        "coupling { type unresolved; fluid frozen;"
        f" shapeModel {{ type {law}; }} }}",
    )
    case.controls(endTime="0.002", deltaT="0.001")
    case.solve()
    return case.table("forces")["fluidForce_x"][-1]/(3*math.pi/Re)


def rows(folder, quick):
    for direction, exact in STOKES.items():
        for n, cells in ((32, 7),) if quick else ((32, 7), (48, 10.5)):
            run, drag = in_stokes_flow(folder, direction, n, cells)
            yield run.row("f", drag, exact)
        yield Result(f"{direction}, Re 1e-6, law ellipsoid", 0, 0).row(
            "f", by_law(folder, direction, 1e-6, "ellipsoid"), exact)
    for Re in REYNOLDS[1:] if quick else REYNOLDS:
        # What box and mesh do to a sphere
        run, drag = resolved(folder, "sphere", Re, 8 if quick else 12)
        yield run.row("f", drag, Re/24*standard_drag(Re))
        for direction in STOKES:
            run, drag = resolved(folder, direction, Re, 8 if quick else 12)
            yield run.row("f", drag)
            for law in LAWS:
                result = Result(f"{direction}, Re {Re}, law {law}", 0, 0)
                yield result.row(
                    "f", by_law(folder, direction, Re, law), drag)
