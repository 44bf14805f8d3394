# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag of a cylinder in a channel, where the viscosity is not uniform."""

import dfgChannel
from dfgChannel import DIAMETER
from measure import DEPTH, Run
from peers.bodyFitted import FittedCase

# Fluid: mean speed, drag coefficient
FLUIDS = {
    "uniform": (0.2, 5.57953523384),
    "shear-thinning": (0.2, 9.359),
    "shear-thickening": (0.2, 6.629),
}
COEFFICIENTS = {
    "uniform": "nu0 1e-3; nuInf 1e-3; k 1; n 1;",
    "shear-thinning": "nu0 5e-3; nuInf 5e-4; k 1; n 0.5;",
    "shear-thickening": "nu0 5e-4; nuInf 0; k 1; n 1.5;",
}


def set_fluid(case, fluid):
    """Transport of the fluid."""
    case.replace(
        "constant/transportProperties", "Newtonian;",
        f"BirdCarreau;\nBirdCarreauCoeffs {{ {COEFFICIENTS[fluid]} }}\n",
    )


def figures(result, fluid, drag):
    speed, reference = FLUIDS[fluid]
    yield result.row("C_D", 2*drag/(speed**2*DIAMETER), reference)


def fitted(folder, fluid, n):
    """Rows of simpleFoam on a mesh fitted to the cylinder."""
    case = FittedCase(folder, f"{fluid}_fitted{n}", n)
    set_fluid(case, fluid)
    result = case.solve("simpleFoam", fluid)
    if result:
        yield from figures(result, fluid, case.history()[1][-1])


def immersed(folder, fluid, cells, model="exponential"):
    """Rows of our solver."""
    settings = fluid
    if model != "exponential":
        settings = f"{fluid} {model}"
    speed = FLUIDS[fluid][0]
    name = f"{settings.replace(' ', '_')}_D{cells}"
    case, n = dfgChannel.make(folder, name, cells, speed)
    set_fluid(case, fluid)
    case.replace(
        "system/fvSchemes", "    default             none;\n",
        "    default             none;\n"
        "    div((nuEff*dev2(T(grad(U))))) Gauss linear;\n",
    )
    case.bodies("""
        cylinder
        {
            shape       { type disc; radius 0.05; }
            position    (0.2 0.2 0);
            motion      { type fixed; }
        }
    """, f"steady {{}}\nresistance {{ type {model}; }}")
    case.controls(
        endTime=f"{8/speed:g}", deltaT=f"{0.2/speed/cells:.6g}"
    )
    run = Run(case, settings, cells, n, may_fail=True)
    if run.failed:
        yield run.diverged()
        return
    force = case.table("forces")["fluidForce_x"][-1]
    yield from figures(run, fluid, force/DEPTH)


def rows(folder, quick):
    for fluid in FLUIDS:
        for n in (24,) if quick else (24, 48):
            yield from fitted(folder, fluid, n)
        for cells in (10, 20):
            yield from immersed(folder, fluid, cells)
            yield from immersed(folder, fluid, cells, "distanceWeighted")
        if not quick:
            yield from immersed(folder, fluid, 40)
