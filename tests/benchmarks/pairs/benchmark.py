# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocities of two free discs in a tube, Stokes flow."""

import math

from bodyCase import BodyCase
from boxMesh import graded
from measure import Run, set_profile, set_stokes

RADIUS = 0.065
# Half distance, height of the midpoint, angle: V_x, V_y, spin of either disc
PAIRS = {
    "0.3 0 45": (0.3, 0, math.pi/4, (
        (1.426699303, -1.936253282e-3, -0.3177311769),
        (1.426699302, -1.936252855e-3, 0.3177311504),
    )),
    "0.2 -0.64 28.6": (0.2, -0.64, 0.5, (
        (0.6819567082, 1.644193352e-5, -1.058935066),
        (1.031813449, -2.977180160e-3, -0.7888956142),
    )),
}
# Of the flow: small, so that the discs stay where they are meanwhile
SPEED = 1e-4
END, STEP = 6, 0.05


def around(low, high, margin, h, offset):
    """Core of cells of size h from low to high and beyond by the margin,
    shifted by offset cells."""
    n = math.ceil((high - low + 2*margin)/h)
    start = 0.5*(low + high) - (0.5*n + offset)*h
    return start, start + n*h


def solve(folder, name, cells):
    a, height, angle, _ = PAIRS[name]
    h = 2*RADIUS/cells
    margin, growth = (4*RADIUS, 1.08) if cells < 16 else (5*RADIUS, 1.05)
    x, y = a*math.cos(angle), a*math.sin(angle)
    along = around(-x, x, margin, h, 0.3)
    across = around(height - y, height + y, margin, h, 0.4)
    # Not beyond the plates
    across = max(across[0], -1), min(across[1], 1)
    case = BodyCase("tube", folder, f"{name.replace(' ', '_')}_D{cells}")
    set_stokes(case)
    set_profile(
        case, "1.5*(1 - sqr(pos().y()))", f"{1.5*SPEED}*(1 - sqr(pos().y()))"
    )
    n = case.mesh(
        graded(-3, 3, along, h, growth), graded(-1, 1, across, h, growth)
    )
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius {RADIUS}; }}
            densityRatio 2;
            positions
            (
                ({-x:.12g} {height - y:.12g} 0) ({x:.12g} {height + y:.12g} 0)
            );
            velocity    ambient;
        }}
    """)
    case.controls(endTime=f"{END}", deltaT=f"{STEP}")
    return case, Run(case, name, cells, n)

def rows(folder, quick):
    for name, (_, _, _, references) in PAIRS.items():
        # Across the tube they may hardly move
        scale = max(abs(V_y) for _, V_y, _ in references)
        for cells in (8, 16) if quick else (8, 16, 24):
            case, run = solve(folder, name, cells)
            for body, (V_x, V_y, spin) in enumerate(references):
                disc = f"of disc {body + 1}"
                motion = case.table("motion", body)
                yield run.row(
                    f"V_x {disc}", motion["velocity_x"][-1]/SPEED, V_x
                )
                value = motion["velocity_y"][-1]/SPEED
                yield run.row(
                    f"V_y {disc}", value, V_y, 100*(value - V_y)/scale
                )
                yield run.row(
                    f"spin {disc}", motion["angularVelocity_z"][-1]/SPEED,
                    spin,
                )
