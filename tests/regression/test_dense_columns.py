# SPDX-License-Identifier: GPL-3.0-or-later
"""Beds of grains whose volume is part of the equations of the fluid, in columns
that the fluid enters from below."""

import re

import numpy as np
import pytest
from scipy.optimize import brentq

from denseBox import (
    COUPLING, column, drag_force, ergun, grains, packed_column, probe_pressure,
    write_positions,
)


def gradient(W, D, nu, phi):
    """Of the pressure over the density in a bed, by Ergun [m/s2]."""
    return phi/(np.pi/6*D**3)*drag_force(ergun, W, D, nu, phi)


@pytest.mark.parametrize("speed", [0.02, 2])
def test_pressure_drop_of_a_fixed_bed_is_that_of_ergun(speed, tmp_path):
    """Of grains of 1 mm in air, in the middle of the bed."""
    h, phi, nu, layers = 1e-3, 0.55, 1.5e-5, 24
    D = (6*phi/np.pi)**(1/3)*h
    case = column(tmp_path, "bed", 3, layers + 12, h, speed, nu)
    i, k = np.arange(3) + 0.4, np.arange(layers) + 6.4
    write_positions(
        case, [(x*h, y*h, z*h) for z in k for y in i for x in i]
    )
    case.bodies(grains(D/2), f"coupling {{ {COUPLING.format(drag='Ergun')} }}")
    places = [(1.5*h, 1.5*h, (6 + n)*h) for n in (9.5, 14.5)]
    probe_pressure(case, places)
    case.controls(endTime=0.05, deltaT=5e-4)
    case.solve()
    p = case.read_dat("postProcessing/probes/0/p")[-1, 1:]
    assert (p[0] - p[1])/(5*h) == pytest.approx(
        gradient(speed, D, nu, phi), rel=1e-4
    )


def test_a_bed_of_free_grains_is_fluidised(tmp_path):
    """Pressure rises by Ergun until it carries the grains. At the surface of
    the bed, where the kernel thins it out, drag is less: all of it rises at
    some per cent more than the closed form."""
    D, nu, ratio, g, layers, duration = 1e-3, 1.5e-5, 1000, 9.81, 40, 0.12
    phi = np.pi/6*np.sqrt(2)*1.0001**-3
    weight = phi*(ratio - 1)*g
    onset = brentq(
        lambda W: gradient(W, D, nu, phi) - weight, 1e-4, 10
    )
    case, _, height = packed_column(
        tmp_path, D, ratio, nu, g, layers, (0.85*onset, 1.15*onset), duration
    )
    case.controls(endTime=duration, deltaT=1e-3)
    case.solve()

    p = case.read_dat("postProcessing/probes/0/p")
    speed = onset*(0.85 + 0.3*p[:, 0]/duration)
    rise = (p[:, 1] - p[:, 2])/(5*height)
    z = case.columns("motion")["position_z"].reshape(len(p), -1)
    free = z[0] > 7*height
    lift = (z - z[0])[:, free].mean(axis=1)/D

    # At rest, but for what the load presses the contacts together: the law,
    # and where it reaches the weight
    rest = (speed > 0.92*onset) & (speed < 1.03*onset)
    law = np.array([gradient(W, D, nu, phi) for W in speed])
    assert rise[rest] == pytest.approx(law[rest], rel=0.02)
    assert np.interp(1, rise/weight, speed/onset) == pytest.approx(1, abs=0.02)
    assert np.ptp(lift[rest]) < 0.015

    # Above: no more than the weight, and the bed rises
    end = speed > 1.12*onset
    assert np.ptp(rise[end])/weight < 0.02
    assert (law/rise)[-1] > 1.05
    assert lift[-1] > lift[rest].max() + 0.03


def case_has_values(case, time):
    """Is the void fraction not uniform, as without grains."""
    text = (case.path/time/"voidFraction").read_text()
    return "internalField   nonuniform" in text


def test_grains_that_enter_and_leave_take_their_volume_along(tmp_path):
    """The void fraction is that of the grains there are, and the flow keeps
    volume, in the steps in which they come and go as well."""
    h = 2e-3
    radius = 0.45e-3
    case = column(tmp_path, "lift", 3, 16, h, 8, 1.5e-5)
    case.bodies("", f"""
        coupling {{ {COUPLING.format(drag="Gidaspow")} }}
        leaving {{ outlet {{ type remove; }} }}
        injection
        {{
            one
            {{
                shape {{ type sphere; radius {radius}; }}
                densityRatio 10;
                position (0.0031 0.0029 0.012);
                velocity (0 0 4);
                times (0.0005 0.0015 0.0025 0.0035);
            }}
        }}
    """)
    case.controls(
        endTime=0.012, deltaT=1e-4, writeControl="timeStep", writeInterval=1,
        writeFormat="ascii", writePrecision=16,
    )
    log = case.solve()
    errors, counts = (
        [float(n) for n in re.findall(text, log)]
        for text in (r"sum local = (\S+),", r", bodies (\d+)")
    )
    assert max(errors) < 1e-14
    assert max(counts) >= 3 and counts[-1] == 0

    volumes = np.array([
        (1 - case.field("voidFraction", time)).sum()*h**3
        for time in case.times()[1:-1] if case_has_values(case, time)
    ])
    of_one = 4/3*np.pi*radius**3
    found = volumes/of_one
    assert found == pytest.approx(np.round(found), abs=1e-9)
    assert found.max() == pytest.approx(max(counts), abs=1e-9)
