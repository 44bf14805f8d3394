# SPDX-License-Identifier: GPL-3.0-or-later
"""A disc that oscillates in a fluid at rest: its case, what its force is made
of, and references."""

import math

import numpy as np

from bodyCase import BodyCase
from boxMesh import graded
from measure import (
    DEPTH, Run, around, set_profile, set_stokes, set_viscosity,
)

# D = 1, nu and the period T, with beta = D^2/(nu T) = 20
NU, PERIOD = 0.01, 5
OMEGA = 2*math.pi/PERIOD
PERIODS = 3

# Duetsch et al. 1998, Re 100 and KC 5: drag and added mass coefficient
DUETSCH = 2.09, 1.45


def stokes():
    """Damping and added mass coefficient of Stokes (1851)."""
    z = 0.5*np.sqrt(1j*OMEGA/NU)
    # K_1(z)/K_0(z), from the integrals of exp(-z cosh s)
    s = np.linspace(0, 12, 20001)
    weight = np.exp(-z*(np.cosh(s) - 1))
    ratio = np.trapz(weight*np.cosh(s), s)/np.trapz(weight, s)
    force = 1 + 4*ratio/z
    return -force.imag, force.real


def solve(
    folder, KC, cells, name, stokes_flow, steps=None, window="", change=None
):
    """The forces on a disc with the velocity KC/PERIOD sin(OMEGA t), in
    `steps` per period; change: what else is to be done to the case."""
    h = 1/cells
    speed = KC/PERIOD
    start = -speed/OMEGA
    case = BodyCase("tube", folder, f"{name.replace(' ', '_')}_D{cells}")
    set_profile(case, "1.5*(1 - sqr(pos().y()))", "0")
    if stokes_flow:
        set_stokes(case)
    n = case.mesh(
        graded(-20, 20, around(0, 1.25 - start, h), h),
        graded(-20, 20, around(0, 1.25, h), h),
    )
    set_viscosity(case, NU)
    if change:
        change(case)
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius 0.5; }}
            position    ({start:.12g} 0 0);
            motion
            {{
                type        prescribed;
                velocity
                {{
                    type        sine;
                    amplitude   {speed:.12g};
                    frequency   {1/PERIOD:.12g};
                    scale       (1 0 0);
                    level       (0 0 0);
                }}
            }}
        }}
    """, window)
    case.controls(
        endTime=f"{PERIODS*PERIOD}",
        deltaT=f"{PERIOD/(steps or 10*cells):.12g}",
    )
    return case, Run(case, name, cells, n, may_fail=True)


def coefficients(case, KC, drag, period):
    """Least squares over one period of the force per unit of depth,

    F = -C drag(U) - C_a pi/4 dU/dt: C and C_a, and what is left over.
    """
    table = case.table("forces")
    last = (table["time"] > (period - 1)*PERIOD + 1e-9) & (
        table["time"] < period*PERIOD + 1e-9
    )
    t = table["time"][last]
    force = table["fluidForce_x"][last]/DEPTH
    speed = KC/PERIOD
    U, dUdt = speed*np.sin(OMEGA*t), speed*OMEGA*np.cos(OMEGA*t)
    terms = np.c_[-drag(U), -0.25*math.pi*dUdt]
    solution, *_ = np.linalg.lstsq(terms, force, rcond=None)
    rest = force - terms @ solution
    return solution, rest.std()/force.std()


def harmonic_drag(case, KC):
    """C_D for which Morison's drag has the first harmonic of the force."""
    (in_phase, _), _ = coefficients(case, KC, damping, PERIODS)
    speed = KC/PERIOD
    share = 8/(3*math.pi)    # first harmonic of |sin| sin
    return in_phase*damping(speed)/(share*morison(speed))


def morison(U):
    """Drag of Morison et al. (1950) for a coefficient of one."""
    return 0.5*abs(U)*U


def damping(U):
    """Force in phase with the velocity for a coefficient of one."""
    return 0.25*math.pi*OMEGA*U
