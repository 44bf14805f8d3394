# SPDX-License-Identifier: GPL-3.0-or-later
"""Force on a cylinder that oscillates in a fluid at rest, by the time step,
across the mesh and in a comoving window."""

import numpy as np

from measure import set_direct
from oscillation import (
    DUETSCH, OMEGA, PERIOD, PERIODS, coefficients, damping, harmonic_drag,
    morison, solve, stokes,
)

FRAMES = {
    "mesh": "", "window": "window { type comoving; direction (1 0 0); }",
}

# What a smooth force is made of, multiples of the frequency
HARMONICS = 9

# D/h, Courant numbers of the largest speed
QUICK = ((10, (0.5, 0.2)),)
FULL = ((10, (0.5, 0.2, 0.1)), (20, (0.5, 0.2)))

# D/h and steps per period in Stokes flow
STOKES_CELLS, STOKES_STEPS = 16, (160, 640)


def roughness(case):
    """Rms of the force of the last period that is not smooth, in % of it."""
    table = case.table("forces")
    last = table["time"] > (PERIODS - 1)*PERIOD + 1e-9
    phase, force = OMEGA*table["time"][last], table["fluidForce_x"][last]
    orders = range(1, HARMONICS + 1)
    terms = np.stack(
        [np.ones_like(phase)]
        + [wave(i*phase) for i in orders for wave in (np.cos, np.sin)], axis=1
    )
    solution, *_ = np.linalg.lstsq(terms, force, rcond=None)
    return 100*(force - terms @ solution).std()/force.std()


def runs(quick):
    """Name, KC, form of the drag, D/h and steps per period."""
    for cells, courants in QUICK if quick else FULL:
        for courant in courants:
            steps = round(PERIOD*cells/courant)
            yield f"KC 5 Courant {courant}", 5, morison, cells, steps
    for steps in STOKES_STEPS:
        name = f"Stokes {steps} steps"
        yield name, 0.2, damping, STOKES_CELLS, steps


def measured(case, KC, drag):
    """Drag and added mass coefficient by their names, and references."""
    (of_drag, added), _ = coefficients(case, KC, drag, PERIODS)
    if drag is morison:
        return zip(("C_D", "C_M"), (harmonic_drag(case, KC), added), DUETSCH)
    return zip(("damping", "added mass"), (of_drag, added), stokes())


def rows(folder, quick):
    for name, KC, drag, cells, steps in runs(quick):
        for frame, window in FRAMES.items():
            case, run = solve(
                folder, KC, cells, f"{name} {frame}", drag is damping, steps,
                window, set_direct,
            )
            if run.failed:
                yield run.diverged()
                continue
            for quantity, value, known in measured(case, KC, drag):
                yield run.row(quantity, value, known)
            rough = roughness(case)
            yield run.row("not smooth, % rms", rough, error=rough)
            yield run.row("outer iterations", np.mean(run.outers))
