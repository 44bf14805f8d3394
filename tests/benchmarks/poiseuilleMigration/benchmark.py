# SPDX-License-Identifier: GPL-3.0-or-later
"""Height at which a neutrally buoyant disc goes along in plane Poiseuille
flow."""

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform
from measure import Run, set_direct, set_viscosity
from periodicBox import FORCE

# Pan & Glowinski 2002, in s and cm, with H = 1
GRADIENT, NU, DIAMETER = 2.337e-4, 1/2334, 0.25
HEIGHT = 0.2723
PROFILE = f"{GRADIENT/(2*NU):.12g}*pos().y()*(1 - pos().y())"
FASTEST = GRADIENT/(8*NU)

SIDES = {"left": "x-", "right": "x+", "walls": "y- y+"}
BOUNDARY = """
    "left|right" {{ type cyclic; }}
    walls {{ type {walls}; }}
    frontAndBack {{ type empty; }}
"""
FRAMES = {
    "mesh": "", "window": "window { type comoving; direction (1 0 0); }",
}

# Of the fastest fluid
COURANT = 0.5

# D/h, height at the start, end time
QUICK = ((8, 0.27, 1500),)
FULL = ((8, 0.27, 1500), (8, 0.4, 3000), (16, 0.27, 1500))


def make_case(folder, name, cells):
    """A periodic square with the undisturbed flow, and its number of cells."""
    case = BodyCase("tube", folder, name)
    side = uniform(0, 1, round(cells/DIAMETER))
    n = boxMesh.write(case, side, side, None, SIDES)
    case.set_cyclic("left", "right")
    case.run("blockMesh")
    case.conditions(
        BOUNDARY.format(walls="noSlip"), BOUNDARY.format(walls="zeroGradient")
    )
    case.replace(
        "system/setExprFieldsDict", "1.5*(1 - sqr(pos().y()))", PROFILE
    )
    case.run("setExprFields")
    (case.path / "constant/fvOptions").write_text(FORCE.format(force=GRADIENT))
    set_viscosity(case, NU)
    set_direct(case)
    return case, n


def solve(folder, cells, height, end, frame):
    """Height and speed in time, and the run."""
    settings = f"from {height} {frame}"
    case, n = make_case(
        folder, f"{settings.replace(' ', '_')}_D{cells}", cells
    )
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius {0.5*DIAMETER}; }}
            densityRatio 1;
            position    (0.5 {height} 0);
            velocity    ambient;
            angularVelocity ambient;
        }}
    """, FRAMES[frame])
    dt = COURANT*DIAMETER/cells/FASTEST
    case.controls(endTime=f"{end}", deltaT=f"{dt:.6g}")
    run = Run(case, settings, cells, n, may_fail=True)
    return None if run.failed else case.table("motion"), run


def rows(folder, quick):
    for cells, height, end in QUICK if quick else FULL:
        for frame in FRAMES:
            motion, run = solve(folder, cells, height, end, frame)
            if run.failed:
                yield run.diverged()
                continue
            y, time = motion["position_y"], motion["time"]/end
            # Crossing cells makes the height waver
            late = time > 0.95
            before = y[(time > 0.85) & (time < 0.9)].mean()
            yield run.row("height/H", y[late].mean(), HEIGHT)
            yield run.row("last change/H", y[late].mean() - before)
            yield run.row("wavers, rms/H", y[late].std())
            yield run.row("speed, cm/s", motion["velocity_x"][late].mean())
            yield run.row("outer iterations", sum(run.outers)/run.steps)
