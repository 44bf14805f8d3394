# SPDX-License-Identifier: GPL-3.0-or-later
"""A free ellipse, a free spheroid in simple shear, Stokes flow."""

import math

import boxMesh
import numpy as np

from bodyCase import BodyCase
from boxMesh import graded
from measure import Run, around, set_profile, set_stokes, set_viscosity

ASPECT, SHEAR = 2, 1
PERIOD = 2*math.pi*(ASPECT + 1/ASPECT)/SHEAR
# Small inertia: SHEAR*a^2/nu is 0.04 with the small semi-axis 1
NU = 100
# Time steps per period in 2D, 3D
STEPS = {2: 200, 3: 80}
# To convergence: with ten iterations the angle lags by 3 degrees at D/h 16
COUPLING = "coupling { nOuterCorrectors 40; }"
# Angle from which half a turn is timed
START = 0.1
SIDES = {"inlet": "x-", "outlet": "x+", "walls": "y- y+ z- z+"}


def jeffery(time):
    """Angle that the long axis, along the flow at first, has turned by."""
    phase = 2*math.pi*time/PERIOD
    turns = np.round(phase/math.pi)
    return np.arctan(np.tan(phase)/ASPECT) + turns*math.pi


def jeffery_time(angle):
    """Time to turn by an angle below pi/2."""
    return PERIOD/(2*math.pi)*math.atan(ASPECT*math.tan(angle))


def solve(folder, dims, cells, box, coupling=COUPLING):
    """A case after its run, and the run; box: half its width over the long
    semi-axis."""
    h = 2/cells
    half = box*ASPECT
    name = f"{dims}D_box{box}_D{cells}"
    case = BodyCase("tube", folder, name)
    set_stokes(case)
    set_viscosity(case, NU)
    set_profile(case, "1.5*(1 - sqr(pos().y()))", f"{SHEAR}*pos().y()")
    for file in ("0.orig/U", "0/U"):
        case.replace(file, "{ type noSlip; }", "{ $inlet; }")
    x, y = (
        graded(-half, half, around(0, ASPECT + 5*h, h, offset), h)
        for offset in (0.3, 0.4)
    )
    if dims == 2:
        n = case.mesh(x, y)
        shape = f"type ellipse; semiAxes ({ASPECT} 1);"
    else:
        z = graded(-half, half, around(0, 1 + 5*h, h, 0.2), h)
        n = boxMesh.write(case, x, y, z, SIDES)
        case.run("blockMesh")
        case.run("setExprFields")
        shape = f"type ellipsoid; semiAxes ({ASPECT} 1 1);"
    case.bodies(f"""
        body
        {{
            shape       {{ {shape} }}
            densityRatio 1;
            position    (0 0 0);
            velocity    (0 0 0);
            angularVelocity (0 0 {-SHEAR/(ASPECT**2 + 1)});
        }}
    """, coupling)
    case.controls(
        endTime=f"{0.6*PERIOD:.12g}", deltaT=f"{PERIOD/STEPS[dims]:.12g}"
    )
    return case, Run(case, f"{dims}D box {box} a", cells, n)


def figures(case):
    """Period, and largest angle error [degrees] once the start has died out."""
    motion = case.table("motion")
    time = motion["time"]
    angle = -np.unwrap(2*np.arctan2(motion["q_z"], motion["q_w"]))

    def reach(value):
        return np.interp(value, angle, time)

    start = reach(START)
    period = 2*(reach(START + math.pi) - start)
    after = time > start
    exact = jeffery(time[after] - start + jeffery_time(START))
    error = np.degrees(np.abs(angle[after] - exact).max())
    return period, error


def rows(folder, quick):
    cases = [(2, 8, box) for box in (10, 20)]
    if not quick:
        cases += [(2, 16, box) for box in (10, 20)]
        cases += [(3, 8, box) for box in (3, 4)]
    periods = {}
    for dims, cells, box in cases:
        case, run = solve(folder, dims, cells, box)
        period, error = figures(case)
        yield run.row("period", period, PERIOD)
        yield run.row("angle error, deg", error)
        yield run.row("outer iterations", sum(run.outers)/len(run.outers))

        # The effect of the box goes with its size to the power -dims
        if (dims, cells) in periods:
            other, smaller = periods[dims, cells]
            ratio = (box/smaller)**dims
            run.settings = f"{dims}D without box"
            wide = period + (period - other)/(ratio - 1)
            yield run.row("period", wide, PERIOD)
        periods[dims, cells] = period, box
