# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tolerance of the outer iterations costs, in time and accuracy."""

from pathlib import Path

import numpy as np

from report import Report

HERE = Path(__file__).resolve().parent
TOLERANCES = None, 1e-2, 1e-3, 1e-4
# Of the crowd; its reference
CROWD, TIGHT = (62, 48, 8, 20), 1e-6


def coupling(tolerance, more=""):
    """Entry `coupling`; None: the default."""
    given = f"tolerance {tolerance:g};" if tolerance else ""
    return f"coupling {{ {more} {given} }}"


def named(run, tolerance):
    """The run with its tolerance in the settings."""
    name = f"{tolerance:g}" if tolerance else "default"
    run.settings += f", tolerance {name}"
    return run


def ellipse(folder, tolerance):
    """Rows of the ellipse of `jeffery`: the fluid's viscosity rules."""
    jeffery = Report.load(HERE.parent/"jeffery")
    case, run = jeffery.solve(
        folder, 2, 8, 20, coupling(tolerance, "nOuterCorrectors 40;")
    )
    named(run, tolerance)
    yield run.row("period", jeffery.figures(case)[0], jeffery.PERIOD)
    yield run.row("outers, mean", np.mean(run.outers))


def falling(folder, tolerance):
    """A run of a sphere of ten Cate in a viscous fluid, and its velocities."""
    tenCate = Report.load(HERE.parent/"tenCate")
    *_, speed, run = tenCate.solve(
        folder, "E1", 8, False, coupling=coupling(tolerance)
    )
    return named(run, tolerance), speed


def settled(folder, tolerance):
    """A run of the crowd, and the velocities of its spheres at the end."""
    crowd = Report.load(HERE.parent/"crowd")
    run, _, velocity = crowd.solve(folder, *CROWD, coupling(tolerance))
    return named(run, tolerance), velocity


def rows(folder, quick):
    for tolerance in TOLERANCES:
        place = folder/f"{tolerance or 'default'}"
        place.mkdir()
        yield from ellipse(place, tolerance)
    if quick:
        return
    (folder/"tight").mkdir()
    _, speeds = falling(folder/"tight", TIGHT)
    _, reference = settled(folder/"tight", TIGHT)
    for tolerance in TOLERANCES:
        place = folder/f"{tolerance or 'default'}"
        run, speed = falling(place, tolerance)
        error = 100*abs(speed - speeds)/speeds.max()
        yield run.row("largest error, % of the largest velocity", error.max())
        yield run.row(
            "error of the largest velocity, %",
            100*(speed.max()/speeds.max() - 1),
        )
        yield run.row("outers, mean", np.mean(run.outers))

        run, velocity = settled(place, tolerance)
        yield run.row("mean velocity", velocity.mean(), reference.mean())
        rms = np.sqrt(((velocity - reference)**2).mean())
        yield run.row(
            "rms error of a sphere, %", 100*rms/abs(reference.mean())
        )
        yield run.row("outers, mean", np.mean(run.outers))
