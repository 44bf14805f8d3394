# SPDX-License-Identifier: GPL-3.0-or-later
"""Each grain of etc/grains is taken from there by a case, in all three ways."""

import os
import re
from pathlib import Path

import pytest

from bodyCase import BodyCase
from boxMesh import uniform
from openTube import passage

LIBRARY = Path(os.environ["GRAINFOAM_DIR"]) / "etc/grains"
GRAINS = re.findall(r"(?m)^    (\w+)$", LIBRARY.read_text())


def entry_of(grain):
    """Its text in the library."""
    return re.search(
        rf"(?ms)^    {grain}\n    {{(.*?)^    }}", LIBRARY.read_text()
    ).group(1)


def test_the_library_has_the_grains_of_seed_drills():
    assert GRAINS == ["rapeseed", "wheat", "soy", "fabaBean", "maize"]


@pytest.mark.parametrize("grain", GRAINS)
def test_a_case_takes_a_grain_from_the_library(grain, tmp_path):
    # A box six times as wide as the grain is long
    entry = entry_of(grain)
    R = float(re.search(r"(?:radius|semiAxes) +\(?([\d.e-]+)", entry).group(1))
    case = BodyCase("box", tmp_path)
    case.mesh(*3*[uniform(-6*R, 6*R, 30)])
    case.controls(
        endTime="0.002", deltaT="0.001", writeInterval="0.002",
        writeFormat="ascii", writePrecision="12",
    )
    case.bodies(
        f"one {{ $:grains.{grain}.body; position (0 0 {-2.4*R}); }}", f"""
        #include "$GRAINFOAM_DIR/etc/grains"
        rho     1.2;
        contact
        {{
            type softSphere; $:grains.{grain}.contact;
            pairs {{ $:grains.{grain}.pairs; }}
            walls {{ ".*" steel; }}
        }}
        injection
        {{
            seeds
            {{
                $:grains.{grain}.population;
                positions   (({-2.4*R} 0 {2.4*R}) ({2.4*R} 0 {2.4*R}));
                times       (0.001 0.001);
                velocity    (0 0 0);
                seed        1;
            }}
        }}
    """)
    log = case.solve()

    density = float(re.search(r"density\s+([\d.]+);", entry).group(1))
    restitution, friction = (
        float(re.search(rf"{key}\s+([\d.]+);", entry).group(1))
        for key in ("restitution", "friction")
    )

    # What has been read is in the log and in the state
    assert f"restitution {restitution:g}" in log
    assert f"friction {friction:g}" in log
    state = (case.path / "0.002/uniform/immersedBodies").read_text()
    ratios = [float(r) for r in re.findall(r"densityRatio\s+([\d.]+);", state)]
    sizes = [float(r) for r in re.findall(r"size\s+([\d.]+);", state)]
    assert len(sizes) == len(set(sizes)) == 2
    assert all(0.8 <= size <= 1.25 for size in sizes)
    assert all(0.89 < 1.2*r/density < 1.11 for r in ratios)
    assert [e.name for e in passage(case)] == ["seeds1", "seeds2"]

    # It begins to fall
    assert case.table("motion")["velocity_z"][-1] < 0
