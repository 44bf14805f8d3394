# SPDX-License-Identifier: GPL-3.0-or-later
"""Height in a tube at which a free disc has no lift, by Re and density."""

import numpy as np

from bodyCase import BodyCase
from boxMesh import graded
from grainfoam.study import analysis
from measure import DEPTH, Run, around, set_viscosity

RADIUS = 0.065

# Re: |y| without lift, V_x and spin there, end time
REFERENCES = {
    2: (0.48561, 1.140747, -0.724658, 4),
    10: (0.48401, 1.142816, -0.720657, 6),
    20: (0.47670, 1.152854, -0.705601, 12),
    40: (0.43042, 1.215293, -0.628914, 20),
}

# Heights at which the disc is held, from that of the reference
HEIGHTS = (-0.03, 0, 0.03)

# Re, density ratio, D/h
QUICK = ((2, 2, 8), (2, 0.5, 8), (10, 2, 8))
FULL = (
    *((Re, 2, 8) for Re in REFERENCES), (2, 0.5, 8), (2, 1000, 8),
    (2, 2, 16), (10, 2, 16),
)


def hold(folder, Re, ratio, cells, y):
    """Lift, V_x and spin of a disc held at height y, and the run."""
    end, dt = REFERENCES[Re][3], 0.16/cells
    if ratio > 100:
        # Its velocity relaxes in 4 s
        end, dt = 36, 2*dt
    h = 2*RADIUS/cells
    # Growth of 8 % from 4 radii on makes |y| half a percent larger
    core, growth = 6.4*RADIUS, 1.04
    case = BodyCase("tube", folder, f"Re{Re}_r{ratio}_D{cells}_y{y:.4f}")
    n = case.mesh(
        graded(-3, 3, around(0, core, h), h, growth),
        graded(-1, 1, around(y, core, h), h, growth),
    )
    set_viscosity(case, 1/Re)
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius {RADIUS}; }}
            densityRatio {ratio};
            position    (0 {y} 0);
            velocity    ambient;
            constraints {{ translate (1 0 0); }}
        }}
    """, "window { type comoving; direction (1 0 0); }")
    case.controls(endTime=f"{end}", deltaT=f"{dt}")
    run = Run(case, f"Re {Re} density ratio {ratio}", cells, n, may_fail=True)
    if run.failed:
        return None, run
    motion = case.table("motion")
    lift = case.table("forces")["fluidForce_y"]/DEPTH
    speed, spin = motion["velocity_x"], motion["angularVelocity_z"]

    # Change over the last tenth, as a part of the lift 0.03 away
    early = lift[int(0.9*len(lift))]
    return (lift[-1], speed[-1], spin[-1], lift[-1] - early), run


def rows(folder, quick):
    for Re, ratio, cells in QUICK if quick else FULL:
        height, speed, spin, _ = REFERENCES[Re]
        heights, held, cpu = -height + np.array(HEIGHTS), [], 0
        for y in heights:
            values, run = hold(folder, Re, ratio, cells, y)
            cpu += run.cpu
            if run.failed:
                yield run.diverged()
                break
            held.append(values)
        else:
            run.cpu = cpu
            lift, *others, drift = np.array(held).T
            # Of the parabola through the three
            (zero,) = analysis.zeros(heights, lift)
            y = zero.x
            yield run.row("|y| without lift", -y, height)
            for name, values, known in zip(
                ("V_x", "spin"), others, (speed, spin), strict=True
            ):
                there = np.polyval(np.polyfit(heights, values, 2), y)
                yield run.row(f"{name} there", there, known)
            unsteady = 100*abs(drift).max()/np.ptp(lift)
            yield run.row("last change, %", unsteady)
