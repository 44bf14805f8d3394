# SPDX-License-Identifier: GPL-3.0-or-later
"""Unresolved grains in a box that repeats itself in all directions."""

import numpy as np

from periodicBox import FLOW_RATE, periodic_case

MOMENTUM = """
    momentum
    {
        type            volFieldValue;
        libs            (fieldFunctionObjects);
        operation       volIntegrate;
        fields          (U);
        writeFields     false;
        log             false;
        writePrecision  16;
    }
"""

# Density ratio, radius, position, velocity; the first is on the boundary of
# the box and of two processors
GRAINS = (
    (2.5, 0.03, (0.5, 0.5, 0.98), (3, 0, 0)),
    (0.1, 0.04, (0.3, 0.5, 0.5), (0, 1, -2)),
    (1, 0.04, (0.7, 0.2, 0.6), (0, 1, -2)),
    (40, 0.035, (0.45, 0.25, 0.3), (0.3, 1, 0.2)),
)


def entries(grains=GRAINS):
    """Of `bodies`."""
    return "\n".join(
        f"grain{i} {{ shape {{ type sphere; radius {R}; }}"
        f" densityRatio {r}; position ({x[0]} {x[1]} {x[2]});"
        f" velocity ({v[0]} {v[1]} {v[2]}); angularVelocity (0 0 5); }}"
        for i, (r, R, x, v) in enumerate(grains)
    )


def grain_box(folder, name="box", nu=0.5, scheme="backward", coupling=""):
    """12^3 cells of side 1 with a fluid that moves along x, at a speed of 1."""
    case = periodic_case(folder, name, 12, 3, 0, by_force=True)
    (case.path / "constant/fvOptions").unlink()
    case.replace("system/controlDict", FLOW_RATE, MOMENTUM)
    case.replace("constant/transportProperties", "0.5;", f"{nu};")
    case.replace("system/fvSchemes", "backward", scheme)
    case.replace(
        "system/fvSolution", "GAMG;\n        smoother        GaussSeidel",
        "fastPoisson",
    )
    case.replace(
        "system/fvSolution",
        "tolerance       1e-9;\n        relTol          1e-3;",
        "tolerance       1e-16;\n        relTol          0;"
        "\n        maxIter         200;",
    )
    case.bodies(entries(), f"coupling {{ type unresolved; {coupling} }}")
    case.controls(endTime=0.4, deltaT=0.02)
    return case


def velocities(case, body):
    motion = case.table("motion", body)
    return np.stack([motion[f"velocity_{k}"] for k in "xyz"], axis=1)


def momentum(case, grains=GRAINS):
    """Of fluid and grains, over the fluid's density, by time step: that of the
    fluid in the whole box, and what the grains have beyond that."""
    total = case.read_dat("postProcessing/momentum/0/volFieldValue.dat")[:, 1:]
    for i, (ratio, radius, _, _) in enumerate(grains):
        volume = 4/3*np.pi*radius**3
        total = total + (ratio - 1)*volume*velocities(case, i)
    return total


def tenneti(Re, phi):
    """Drag over that of Stokes, of Tenneti, Garg & Subramaniam (2011)."""
    e = 1 - phi
    return (
        (1 + 0.15*Re**0.687 + 5.81*phi)/e**3 + 0.48*phi**(1/3)/e**4
        + phi**3*Re*(0.95 + 0.61*phi**3/e**2)
    )


def bed(folder, phi, nu, number):
    """A lattice of number^3 grains that are fixed, volume fraction phi, and the
    force at which the superficial speed should be one."""
    D = (6*phi/np.pi)**(1/3)/number
    force = number**3*3*np.pi*nu*D*tenneti(D/nu, phi)
    case = periodic_case(folder, "bed", 12, 3, force, by_force=True)
    case.replace("constant/transportProperties", "0.5;", f"{nu};")
    case.replace(
        "system/fvSolution", "GAMG;\n        smoother        GaussSeidel",
        "fastPoisson",
    )
    side = (np.arange(number) + 0.37)/number
    lines = "\n".join(
        f"({x:.9g} {y:.9g} {z:.9g})" for x in side for y in side for z in side
    )
    (case.path/"constant/grains").write_text(f"(\n{lines}\n)\n")
    case.bodies(
        f"grain {{ shape {{ type sphere; radius {D/2:.12g}; }}"
        ' positionsFile "constant/grains"; motion { type fixed; } }',
        "coupling { type unresolved; dragModel { type Tenneti; } }",
    )
    case.controls(endTime=0.3, deltaT=0.02)
    return case
