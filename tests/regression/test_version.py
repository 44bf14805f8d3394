# SPDX-License-Identifier: GPL-3.0-or-later
"""The version is that of the file VERSION wherever it is named."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from bodyCase import CASES
from foamCase import FoamCase

pytestmark = pytest.mark.fast

ROOT = Path(__file__).resolve().parents[2]
VERSION = (ROOT/"VERSION").read_text().strip()


def test_foamRun_prints_it(tmp_path):
    case = FoamCase(CASES/"cavity", tmp_path)
    case.run("blockMesh")
    log = case.run("foamRun", "-check")
    assert re.findall(r"(?m)^grainFoam (.*)$", log) == [VERSION]


@pytest.mark.parametrize("file, text", [
    # The first of those with a number
    ("CHANGELOG.md",
     rf"\A# .*\n+(?:## Unreleased\n(?:(?!## ).*\n)*)?"
     rf"## {re.escape(VERSION)}\b"),
    ("CITATION.cff", rf"(?m)^version: {re.escape(VERSION)}$"),
    ("packaging/spack/package.py", rf'version\(\s*"{re.escape(VERSION)}"'),
])
def test_documents_have_it(file, text):
    assert re.search(text, (ROOT/file).read_text())


def test_header_follows_the_file(tmp_path):
    """And is not touched where it is right: nothing would be up to date."""
    (tmp_path/"etc").mkdir()
    shutil.copy(ROOT/"etc/version", tmp_path/"etc")
    header = tmp_path/"out/grainFoamVersion.H"
    times = []
    for version in ("1.2.3", "1.2.3", "1.2.4"):
        (tmp_path/"VERSION").write_text(version + "\n")
        subprocess.run([tmp_path/"etc/version", tmp_path/"out"], check=True)
        assert header.read_text() == f'#define GRAINFOAM_VERSION "{version}"\n'
        times.append(header.stat().st_mtime_ns)
    assert times[0] == times[1] < times[2]
