# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocity, spin and lift of a free disc between rough walls, and the height
at which it has no lift."""

import numpy as np

from bodyCase import BodyCase
from boxMesh import graded, uniform
from measure import DEPTH, Run, around

RADIUS = 0.065
NU = 0.5

# a, y: V_x, spin, lift in viscous units
REFERENCES = {
    (1, -0.3): (1.09039061, -0.11210406, -1.617002e-4),
    (1, -0.5): (1.03020273, -0.18625272, 5.060003e-6),
    (100, -0.3): (1.35077741, -0.43560681, -1.975803e-3),
    (100, -0.5): (1.11582073, -0.72430746, 2.009749e-4),
}

# a: |y| without lift
HEIGHTS = {0.1: 0.461, 1: 0.497, 10: 0.510, 100: 0.490}


def set_walls(case, a):
    """Rough walls, and their profile at the ends and at the start."""
    # Mean speed 1 in the closed form of tubeFlow
    B = a/(2 + 2*a/3)
    case.controls(libs="(grainFvPatchFields)")
    case.replace(
        "system/setExprFieldsDict", "1.5*(1 - sqr(pos().y()))",
        f"{1 + B/3:.15g} - {B:.15g}*sqr(pos().y())",
    )
    path = case.path / "0/U"
    head = path.read_text().split("boundaryField", 1)[0]
    path.write_text(f"""{head}boundaryField
{{
    inlet
    {{
        type        tubeProfile;
        meanVelocity 1;
        axis        (1 0 0);
        a           {a};
    }}
    outlet          {{ $inlet; }}
    walls           {{ type robinVelocity; a {a}; }}
    frontAndBack    {{ type empty; }}
}}
""")


def solve(folder, a, y, cells):
    """Last V_x, spin and lift, and the run."""
    h = 2*RADIUS/cells
    case = BodyCase("tube", folder, f"a{a}_y{y:.4f}_D{cells}")
    set_walls(case, a)
    n = case.mesh(
        graded(-3, 3, around(0, 6.4*RADIUS, h), h, 1.04),
        uniform(-1, 1, round(2/h)),
    )
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius {RADIUS}; }}
            densityRatio 2;
            position    (0 {y} 0);
            velocity    ambient;
            constraints {{ translate (1 0 0); }}
        }}
    """, "window { type comoving; direction (1 0 0); }")
    case.controls(endTime="4", deltaT=f"{0.16/cells}")
    run = Run(case, f"a {a} y {y:.4g}", cells, n, may_fail=True)
    if run.failed:
        return None, run
    motion, forces = case.table("motion"), case.table("forces")
    return (
        motion["velocity_x"][-1], motion["angularVelocity_z"][-1],
        forces["fluidForce_y"][-1]/DEPTH,
    ), run


def height(folder, a, cells):
    """Row of the height without lift."""
    heights, lifts, cpu = -HEIGHTS[a] + np.array((-0.03, 0, 0.03)), [], 0
    for y in heights:
        values, run = solve(folder, a, y, cells)
        cpu += run.cpu
        if run.failed:
            return run.diverged()
        lifts.append(values[2])
    run.cpu, run.settings = cpu, f"a {a}"
    # Zero of the parabola through the three, next to the middle one
    roots = np.roots(np.polyfit(heights, lifts, 2)).real
    y = roots[np.argmin(abs(roots - heights[1]))]
    return run.row("|y| without lift", -y, HEIGHTS[a])


def rows(folder, quick):
    for cells in (8,) if quick else (8, 16):
        for (a, y), (speed, spin, lift) in REFERENCES.items():
            values, run = solve(folder, a, y, cells)
            if run.failed:
                yield run.diverged()
                continue
            yield run.row("V_x", values[0], speed)
            yield run.row("spin", values[1], spin)
            # Next to the height without lift it is nearly zero
            scale = abs(REFERENCES[a, -0.3][2])
            error = 100*(values[2]/NU - lift)/scale
            yield run.row("lift", values[2], lift*NU, error)
    for a in (1,) if quick else HEIGHTS:
        yield height(folder, a, 8)
