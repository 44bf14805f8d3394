# SPDX-License-Identifier: GPL-3.0-or-later
"""On a mesh that is not orthogonal pressure and velocity do not drive one
another up: without the corrections that this takes they do, at any time
step."""

import re

import pytest

from bodyCase import BodyCase
from boxMesh import uniform
from foamCase import FoamError
from shearedMesh import shear

FIXED = """
    cylinder
    {
        shape       { type disc; radius 0.05; }
        position    (%s 0.2 0);
        motion      { type fixed; }
    }
"""
SCHEMES = "system/fvSchemes"
SAYS = "the pressure needs %d corrections instead of " \
    "'nNonOrthogonalCorrectors %d'"


@pytest.fixture(scope="module")
def sheared(tmp_path_factory):
    """A channel with a cylinder, cells sheared by 34 degrees."""
    return channel(tmp_path_factory.mktemp("sheared"), 34)


def channel(folder, degrees):
    case = BodyCase("cylinder", folder)
    case.mesh(uniform(0, 1.1, 66), uniform(0, 0.41, 24))
    shear(case, degrees)
    case.bodies(FIXED % (0.45 if degrees < 50 else 0.8))
    case.controls(endTime="0.01", deltaT="1e-4")
    return case


def set_correctors(case, n):
    case.replace("system/fvSolution", "PIMPLE\n{",
                 f"PIMPLE\n{{\n    nNonOrthogonalCorrectors {n};")


def courant(log):
    """Largest Courant number of each step."""
    return [float(c) for c in re.findall(r"Courant Number.*max: (\S+)", log)]


@pytest.mark.parametrize("ddt", ["Euler", "backward"])
@pytest.mark.parametrize("correction", ["corrected", "limited 0.5"])
def test_small_steps_are_stable(ddt, correction, sheared, tmp_path):
    case = BodyCase(sheared, tmp_path)
    case.replace(SCHEMES, "default backward", f"default {ddt}")
    case.replace(SCHEMES, "linear corrected", f"linear {correction}")

    log = case.solve()

    # The flow beside the body is faster than what it starts with
    numbers = courant(log)
    assert len(numbers) > 99
    assert max(numbers) < 4*numbers[0]
    assert log.count(SAYS % (1, 0)) == 1


def test_one_correction_more_is_not_said_where_it_is_there(sheared, tmp_path):
    case = BodyCase(sheared, tmp_path)
    case.controls(endTime="2e-4")
    set_correctors(case, 1)

    assert "corrections instead of" not in case.solve()


@pytest.mark.parametrize("degrees, n", [(34, 2), (60, 3)])
def test_an_even_number_of_corrections(degrees, n, tmp_path):
    """They overshoot as none does, by less."""
    case = channel(tmp_path, degrees)
    case.controls(endTime="2e-4")
    set_correctors(case, 2)

    assert (SAYS % (n, 2) in case.solve()) == (n > 2)


def test_a_scheme_without_correction_is_refused(sheared, tmp_path):
    case = BodyCase(sheared, tmp_path)
    case.replace(SCHEMES, "linear corrected", "linear uncorrected")

    with pytest.raises(FoamError) as error:
        case.solve()

    message = str(error.value)
    for part in ("'laplacian((1|A(U)),p)'", "'Gauss linear corrected'",
                 "system/fvSchemes"):
        assert part in message
    assert case.times() == ["0"]


@pytest.mark.parametrize("degrees", [0, 10])
def test_nearly_orthogonal_meshes_need_nothing_more(degrees, tmp_path):
    case = channel(tmp_path, degrees)
    case.controls(endTime="2e-4")

    assert "corrections instead of" not in case.solve()
