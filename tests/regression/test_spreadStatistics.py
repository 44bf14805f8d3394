# SPDX-License-Identifier: GPL-3.0-or-later
"""Statistics of bodies that each rank has its own of: the same as those of one
rank, of fewer bodies than that as well."""

import numpy as np
import pytest

from bodyCase import BodyCase
from foamCase import tables
from spreadCrowd import FILMS, STEP, STEPS, check_ranks, crowd
from spreadRuns import run_in_parts

STATISTICS = """functions
{
    stress
    {
        type            suspensionStress;
        libs            (immersedBodyFunctionObjects);
        writeControl    timeStep;
        writePrecision  15;
        shearRate       1;
        contactGap      0.02;
        clusterGap      0.3;
    }
    averages
    {
        type            bodyAverages;
        libs            (immersedBodyFunctionObjects);
        writeControl    timeStep;
        writePrecision  15;
        kernel          { type topHat; radius 1; }
        layers          4;
        fields          no;
    }
    fit
    {
        type            closureFit;
        libs            (immersedBodyFunctionObjects);
        writeControl    timeStep;
        writePrecision  15;
        layers          2;
    }
"""
TABLES = {
    "stress": ("suspensionStress", "suspensionStressMeans"),
    "averages": ("bodyAverages",), "fit": ("closureFit",),
}
COUNTS = ("contacts", "clusters", "largestCluster", "meanCluster", "samples")
# Of what follows from others by division
LEFT_OUT = ("unexplained", "errorOf_drag", "errorOf_addedMass")


def statistics(case):
    return {
        f"{file}: {column}": values
        for name, files in TABLES.items() for file in files
        for column, values in tables.run_columns(case.path, name, file).items()
    }


def compare(one, several):
    """But for rounding, relative to the largest component."""
    these, others = map(statistics, (one, several))
    assert these.keys() == others.keys()
    for name, values in these.items():
        column = name.split(": ")[1]
        if column in LEFT_OUT:
            continue
        if column in COUNTS:
            assert list(others[name]) == list(values), name
            continue
        scale = max(
            np.max(np.abs(same), initial=0, where=np.isfinite(same))
            for other, same in these.items()
            if other.split("_")[0] == name.split("_")[0]
        )
        assert others[name] == pytest.approx(
            values, rel=1e-5, abs=1e-6*scale, nan_ok=True
        ), name
    return these


def with_statistics(case):
    case.replace("system/controlDict", "functions\n{", STATISTICS)
    return case


@pytest.mark.parametrize("walls", [
    False, pytest.param(True, marks=pytest.mark.nightly),
])
def test_crowd(walls, tmp_path):
    """Discs that touch, some in clusters of several ranks; beside a wall, and a
    plane of symmetry that cuts some."""
    values = compare(*check_ranks(
        with_statistics(crowd(tmp_path, (1, 1), FILMS, walls)), tmp_path,
        number=240 if walls else 200,
    ))
    of_stress = {
        name.split(": ")[1]: column for name, column in values.items()
        if name.startswith("suspensionStress:")
    }
    assert max(of_stress["contacts"]) > 5
    assert max(of_stress["largestCluster"]) > 5
    assert np.abs(of_stress["contact_xx"]).max() > 0
    assert np.abs(of_stress["film_xx"]).max() > 0


@pytest.mark.nightly
def test_goes_on(tmp_path):
    """Means and fits after a restart are those of a run at once."""
    at_once = with_statistics(crowd(tmp_path, (1, 1), FILMS))
    parts = run_in_parts(at_once, tmp_path, STEP, STEPS, (4, 1, 1))
    these, others = map(statistics, (at_once, parts))
    for name, values in these.items():
        assert others[name][-1] == pytest.approx(
            values[-1], rel=1e-8, abs=1e-12, nan_ok=True
        ), name
