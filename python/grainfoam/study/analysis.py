# SPDX-License-Identifier: GPL-3.0-or-later
"""Zeros, means and shares with their intervals."""

import dataclasses
import math
from statistics import NormalDist

import numpy as np


@dataclasses.dataclass
class Zero:
    """Where a curve is zero, and its slope there."""

    x: float
    slope: float

    @property
    def stability(self):
        """Of a point where the curve is the velocity of x."""
        return "stable" if self.slope < 0 else "unstable"


def _local(x, y, i):
    """The polynomial through the four points next to interval i, or all if they
    are fewer, in x - x[i]."""
    first = max(min(i - 1, len(x) - 4), 0)
    at = slice(first, first + 4)
    return np.polynomial.Polynomial.fit(
        x[at] - x[i], y[at], len(x[at]) - 1).convert()


def zeros(x, y):
    """All zeros of y(x) between the points: of the cubic through the four next
    to it, or of what there is. x in any order."""
    order = np.argsort(x)
    x, y = np.asarray(x, float)[order], np.asarray(y, float)[order]
    found = []

    for i in range(len(x) - 1):
        if y[i] == 0 or y[i]*y[i + 1] < 0:
            curve = _local(x, y, i)
            low, high = 0.0, x[i + 1] - x[i]
            while high - low > 1e-13*(x[-1] - x[0]) and y[i] != 0:
                middle = 0.5*(low + high)
                if curve(middle)*y[i] > 0:
                    low = middle
                else:
                    high = middle
            found.append(Zero(float(x[i] + low), float(curve.deriv()(low))))
    if len(x) > 1 and y[-1] == 0:
        slope = _local(x, y, len(x) - 2).deriv()(x[-1] - x[-2])
        found.append(Zero(float(x[-1]), float(slope)))

    return found


def interval(statistic, values, confidence=0.95, resamples=4000, seed=1):
    """A statistic of values and its interval, by bootstrap (Efron 1979): value,
    lower, upper end. Rows of values are drawn together."""
    values = np.asarray(values, float)
    source = np.random.default_rng(seed)
    found = [statistic(values[source.integers(len(values), size=len(values))])
             for _ in range(resamples)]
    tail = 50*(1 - confidence)
    return statistic(values), *np.percentile(found, (tail, 100 - tail))


def mean_interval(values, confidence=0.95, resamples=4000, seed=1):
    """The mean and its interval."""
    return interval(np.mean, values, confidence, resamples, seed)


def correlation_interval(x, y, confidence=0.95):
    """Correlation of x and y and its interval (Fisher 1921)."""
    r = np.corrcoef(x, y)[0, 1]
    half = NormalDist().inv_cdf(0.5 + 0.5*confidence)/math.sqrt(len(x) - 3)
    return r, math.tanh(math.atanh(r) - half), math.tanh(math.atanh(r) + half)


def share_interval(count, total, z=1.96):
    """Interval of a share of which `count` of `total` were seen (Wilson 1927);
    z: half width for a normal distribution, 1.96 for 95 %."""
    share = count/total
    centre = (share + z*z/(2*total))/(1 + z*z/total)
    half = z*math.sqrt(share*(1 - share)/total + z*z/(4*total**2)) \
        / (1 + z*z/total)
    return centre - half, centre + half
