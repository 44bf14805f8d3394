# SPDX-License-Identifier: GPL-3.0-or-later
"""A fan at an end of a tube: its point of operation."""

import re

import pytest

import refusals
from bodyCase import BodyCase
from endCase import NU
from test_traction import tube

# Depth of the mesh, length and half width of the channel
DEPTH, LENGTH = 0.1, 6

# Pressure without flow and flow without pressure
P0, Q0 = 0.9, 0.2*DEPTH


def crossing(P0, Q0):
    """Flow rate at which a linear curve meets the resistance of Stokes flow
    between plates, P = 3/2 nu L Q for the half width 1 and the depth 1."""
    return P0/(1.5*NU*LENGTH/DEPTH + P0/Q0)


def fan_case(folder, name="fan", curve=f"table ((0 {P0}) ({Q0} 0))", more="",
             **options):
    case = tube(folder, name, "zero", h_end=0.1, **options)
    case.replace(
        "0/U", "traction (0.25 0 0);", f"fan {curve}; {more}"
    )
    for solver in ("p|pFinal", "U|UFinal"):
        case.set("system/fvSolution", f'solvers/"({solver})"/relTol', 0)
    case.controls(endTime=12, deltaT=0.1, writeInterval=12,
                  writePrecision=17)
    return case


def state(case):
    """Flow rate that the condition has written."""
    text = (case.path/case.latest_time()/"U").read_text()
    return float(re.search(r"flowRate +(\S+);", text).group(1))


def flow_rate(case):
    return case.flow_rate()*DEPTH


@pytest.mark.parametrize("curve, expected", [
    (f"table ((0 {P0}) ({Q0} 0))", crossing(P0, Q0)),
    (f"polynomial (({P0} 0) ({-P0/Q0} 1))", crossing(P0, Q0)),
    # So steep that the fan nearly sets the flow rate, and so flat that it sets
    # the pressure
    (f"table ((0 {5*P0}) ({Q0/3} 0))", crossing(5*P0, Q0/3)),
    (P0, crossing(P0, 1e9)),
])
def test_point_of_operation_of_a_stokes_channel(curve, expected, tmp_path):
    case = fan_case(tmp_path, curve=curve, h=0.05)
    case.controls(deltaT=0.04)
    case.run("foamRun")
    assert flow_rate(case) == pytest.approx(expected, rel=3e-3)
    if isinstance(curve, str):
        assert state(case) == pytest.approx(flow_rate(case), rel=1e-4)


def test_the_fan_is_the_traction_that_its_curve_has(tmp_path):
    """At the flow rate that it ends with, to the accuracy of the steady state."""
    fan = fan_case(tmp_path)
    fan.run("foamRun")
    Q = state(fan)
    pressure = P0*(1 - Q/Q0)
    case = fan_case(tmp_path, "fixed")
    text = (case.path/"0/U").read_text()
    (case.path/"0/U").write_text(re.sub(
        r"fan table [^;]*;", f"traction ({pressure:.15g} 0 0);", text
    ))
    case.run("foamRun")
    assert case.field("U") == pytest.approx(fan.field("U"), abs=1e-7)


def test_dynamic_pressure_and_density(tmp_path):
    """In pascals, of a fluid of the density 800."""
    case = fan_case(tmp_path, more="rho 800;",
                    curve=f"table ((0 {800*P0}) ({Q0} 0))")
    other = fan_case(tmp_path, "other")
    for one in (case, other):
        one.controls(endTime=1, writeInterval=1)
        one.run("foamRun")
    assert case.field("U") == pytest.approx(other.field("U"), abs=1e-12)


def test_restart_and_ranks(tmp_path):
    """In the start, where the flow rate changes in every step."""
    at_once = fan_case(tmp_path, "atOnce")
    at_once.controls(endTime=0.4, deltaT=0.02, writeInterval=0.2)
    parts = BodyCase(at_once, tmp_path, "parts")
    ranks = fan_case(tmp_path, "ranks")
    ranks.controls(endTime=0.4, deltaT=0.02, writeInterval=0.2)

    at_once.run("foamRun")
    parts.controls(endTime=0.2)
    parts.run("foamRun")
    parts.controls(endTime=0.4)
    parts.run("foamRun")
    for field in ("U", "p", "phi"):
        a, b = (
            (case.path/"0.4"/field).read_bytes()
            for case in (at_once, parts)
        )
        assert a == b, field

    ranks.decompose(2, (1, 2, 1))
    ranks.run("foamRun", ranks=2)
    ranks.run("reconstructPar", "-latestTime")
    assert ranks.field("U") == pytest.approx(at_once.field("U"), abs=1e-7)


WRONG = {
    "fan table;": ["fan"],
    "fan 1; fann 2;": ["nearest valid one is 'fan'"],
    "traction (0 0 0); flowRate 1;": ["'flowRate'", "'fan'"],
    "rho 1;": ["needs 'traction' or 'fan'"],
}


@pytest.fixture(scope="module")
def refused(tmp_path_factory):
    folder = tmp_path_factory.mktemp("refused")
    case = tube(folder, "right", "zero", h=0.2, h_end=0.2)
    return refusals.of_copies(case, folder, {
        entry: lambda case, entry=entry: case.replace(
            "0/U", "traction (0.25 0 0);", entry
        )
        for entry in WRONG
    })


@pytest.mark.fast
@pytest.mark.parametrize("entry", WRONG)
def test_wrong_fans_are_refused(entry, refused):
    refused[entry].names(*WRONG[entry], "0/U")
