# SPDX-License-Identifier: GPL-3.0-or-later
"""A sphere is released in a fluid at rest, of so little viscosity that it only
has its added mass to overcome, half of that of the fluid it displaces. That is
of a sphere up to half a cell larger, as pressure and flux both fade in the
layer around it."""

import pytest

from bodyCase import BodyCase
from boxMesh import graded

CELLS, STEPS, DELTA_T = 12, 4, 0.01


@pytest.fixture(scope="module")
def box(tmp_path_factory):
    case = BodyCase("box", tmp_path_factory.mktemp("box"))
    side = graded(-7, 7, (-1.5, 1.5), 2/CELLS, 1.25)
    case.mesh(side, side, side)
    case.replace("constant/transportProperties", "0.1;", "1e-4;")
    case.controls(endTime=STEPS*DELTA_T, deltaT=DELTA_T)
    return case


@pytest.mark.parametrize("ratio", (0.1, 2, 1000))
def test_acceleration(box, tmp_path, ratio):
    case = BodyCase(box, tmp_path, "case")
    case.bodies(f"""
        sphere
        {{
            shape       {{ type sphere; radius 1; }}
            densityRatio {ratio};
            position    (0.02 0.05 0.03);
        }}
    """, "coupling { nOuterCorrectors 20; }")
    case.solve()

    def speed(radius):
        return (1 - ratio)/(ratio + 0.5*radius**3)*STEPS*DELTA_T

    V = case.table("motion")["velocity_z"][-1]
    low, high = sorted((speed(1), speed(1 + 0.5*2/CELLS)))
    assert low < V < high
