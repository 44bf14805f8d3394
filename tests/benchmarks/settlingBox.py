# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres in a triply periodic box without net volume flux. D = 1, gravity
along x."""

import numpy as np

from measure import set_box, set_viscosity
from periodicBox import periodic_case
from periodicTube import FLOW_RATE


def random_centres(number, side, gap, seed, clear=0):
    """Places in a periodic box, with a smallest gap between surfaces; side: of
    a cube, or three; clear: smallest distance of centres from the two sides
    across y."""
    random = np.random.default_rng(seed)
    side = np.broadcast_to(side, 3)
    low = np.array([0, clear, 0])
    high = side - low
    found = np.empty((number, 3))
    n = 0
    for _ in range(10_000_000):
        x = random.uniform(low, high)
        away = found[:n] - x
        away -= side*np.round(away/side)
        if ((away**2).sum(axis=1) > (1 + gap)**2).all():
            found[n] = x
            n += 1
            if n == number:
                return found
    raise ValueError(f"no room for {number} spheres")


def settling_box(
    folder, name, cells, side, centres, nu, gravity, ratio, entries, motion="",
    row=1,
):
    """The case, at rest. cells: per side; nu and gravity in units of the
    caller; entries: before the bodies; motion: more of the spheres; row: so
    many boxes along x."""
    case = periodic_case(folder, name, cells, 3, 0, True, length=side, row=row)
    case.replace("0/U", "uniform (1 0 0)", "uniform (0 0 0)")
    (case.path/"constant/fvOptions").write_text(FLOW_RATE.format(speed=0))
    set_box(case)
    set_viscosity(case, nu)
    case.gravity(gravity)
    positions = " ".join(
        "({:.12g} {:.12g} {:.12g})".format(*x) for x in centres
    )
    case.bodies(f"""
        sphere
        {{
            shape       {{ type sphere; radius 0.5; }}
            densityRatio {ratio};
            positions   ({positions});
            velocity    (0 0 0);
            angularVelocity (0 0 0);
            {motion}
        }}
    """, entries)
    return case
