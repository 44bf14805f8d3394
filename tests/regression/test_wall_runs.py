# SPDX-License-Identifier: GPL-3.0-or-later
"""Rough walls (robinVelocity): restart, ranks, moving meshes, wrong entries."""

import numpy as np
import pytest

import refusals
from wallFlow import CASE, WallFlow, channel, turned


VARIED = "type robinVelocity; a table ((0 1) (8 3)); " \
    "K nonuniform List<vector> 2((1 0 0) (2 0 0));"


@pytest.fixture
def varied(tmp_path):
    """A channel with conditions that vary in space and time."""
    case = channel(tmp_path, "varied", 8, turned(33))
    case.condition("top", VARIED)
    case.condition("bottom", "type robinVelocity; slipLength 0.1;"
                   "wallVelocity sine; wallVelocityCoeffs { amplitude 1;"
                   " frequency 0.1; scale (1 1 0); level (0 0 0); }")
    case.set("system/controlDict", "endTime", 8)
    case.set("system/controlDict", "writeInterval", 4)
    case.set("system/controlDict", "writePrecision", 17)
    return case


def test_restart_is_exact(varied, tmp_path):
    case = WallFlow(varied.path, tmp_path, "parts")
    case.set("system/controlDict", "endTime", 4)
    for run in (varied, case):
        run.run("foamRun")
    case.set("system/controlDict", "endTime", 8)
    case.run("foamRun")
    for field in ("U", "p", "phi"):
        parts, at_once = (
            (run.path / "8" / field).read_bytes() for run in (case, varied)
        )
        assert parts == at_once


def test_two_ranks_and_back(varied, tmp_path):
    """The first rank has none of the faces at the top."""
    case = WallFlow(varied.path, tmp_path, "ranks")
    case.replace("system/decomposeParDict", "(2 1 1)", "(1 2 1)")
    varied.run("foamRun")
    case.run("decomposePar")
    case.run("foamRun", ranks=2)
    case.run("reconstructPar", "-latestTime")
    assert np.abs(case.values("U") - varied.values("U")).max() < 1e-8
    text = (case.path / "8/U").read_text()
    assert "slipLength" in text and "(2 0 0)" in text and "table" in text


WRONG = {
    "a 1; slipLength 1;": "only one of 'a' [1/m] and 'slipLength'",
    "": "needs one of 'a' [1/m] and 'slipLength'",
    "a 1; Kay (1 0 0);": "'Kay'",
    "slipLenght 1;": "nearest valid one is 'slipLength'",
    "a -1;": "'a -1' of patch 'top'",
    "a table ((0 1) (1 -1));": "'a -1' of patch 'top'",
}


@pytest.fixture(scope="module")
def refused(tmp_path_factory):
    folder = tmp_path_factory.mktemp("refused")
    return refusals.of_copies(channel(folder, "right", 4), folder, {
        entries: lambda case, entries=entries: case.condition(
            "top", f"type robinVelocity; {entries}"
        )
        for entries in WRONG
    })


@pytest.mark.fast
@pytest.mark.parametrize("entries", WRONG)
def test_wrong_entries_are_refused(entries, refused):
    # A table becomes wrong later
    steps = 1 if "table" in entries else 0
    refused[entries].names(WRONG[entries], "0/U", steps=steps)


def piston(folder, name, entries):
    """Velocities of a fluid that a piston pushes."""
    case = WallFlow(CASE.parent / "movingPiston", folder, name)
    case.replace(
        "0/U", "type movingWallVelocity; value uniform (0 0 0);", entries
    )
    case.set("system/controlDict", "libs", "(grainFvPatchFields)")
    case.set("system/controlDict", "writeFormat", "ascii")
    case.run("blockMesh")
    case.run("foamRun")
    return case


def test_wall_of_a_moving_mesh(tmp_path):
    """No slip is movingWallVelocity; with slip nothing flows through."""
    moving = piston(tmp_path, "moving",
                    "type movingWallVelocity; value uniform (0 0 0);")
    rough = piston(tmp_path, "rough", "type robinVelocity; slipLength 0;")
    slip = piston(tmp_path, "slip", "type robinVelocity; a 0;")
    U = moving.values("U")
    assert np.abs(rough.values("U") - U).max() < 1e-6*np.abs(U).max()
    assert np.abs(slip.values("U") - U).max() > 1e-3*np.abs(U).max()
    for case in (rough, slip):
        phi = case.values("phi", patch="piston")
        assert np.abs(phi).max() < 1e-12
