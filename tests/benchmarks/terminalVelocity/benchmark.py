# SPDX-License-Identifier: GPL-3.0-or-later
"""Terminal velocity of grains that the mesh does not resolve."""

from fallingGrain import (
    falling_dust, falling_grain, limit, terminal_velocity,
)
from measure import Run

DENSITY = 1000
DIAMETERS = (0.0015, 0.0018, 0.002, 0.0022, 0.0025)
RAPESEED, DUST = 0.002, 60e-6
CELLS = (0.3, 1, 2, 3.5)


def fall(folder, D, cells, name="", **settings):
    """Row of one fall, at `cells` cells per diameter."""
    label = f"{1000*D:.3g} mm" + (f", {name}" if name else "")
    folder_name = f"{label}_{cells}".replace(" ", "_").replace(",", "")
    if D == DUST:
        case, n = falling_dust(folder, folder_name, cells, **settings)
    else:
        case, n = falling_grain(folder, folder_name, D, cells, **settings)
    run = Run(case, label, cells, n, may_fail=True)
    if run.failed:
        return run.diverged()
    return run.row(
        "terminal velocity", limit(case.table("motion")["velocity_x"]),
        terminal_velocity(D, DENSITY),
    )


def rows(folder, quick):
    for D in (RAPESEED,) if quick else DIAMETERS:
        for cells in (0.3, 1):
            yield fall(folder, D, cells, start=0.97)
    if quick:
        return
    for cells in CELLS[2:]:
        yield fall(
            folder, RAPESEED, cells, start=0.97, courant=2, end=0.15,
            width=10*int(cells + 1), behind=24*int(cells + 1)//2,
        )
    for cells in (0.3, 1):
        yield fall(folder, DUST, cells)
    changes = {
        "from 1.3 of it": {"start": 1.3, "end": 1.2},
        "half the time step": {"start": 0.97, "courant": 2},
        "other place": {"start": 0.97, "place": (0.5, 0.5, 0)},
        "wide kernel": {
            "start": 0.97,
            "coupling": "type unresolved; kernel { cells 5; }",
        },
    }
    for name, settings in changes.items():
        yield fall(folder, RAPESEED, 1, name, **settings)
