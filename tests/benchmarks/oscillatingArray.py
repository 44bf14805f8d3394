# SPDX-License-Identifier: GPL-3.0-or-later
"""A simple cubic array of spheres, one in a cube of side 1 that repeats itself,
in Stokes flow in which either the fluid or the spheres oscillate, and the fit
of drag and added mass (closureFit).

    array = Array(fraction=0.2, cells=8, layer=0.1)
    case = array.case(tmp_path, "fluid", steps=160)
    case.solve()
    row = fitted(case)      # at the end: {column: value}
"""

import math

import periodicTube
import potentialFlow
from foamCase import tables
from measure import LOCKED, set_direct, set_stokes, set_viscosity
from periodicBox import FLOW_RATE, periodic_case

# Largest velocity [m/s], nu [m2/s]; periods, and the first that is fitted
SPEED, NU = 0.01, 1
PERIODS, FIRST = 3, 2

SINE = """
    {{
        type        sine;
        amplitude   {speed:.15g};
        frequency   {frequency:.15g};
        scale       {direction};
        level       {zero};
    }}
"""
FIT = """
    closure
    {{
        type            closureFit;
        libs            (immersedBodyFunctionObjects);
        writePrecision  15;
        start           {start:.15g};
        {entries}
    }}
"""


class Array:
    """Spheres of about this many cells per diameter, and an oscillation whose
    viscous layer, sqrt(2 nu/omega), is so many diameters thick."""

    def __init__(self, fraction, cells, layer):
        self.fraction = fraction
        self.diameter = (6*fraction/math.pi)**(1/3)
        self.n = round(cells/self.diameter)
        self.D_over_h = round(self.diameter*self.n, 2)
        self.layer = layer
        self.omega = 2*NU/(layer*self.diameter)**2
        self.period = 2*math.pi/self.omega

    def case(self, folder, moves, steps, entries=""):
        """moves: `fluid` or `spheres`; time steps per period; entries of the
        fit."""
        case = periodic_case(
            folder, f"{moves}_n{self.n}_{self.layer:g}_{steps}", self.n, 3, 0,
            by_force=True,
        )
        case.replace("system/controlDict", FLOW_RATE, "")
        case.replace("0/U", "uniform (1 0 0)", "uniform (0 0 0)")
        wave = dict(speed=SPEED, frequency=1/self.period)
        options = case.path/"constant/fvOptions"
        if moves == "fluid":
            sine = SINE.format(**wave, direction=1, zero=0)
            options.write_text(periodicTube.FLOW_RATE.format(speed=1).replace(
                "meanVelocity    1;", f"meanVelocity{sine}"))
            motion = LOCKED
        else:
            sine = SINE.format(**wave, direction="(1 0 0)", zero="(0 0 0)")
            options.unlink()
            motion = f"motion {{ type prescribed; velocity{sine} }}"
        case.bodies(f"""
            sphere
            {{
                shape {{ type sphere; radius {0.5*self.diameter:.15g}; }}
                position (0.02 0.03 0.01);
                {motion}
            }}
        """)
        set_stokes(case)
        set_direct(case)
        set_viscosity(case, NU)
        case.replace(
            "system/controlDict", "functions\n{", "functions\n{" + FIT.format(
                start=FIRST*self.period, entries=entries),
        )
        case.controls(
            endTime=f"{PERIODS*self.period:.15g}",
            deltaT=f"{self.period/steps:.15g}",
        )
        return case

    def potential(self):
        """C_a of potential flow; drag [1/s] and C_a with a thin layer (Johnson,
        Koplik & Dashen 1987)."""
        s, length = potentialFlow.solve(self.fraction)
        eps = 1 - self.fraction
        share = self.layer*self.diameter/length

        def added_mass(tortuosity):
            return eps/self.fraction*(tortuosity - 1)
        return (
            added_mass(eps/s), eps*eps/s*self.omega*share,
            added_mass(eps/s*(1 + share)),
        )


def fitted(case, layer=0):
    """The last row of a layer; 0: of the whole box."""
    columns = tables.run_columns(case.path, "closure", "closureFit")
    rows = columns["layer"] == layer
    return {name: values[rows][-1] for name, values in columns.items()}
