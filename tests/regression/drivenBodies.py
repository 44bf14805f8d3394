# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies in smooth accelerated motion, to measure the order in time with.

    case, cells, n = disc_case(folder, "disc_40", 40, scheme="Euler")
    case.solve()
    motion(case, 2)["velocity"]
"""

import math

import numpy as np

from bodyCase import BodyCase
from boxMesh import graded

RADIUS, HEIGHT = 0.2, -0.3
SHARE = 0.7     # of a period or turn, where nothing is close to a zero


def set_scheme(case, scheme):
    case.replace("system/fvSchemes", "default backward", f"default {scheme}")


def set_tight(case):
    """Linear tolerances far below what is measured."""
    for old, new in (
        ("1e-8;\n        relTol          0.01", "1e-12; relTol 1e-4"),
        ("1e-9;\n        relTol          1e-3", "1e-13; relTol 1e-5"),
    ):
        case.replace("system/fvSolution", old, new)


def set_flow(case, speed):
    """Tube flow from rest, speed*sin^2(pi t) on the centre line."""
    for file in ("0.orig/U", "0/U"):
        case.replace(
            file, "1.5*(1 - sqr(pos().y()))",
            f"{speed}*(1 - sqr(pos().y()))*sqr(sin({math.pi:.15g}*time()))",
        )
    case.replace("system/setExprFieldsDict", "1.5*(1 - sqr(pos().y()))", "0")


def disc_case(
    folder, name, steps, coupling, scheme="backward", nu=0.1, window=True,
    gravity=False, tight=True,
):
    """A disc of twice the fluid's density off the centre line of a tube,
    free along it and to spin; the flow starts smoothly, with period 1.

    steps: per period. Returns the case, D/h and the number of cells."""
    cells = 8
    h = 2*RADIUS/cells
    way = 0 if window else 0.8
    case = BodyCase("tube", folder, name)
    set_flow(case, 0 if gravity else 1.5)
    set_scheme(case, scheme)
    if tight:
        set_tight(case)
    n = case.mesh(
        graded(-2, 2 + way, (-2*RADIUS, way + 2*RADIUS), h),
        graded(-1, 1, (HEIGHT - 8.2*h, HEIGHT + 7.8*h), h),
    )
    case.replace("constant/transportProperties", "0.5;", f"{nu};")
    if gravity:
        case.gravity(5)
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius {RADIUS}; }}
            densityRatio 2;
            position    (0 {HEIGHT} 0);
            constraints {{ translate (1 0 0); }}
        }}
    """, coupling + (
        " window { type comoving; direction (1 0 0); }" if window else ""
    ))
    case.controls(endTime=f"{SHARE}", deltaT=f"{1/steps:.15g}")
    return case, cells, n


def ellipsoid_case(
    folder, name, steps, coupling, scheme="backward", ratio=1000,
):
    """An ellipsoid with three different axes, so heavy that it tumbles
    almost freely. Returns the case, D/h and the number of cells."""
    case = BodyCase("box", folder, name)
    set_scheme(case, scheme)
    side = graded(-1, 1, (-0.5, 0.5), 0.1, 1.2)
    n = case.mesh(side, side, side)
    (case.path / "constant/g").unlink()
    case.replace("constant/transportProperties", "0.1;", "1e-3;")
    case.bodies(f"""
        ellipsoid
        {{
            shape       {{ type ellipsoid; semiAxes (0.4 0.3 0.25); }}
            densityRatio {ratio};
            position    (0.013 0.021 0.007);
            angularVelocity (1.5 3 0.5);
        }}
    """, coupling)
    case.controls(endTime=f"{2*SHARE}", deltaT=f"{2/steps:.15g}")
    return case, 5, n


def motion(case, every):
    """What a body has done, at the end of each so many steps."""
    table = case.table("motion")
    some = slice(every - 1, None, every)

    def columns(*names):
        return np.array([table[name][some] for name in names]).T

    if case.kind == "box":
        return {
            "orientation": columns("q_w", "q_x", "q_y", "q_z"),
            "spin": columns(*(f"angularVelocity_{c}" for c in "xyz")),
        }
    half_angle = np.arctan2(table["q_z"], table["q_w"])
    return {
        "position": columns("position_x"),
        "velocity": columns("velocity_x"),
        "angle": 2*np.unwrap(half_angle, period=math.pi)[some, None],
        "spin": columns("angularVelocity_z"),
    }


def rms(values):
    return float(np.sqrt(np.mean(np.sum(np.square(values), axis=-1))))


def changes(motions):
    """By quantity: rms change from each motion to the next, relative to its
    own; of angle and spin, to those of a disc that rolls."""
    last = motions[-1]
    scales = {quantity: rms(values) for quantity, values in last.items()}
    if "velocity" in last:
        scales["angle"] = scales["position"]/RADIUS
        scales["spin"] = scales["velocity"]/RADIUS

    return {
        quantity: [
            rms(fine[quantity] - coarse[quantity])/scale
            for coarse, fine in zip(motions, motions[1:])
        ]
        for quantity, scale in scales.items()
    }
