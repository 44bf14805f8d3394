# SPDX-License-Identifier: GPL-3.0-or-later
"""A fluid without bodies that is solved as with them: `fluid projected`."""

import math

import numpy as np
import pytest

from fallingGrain import set_viscosity
from foamCase import FoamError
from periodicBox import periodic_case
from slidingBox import centres, set_velocity, tight

PROJECTED = "coupling { fluid projected; }"
NU, END, STEP = 0.05, 0.2, 0.005
K = 2*math.pi


def vortices(n):
    """Velocities of vortices that only decay (Taylor & Green 1937)."""
    x, y = K*centres((n, n), (1, 1))[:, :2].T
    return np.stack(
        [np.sin(x)*np.cos(y), -np.cos(x)*np.sin(y), 0*x], axis=1
    )


def solved(folder, n=32, ranks=1, coupling=PROJECTED):
    """Velocities at the end, and the log."""
    case = periodic_case(folder, f"{n}_{ranks}", n, 2, 0)
    case.replace(
        "system/fvSolution", "GAMG;\n        smoother        GaussSeidel",
        "fastPoisson",
    )
    set_viscosity(case, NU)
    set_velocity(case, vortices(n))
    tight(case)
    case.bodies("", coupling)
    case.controls(
        endTime=f"{END}", deltaT=f"{STEP*32/n}", writeFormat="ascii",
        writePrecision=12, writeControl="timeStep",
        writeInterval=round(END/STEP*n/32),
    )
    case.solve(ranks, (1, ranks, 1))
    if ranks > 1:
        case.run("reconstructPar", "-latestTime")
    log = (case.path/"log.foamRun").read_text()
    return case.field("U")[:, :2], log


def error(velocity, n):
    """Largest difference from the exact solution."""
    exact = math.exp(-2*K**2*NU*END)*vortices(n)[:, :2]
    return abs(velocity - exact).max()


def test_second_order(tmp_path):
    coarse, log = solved(tmp_path, 16)
    fine, _ = solved(tmp_path, 32)
    assert "dp: 16 x 16 x 1 cells" in log
    assert error(fine, 32) < 0.004
    assert 3.4 < error(coarse, 16)/error(fine, 32) < 4.6


def test_ranks(tmp_path):
    one, _ = solved(tmp_path)
    two, _ = solved(tmp_path, ranks=2)
    assert abs(one - two).max() < 1e-9


def test_otherwise_fastPoisson_is_refused(tmp_path):
    with pytest.raises(FoamError, match="fastPoisson"):
        solved(tmp_path, coupling="")
