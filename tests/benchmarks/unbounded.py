# SPDX-License-Identifier: GPL-3.0-or-later
"""What benchmarks of bodies in a wide box share: conditions at its sides, gravity
and figures of a signal that oscillates."""

import numpy as np

GRAVITY = """FoamFile
{{
    version     2.0;
    format      ascii;
    class       uniformDimensionedVectorField;
    object      g;
}}

dimensions      [0 1 -2 0 0 0 0];
value           ({:.12g} {:.12g} 0);
"""


def set_conditions(case, U, p):
    """Conditions of all patches but frontAndBack in 0/U and 0/p."""
    for field, conditions in (("U", U), ("p", p)):
        path = case.path / "0" / field
        head = path.read_text().split("boundaryField", 1)[0]
        path.write_text(f"{head}boundaryField\n{{{conditions}}}\n")


def set_gravity(case, x, y=0):
    (case.path / "constant/g").write_text(GRAVITY.format(x, y))


def rises(signal):
    """Indices before which the signal rises through the middle of its range, once
    per oscillation: it must have been below a quarter of the range between."""
    low, high = signal.min(), signal.max()
    found, armed = [], False
    for i, value in enumerate(signal):
        armed = armed or value < low + 0.25*(high - low)
        if armed and value >= 0.5*(low + high):
            found, armed = [*found, i], False
    return np.array(found)


def whole_periods(time, signal):
    """Slice of whole periods and their mean length; None if there are none."""
    found = rises(signal)
    if len(found) < 2:
        return slice(None), None
    middle = 0.5*(signal.min() + signal.max())
    when = [
        np.interp(middle, signal[i - 1:i + 1], time[i - 1:i + 1])
        for i in found[[0, -1]]
    ]
    return slice(*found[[0, -1]]), (when[1] - when[0])/(len(found) - 1)


def mean_and_amplitude(signal):
    """Time average, and half the range."""
    return signal.mean(), 0.5*np.ptp(signal)
