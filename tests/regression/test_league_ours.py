# SPDX-License-Identifier: GPL-3.0-or-later
"""The benchmark `league`: what it runs of grainFoam."""

import pytest
from leagueCase import league, scenes


def test_fluid_alone_and_with_a_sphere(tmp_path):
    rows = list(league.ours.fluid(None, tmp_path, scenes.Fluid(32, 4)))
    assert [row["settings"].split(",")[0] for row in rows[::2]] == [
        "fluid alone", "one fixed sphere", "one free sphere",
    ]
    for step, cell in zip(rows[::2], rows[1::2], strict=True):
        assert step["quantity"] == "s per step"
        assert step["value"] > 0
        assert cell["value"]*32**3 == pytest.approx(1e9*step["value"])
