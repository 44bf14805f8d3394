# SPDX-License-Identifier: GPL-3.0-or-later
"""The pair across the tube that neither parts nor closes: its half distance and
its stability. As a program: the states around it, to
equilibrium/system/stokesModesDict."""

import pathlib
import shutil

import numpy as np

import pairMap
from grainfoam import tables
from grainfoam.study import analysis

here = pathlib.Path(__file__).resolve().parent

ACROSS = 0.5*np.pi
SCAN = np.linspace(-0.03, 0.03, 7)
STEPS = np.diag((0.02, 0.02, 0.04))


def of_map(maps):
    """Zeros of the rate of a, to first order in Re, across the tube."""
    rate = maps[1, :, 13, 26, 0]
    known = np.isfinite(rate)
    return analysis.zeros(pairMap.A[known], rate[known])


def states(a):
    """A scan over a, then a step forth and one back in a, yp and theta."""
    middle = np.array((a, 0, ACROSS))
    return [(a + da, 0, ACROSS) for da in SCAN] + [
        tuple(middle + sign*step) for step in STEPS for sign in (1, -1)]


def refined(a):
    """The Zero of the scan, and the derivatives of the rates (of a, yp, theta)
    by (a, yp, theta): at Re = 0, and to first order in Re."""
    zeroth, first = pairMap.rates(
        tables.run_columns(here/"equilibrium", "stokesModes"), states(a))
    n = len(SCAN)
    (zero,) = analysis.zeros(a + SCAN, first[:n, 0])
    matrices = [
        np.stack([(r[n + 2*i] - r[n + 2*i + 1])/(2*STEPS[i, i])
                  for i in range(3)], axis=1)
        for r in (zeroth, first)]
    return zero, *matrices


def main():
    (zero,) = [z for z in of_map(pairMap.read()) if z.slope < 0]
    folder = here/"equilibrium"
    shutil.rmtree(folder, ignore_errors=True)
    for name in "constant", "system", "0":
        shutil.copytree(here/name, folder/name)
    pairMap.write_states(states(zero.x), folder)


if __name__ == "__main__":
    main()
