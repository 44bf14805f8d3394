# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres close to each other, of which few need several iterations."""

import re

import numpy as np
import pytest

from bodyCase import BodyCase
from periodicBox import FLOW_RATE, periodic_case
from periodicTube import FLOW_RATE as FORCE
from periodicTube import direct_pressure
from restarts import check_exact

# Cells per side and per diameter; side over diameter
CELLS, SIDE = 32, 4
# A sphere in each of 3 x 3 x 2 boxes, out of its middle; seed 1
NUMBER = 18
STEPS = 16


def positions():
    random = np.random.default_rng(1)
    box = SIDE/np.array([3, 3, 2])
    places = np.indices((3, 3, 2)).reshape(3, -1).T
    away = random.uniform(-0.14, 0.14, places.shape)
    return (places + 0.5)*box + away


def spheres(centres):
    places = " ".join("({:.6g} {:.6g} {:.6g})".format(*x) for x in centres)
    return f"""
        sphere
        {{
            shape {{ type sphere; radius 0.5; }}
            densityRatio 2;
            positions ({places});
        }}
    """


@pytest.fixture(scope="module")
def box(tmp_path_factory):
    case = periodic_case(
        tmp_path_factory.mktemp("crowd"), "box", CELLS, 3, 0, True,
        length=SIDE,
    )
    case.replace("0/U", "uniform (1 0 0)", "uniform (0 0 0)")
    case.replace("constant/transportProperties", "0.5;", "0.025;")
    (case.path/"constant/fvOptions").write_text(FORCE.format(speed=0))
    direct_pressure(case)
    # Not for ranks without faces on a patch
    case.replace("system/controlDict", FLOW_RATE, "")
    case.gravity(1)
    return case


def settle(box, folder, name, coupling="", ranks=1, centres=None):
    """A run from rest: the case and the iterations of its steps."""
    case = BodyCase(box, folder, name)
    case.bodies(
        spheres(positions() if centres is None else centres),
        f"contact {{ type inelastic; }} {coupling}",
    )
    case.controls(deltaT=0.125, endTime=0.125*STEPS)
    log = case.solve(ranks)
    return case, [int(n) for n in re.findall(r"outer iterations (\d+)", log)]


def velocities(case):
    return np.array([
        [case.table("motion", i)[f"velocity_{k}"][-1] for k in "xyz"]
        for i in range(NUMBER)
    ])


def difference(a, b):
    """Root mean square over the spheres, over the mean speed."""
    return np.sqrt(((a - b)**2).sum(axis=1).mean())/abs(a[:, 0].mean())


@pytest.fixture(scope="module")
def settled(box, tmp_path_factory):
    return settle(box, tmp_path_factory.mktemp("settled"), "settled")


def test_one_iteration_is_enough(settled, box, tmp_path):
    """As good as the tolerance, a thousandth, when all have converged."""
    case, iterations = settled
    assert iterations[-4:] == [1]*4

    exact, _ = settle(
        box, tmp_path, "exact", "coupling { tolerance 1e-5; }"
    )
    assert difference(velocities(exact), velocities(case)) < 2e-3


def test_those_that_touch_go_on(box, tmp_path):
    """One sphere falls on the next: only these, and those around them."""
    centres = positions()
    centres[0] = centres[6] - [1.005, 0, 0]
    case, iterations = settle(box, tmp_path, "touch", centres=centres)
    exact, many = settle(
        box, tmp_path, "exact", "coupling { tolerance 1e-5; }",
        centres=centres,
    )

    assert max(iterations[4:]) <= 6 < max(many[4:])
    assert difference(velocities(exact), velocities(case)) < 5e-3


@pytest.mark.parametrize("ranks", [2, 4])
def test_ranks_give_the_same(ranks, settled, box, tmp_path):
    serial, iterations = settled
    parallel, same = settle(box, tmp_path, f"ranks{ranks}", ranks=ranks)
    assert same == iterations
    assert difference(velocities(serial), velocities(parallel)) < 1e-6


def test_restart_is_exact(box, tmp_path):
    case = BodyCase(box, tmp_path, "restart")
    case.bodies(spheres(positions()), "contact { type inelastic; }")
    case.controls(
        deltaT=0.125, writeControl="timeStep", writeInterval=2,
        writePrecision=17, timePrecision=15,
    )
    check_exact(case, tmp_path, half=0.75, end=1.25)


def test_restart_with_direct_pressure(box, tmp_path):
    """The first iteration of a run finds the pressure in the layers as it would
    in the middle of one."""
    at_once = BodyCase(box, tmp_path, "atOnce")
    at_once.bodies(spheres(positions()), "contact { type inelastic; }")
    at_once.controls(
        deltaT=0.125, writeControl="timeStep", writeInterval=2,
        writePrecision=17, timePrecision=15, endTime=1,
    )
    parts = BodyCase(at_once, tmp_path, "parts")
    at_once.solve()
    for end in (0.75, 1):
        parts.controls(endTime=end)
        parts.solve()

    # The sums of fastPoisson may differ in the last bit from run to run
    for name in "xyz":
        one, other = (
            case.columns("motion")[f"velocity_{name}"][-NUMBER:]
            for case in (at_once, parts)
        )
        assert np.max(np.abs(one - other)) < 1e-12
