# SPDX-License-Identifier: GPL-3.0-or-later
"""Periods, means and amplitudes of a signal that oscillates."""

import numpy as np


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
