# SPDX-License-Identifier: GPL-3.0-or-later
"""A disc held in an oblique stream, towed across the mesh, and in a window that
it crosses sideways: one answer."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))

from report import Report  # noqa: E402

ANGLE, RE, CELLS, COURANT = 7, 40, 8, 0.5


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """Spin, lift and drag coefficient by frame."""
    folder = tmp_path_factory.mktemp("galilean")
    oblique = Report.load(Path(__file__).parents[1] / "benchmarks/oblique")
    # Half the time of the benchmark: forces are not steady yet, but the same
    oblique.TIMES = {RE: (8, 14)}
    return {
        frame: oblique.solve(folder, ANGLE, RE, CELLS, COURANT, frame)[0]
        for frame in ("stream", "mesh", "window")
    }


@pytest.mark.parametrize("frame", ["mesh", "window"])
def test_motion_through_the_mesh_is_not_felt(results, frame):
    spin, lift, drag = results[frame]
    _, own_lift, held = results["stream"]

    # Without a frame of reference that moves with the disc: a spin of 0.028 in
    # the window, a lift of -0.04
    assert abs(spin) < 0.005
    assert abs(lift - own_lift) < 0.012
    assert drag == pytest.approx(held, rel=0.004)
