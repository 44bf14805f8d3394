# SPDX-License-Identifier: GPL-3.0-or-later
"""Stand-ins for programs of others, of a few lines, and the modules of the
benchmark `league`."""

import sys
import textwrap
from pathlib import Path

BENCHMARKS = Path(__file__).resolve().parents[1]/"benchmarks"
sys.path += [str(BENCHMARKS), str(BENCHMARKS/"league")]

import leagueScenes as scenes  # noqa: E402, F401
from report import Report  # noqa: E402

league = Report.load(BENCHMARKS/"league")
TEN_CATE = Report.load(BENCHMARKS/"tenCate")
CROWD = Report.load(BENCHMARKS/"crowd")


def stand_in(folder, text):
    """An executable file with this Python program."""
    file = folder/"standIn"
    file.write_text(f"#!{sys.executable}\n{textwrap.dedent(text)}")
    file.chmod(0o755)
    return file


def settling(cells=8, name="E4"):
    """A case of ten Cate."""
    return scenes.settling(TEN_CATE, name, cells)


def small_crowd(number=3):
    """Spheres in a cube of three diameters."""
    return scenes.crowd(CROWD, number, 24, 8, 4)
