# SPDX-License-Identifier: GPL-3.0-or-later
"""Order in time of a driven disc and of an ellipsoid that tumbles."""

import math

from drivenBodies import changes, disc_case, ellipsoid_case, motion
from measure import Run

TIGHT = "coupling { nOuterCorrectors 30; tolerance 1e-6; }"
ORDERS = {"backward": 2, "Euler": 1}

# Name, maker of the case and its arguments, schemes
STUDIES = (
    ("window", disc_case, {}, ("backward", "Euler")),
    # Any scheme conserves its angular momentum: the error is that of turning
    ("ellipsoid", ellipsoid_case, {}, ("backward",)),
)
IN_FULL = (
    ("defaults", disc_case, {"coupling": "", "tight": False}, ("backward",)),
    ("across mesh", disc_case, {"window": False}, ("backward",)),
    ("Re 30", disc_case, {"nu": 0.02}, ("backward",)),
    ("light ellipsoid", ellipsoid_case, {"ratio": 2}, ("backward",)),
    ("settling", disc_case, {"gravity": True}, ("backward",)),
)


def study(folder, name, make, arguments, scheme, sizes):
    """Rows of one case: by how much half the time step changes it, orders."""
    motions, runs = [], []
    for steps in sizes:
        settings = f"{name}, {scheme}, {steps}"
        case, cells, n = make(
            folder, settings.replace(", ", "_").replace(" ", "_"), steps,
            **{"coupling": TIGHT, "scheme": scheme, **arguments},
        )
        run = Run(case, settings, cells, n, may_fail=True)
        if run.failed:
            yield run.diverged()
            return
        motions.append(motion(case, steps//sizes[0]))
        runs.append(run)

    for quantity, relative in changes(motions).items():
        for run, change in zip(runs, relative):
            yield run.row(f"{quantity}, %", 100*change)
        for run, coarse, fine in zip(runs[2:], relative, relative[1:]):
            order = math.log2(coarse/fine)
            yield run.row(f"order {quantity}", order, ORDERS[scheme])


def rows(folder, quick):
    sizes = (20, 40, 80) if quick else (20, 40, 80, 160)
    for name, make, arguments, schemes in STUDIES + (() if quick else IN_FULL):
        for scheme in schemes:
            yield from study(folder, name, make, arguments, scheme, sizes)
