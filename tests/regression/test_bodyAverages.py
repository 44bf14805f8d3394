# SPDX-License-Identifier: GPL-3.0-or-later
"""The function object bodyAverages, against exact volumes, velocities and
forces."""

import math
import re

import numpy as np
import pytest

from foamCase import tables
from periodicBox import FLOW_RATE, periodic_case
from shearedBox import NU, last_row, sheared_box, tighten

AVERAGES = """
    averages
    {{
        type            bodyAverages;
        libs            (immersedBodyFunctionObjects);
        writeControl    writeTime;
        writePrecision  15;
        kernel          {{ type {}; radius {}; }}
        {}
    }}
"""
DISC = """
    disc{}
    {{
        shape       {{ type disc; radius {}; }}
        densityRatio {};
        position    ({} {} 0);
        {}
    }}
"""
FIXED = "motion { type fixed; }"

# Discs of 16 cells, of which some are on the sides of the box
PLACES = [(0.02, 0.31), (0.43, 0.97), (0.61, 0.36), (0.31, 0.52), (0.87, 0.71)]
RADII = [0.125, 0.1, 0.11, 0.09, 0.125]


def averaged(case, kernel, radius, end, dt, ranks=1, n=None, entries=""):
    case.replace("system/controlDict", "functions\n{",
                 "functions\n{" + AVERAGES.format(kernel, radius, entries))
    case.controls(endTime=end, deltaT=dt, writeInterval=end,
                  writeFormat="ascii", writePrecision="15")
    log = case.solve(ranks, n)
    if ranks > 1:
        case.run("reconstructPar", "-latestTime")
    return log


def volumes(log):
    """Of the bodies, in cells, of the averages, in the log."""
    line = re.findall(
        r"volume of the bodies (\S+) m3, in cells (\S+), of the averages "
        r"(\S+);", log)[-1]
    return [float(number) for number in line]


def array(kernel, radius, folder, name, ranks=1, n=None):
    case = periodic_case(folder, name, 64, 2, 1, by_force=True)
    case.bodies("".join(
        DISC.format(i, R, 1, x, y, FIXED)
        for i, ((x, y), R) in enumerate(zip(PLACES, RADII))))
    case.replace("system/controlDict", FLOW_RATE, "")
    tighten(case)
    case.log = averaged(case, kernel, radius, 0.002, 0.001, ranks, n)
    return case


@pytest.mark.parametrize("kernel", ["Gaussian", "topHat", "sphere"])
def test_fractions_of_a_random_array(kernel, tmp_path):
    case = array(kernel, 0.7, tmp_path, kernel)
    eps = case.field("averageFluidFraction")
    phi = case.field("averageBodyFraction")
    area = math.pi*sum(R**2 for R in RADII)

    assert np.abs(eps + phi - 1).max() < 1e-12
    assert phi.mean() == pytest.approx(area, rel=1e-9)
    assert 0 <= phi.min() < 0.8*area and phi.max() > 1.2*area
    assert volumes(case.log) == pytest.approx([0.1*area]*3, rel=1e-5)

    # The independent sum: fractions in the cells, which are linear there
    cells = case.field("bodyFraction").mean()
    assert cells == pytest.approx(area, rel=3e-3)


def test_ranks(tmp_path):
    names = ("BodyFraction", "UFluid", "Force", "FluidStress")
    runs = [array("sphere", 0.7, tmp_path, f"on{ranks}", ranks, n)
            for ranks, n in ((1, None), (2, None), (4, (2, 2, 1)))]
    for name in names:
        values = [run.field(f"average{name}") for run in runs]
        scale = np.abs(values[0]).max()
        # Fractions know nothing of solvers
        error = 1e-12 if name == "BodyFraction" else 1e-6
        for other in values[1:]:
            assert np.abs(other - values[0]).max() < error*scale, name


def test_uniform_flow(tmp_path):
    """Fluid and bodies have the same velocity: no force, no fluctuations."""
    case = periodic_case(tmp_path, "box", 32, 2, 0, by_force=True)
    case.bodies(DISC.format("", 0.2, 3, 0.1, 0.4, "velocity (1 0 0);"))
    averaged(case, "Gaussian", 0.2, 0.01, 0.005)

    near = case.field("averageBodyFraction")[:, 0] > 1e-5
    assert 0.3 < near.mean() < 1
    for name in ("UFluid", "UBodies"):
        values = case.field(f"average{name}")[near]
        assert np.abs(values - [1, 0, 0]).max() < 1e-8, name
    for name in ("Force", "Drag", "Lift", "Spin", "Fluctuations", "BodyStress"):
        assert np.abs(case.field(f"average{name}")).max() < 1e-6, name


def test_force_of_a_settling_body(tmp_path):
    """n<f> integrates to the force on the body, and is along the slip."""
    case = sheared_box(tmp_path, "box", 4, 64, rate=0, stokes=False)
    case.bodies(DISC.format("", 0.25, 1.5, 0.1, 0.2, ""))
    case.gravity(y=-1)
    averaged(case, "sphere", 1, 0.2, 0.02, entries="layers 8;")
    force = case.table("forces")["fluidForce_y"][-1]
    volume = (4/64)**2*0.1
    f = case.field("averageForce")
    drag = case.field("averageDrag")
    lift = case.field("averageLift")

    assert force > 0
    assert f[:, 1].sum()*volume == pytest.approx(force, rel=1e-9)
    assert np.abs(drag + lift - f).max() < 1e-12
    assert drag[:, 1].sum() == pytest.approx(f[:, 1].sum(), rel=0.05)

    # The same in the layers of the table
    rows = tables.run_columns(case.path, "averages", "bodyAverages")
    assert rows["position"] == pytest.approx(np.arange(-1.75, 2, 0.5))
    assert rows["force_y"].sum()*4*0.5*4*0.1/4 == pytest.approx(force, rel=1e-9)
    assert rows["fluidFraction"] + rows["bodyFraction"] == pytest.approx(1)
    speed = rows["UBodies_y"][rows["bodyFraction"] > 1e-9]
    assert speed == pytest.approx(
        case.table("motion")["velocity_y"][-1], rel=1e-3)
    assert np.isnan(rows["UBodies_y"]).sum() == 8 - len(speed)


def test_sheared_suspension(tmp_path):
    """Viscosity of the averaged flow: that of the fluid away from the body,
    and more in its neighbourhood."""
    case = sheared_box(tmp_path, "box", 4, 64)
    case.bodies(DISC.format("", 0.25, 1, 0, 0, ""))
    averaged(case, "topHat", 0.8, 6, 0.3)
    nu = case.field("averageViscosity").reshape(64, 64)
    stress = case.field("averageFluidStress")[:, 1].reshape(64, 64)
    row = last_row(case, "suspensionStress")

    # Between the reach of body and wall, and about the body
    assert nu[10:16].mean() == pytest.approx(NU, rel=0.02)
    assert nu[32, 32] > 1.5*NU

    # Momentum goes through all layers
    assert stress[12:52].mean(axis=1) == pytest.approx(
        row["shearStress"], rel=0.015)
    assert stress[12:52].mean() == pytest.approx(
        row["shearStress"], rel=0.003)
