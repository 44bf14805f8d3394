# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs with bodies that go on from the result of another solver."""

import shutil

import pytest

from bodyCase import BodyCase
from boxMesh import uniform

DT = 0.02
STEPS = 3
TIME = """FoamFile
{{
    version     2.0;
    format      ascii;
    class       dictionary;
    object      time;
}}

value           {value};
name            "{value}";
index           {index};
deltaT          {dt};
deltaT0         {dt};
"""
DISC = """
    disc
    {
        shape       { type disc; radius 0.3; }
        densityRatio 2;
        position    (0.01 0.02 0);
        velocity    (2 1 0);
        angularVelocity (0 0 3);
    }
"""


def first_step(folder, name, scheme, index):
    """Velocities of a disc after its first step, in a fluid that has been at
    rest so far: for this many time steps."""
    case = BodyCase("tube", folder, name)
    (case.path / "system/setExprFieldsDict").unlink()
    case.mesh(uniform(-1, 1, 40), uniform(-1, 1, 40))
    sides = '"inlet|outlet|walls" {{ type {}; }} frontAndBack {{ type empty; }}'
    case.conditions(sides.format("noSlip"), sides.format("zeroGradient"))
    case.replace("system/fvSchemes", "backward", scheme)
    case.replace("constant/transportProperties", "0.5;", "1e-3;")
    case.bodies(DISC, "coupling { nOuterCorrectors 1; }")

    start = index*DT
    if index:
        now = case.path / f"{start:g}"
        shutil.copytree(case.path / "0", now)
        (now / "uniform").mkdir()
        (now / "uniform/time").write_text(
            TIME.format(value=f"{start:g}", index=index, dt=DT)
        )
        # As a scheme of second order leaves it
        shutil.copy(now / "U", now / "U_0")
    case.controls(endTime=f"{start + DT:g}", deltaT=DT)
    case.solve()
    motion = case.table("motion")
    return [
        motion[column][-1]
        for column in ("velocity_x", "velocity_y", "angularVelocity_z")
    ]


def test_the_former_flux_does_not_count_in_bodies(tmp_path):
    new = first_step(tmp_path, "new", "Euler", 0)
    late = first_step(tmp_path, "late", "Euler", STEPS)
    assert late == pytest.approx(new, rel=1e-9)


def test_a_run_at_its_end_says_so(tmp_path):
    case = BodyCase("tube", tmp_path)
    case.mesh(uniform(-1, 1, 10), uniform(-1, 1, 10))
    case.controls(endTime="0", deltaT=DT)
    log = case.run("foamRun")
    assert "No time step is made: the run is at 0 s, and 'endTime'" in log
