# SPDX-License-Identifier: GPL-3.0-or-later
"""Flows in 3D with closed forms, driven by traction on patches of any
direction (fixedTractionVelocity and fixedTractionPressure)."""

import math

import numpy as np
import pytest

import roundTube
from boxMesh import uniform
from wallFlow import CASE, NU, WallFlow, channel, steps, turned, vector

RHO = 1.2


def set_traction(case, patch, F, more=""):
    """Force per area [Pa]."""
    case.condition(
        patch,
        f"type fixedTractionVelocity; traction {vector(F)}; rho {RHO}; {more}",
    )
    case.condition(patch, "type fixedTractionPressure;", "p")


@pytest.mark.parametrize("axis", [(1, 0, 0), (2, 1, 0.5)])
def test_pressure_drives_a_round_tube(axis, tmp_path):
    """Hagen-Poiseuille, Q = pi R^4 F/(8 rho nu L): u_t = 0 at the ends."""
    F, L = 0.6, 0.4
    axis = np.array(axis)/np.linalg.norm(axis)
    case = WallFlow(CASE, tmp_path, "tube")
    roundTube.write(case, uniform(0, L, 2), 0.1)
    case.run("blockMesh")
    case.run("transformPoints", "-rotate", f"((1 0 0) {vector(axis)})")
    set_traction(case, "inlet", F*axis, "tangentialVelocity zero;")
    set_traction(case, "outlet", 0*axis, "tangentialVelocity zero;")
    case.condition("walls", "type noSlip;")
    steps(case, 100, 0.04)
    case.run("foamRun")
    Q = case.values("phi", patch="outlet").sum()
    # As inexact as the mesh at the wall
    assert Q == pytest.approx(math.pi*F/(8*RHO*NU*L), rel=7e-3)


def test_shear_stress_in_any_direction(tmp_path):
    """Couette flow, u = F_t (1 + y)/(rho nu), p = -F_n/rho."""
    rotation = turned(33, (1, 2, 3))
    F = np.array((0.3, 0.5, -0.2))
    case = channel(tmp_path, "shear", 8, rotation, three_d=True)
    case.condition("bottom", "type noSlip;")
    set_traction(case, "top", rotation @ F)
    steps(case, 400, 0.2)
    case.run("foamRun")
    x, u = case.centres() @ rotation, case.values("U") @ rotation
    exact = np.outer(1 + x[:, 1], (F[0], 0, F[2]))/(RHO*NU)
    assert u == pytest.approx(exact, abs=1e-6)
    assert case.values("p") == pytest.approx(-F[1]/RHO, abs=1e-6)
