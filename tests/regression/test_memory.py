# SPDX-License-Identifier: GPL-3.0-or-later
"""Memory of a run lies in large pages, as far as that can be asked for."""

import re
import resource
import subprocess
import time
from pathlib import Path

import pytest

from foamCase import FoamCase

CASES = Path(__file__).parent / "cases"
SYSTEM = Path("/sys/kernel/mm/transparent_hugepage/enabled")
LITTLE = 600 << 20


def cavity(folder, cells):
    """A box of cells (nx ny nz), meshed."""
    case = FoamCase(CASES / "cavity", folder)
    dict_ = case.path / "system/blockMeshDict"
    text, found = re.subn(
        r"(hex \([^)]*\)) \([^)]*\)", rf"\1 ({cells})", dict_.read_text()
    )
    assert found == 1
    dict_.write_text(text)
    case.run("blockMesh")
    return case


def asked_for(pid):
    """Part of a process's own memory that may lie in large pages."""
    areas = re.split(
        r"^[0-9a-f]+-[0-9a-f]+ .*\n", Path(f"/proc/{pid}/smaps").read_text(),
        flags=re.M,
    )
    own = large = 0
    for area in areas[1:]:
        size = int(re.search(r"^Anonymous: +(\d+)", area, re.M)[1])
        flags = re.search(r"^VmFlags:(.*)", area, re.M)[1].split()
        own += size
        large += size if "hg" in flags else 0
    return large/own


def part_during_run(case, limit):
    """asked_for() after the first step; limit: of virtual memory, in bytes."""
    log = case.path/"log"
    with log.open("w") as out:
        run = subprocess.Popen(
            ["foamRun"], cwd=case.path, stdout=out, stderr=out,
            preexec_fn=lambda: resource.setrlimit(
                resource.RLIMIT_AS, (limit, limit)
            ),
        )
        try:
            while run.poll() is None and "ExecutionTime" not in log.read_text():
                time.sleep(0.02)
            assert run.poll() is None, log.read_text()[-2000:]
            return asked_for(run.pid)
        finally:
            run.kill()
            run.wait()


# Without a limit, and with one that 4 kB per cell are beyond
@pytest.mark.skipif(not SYSTEM.exists(), reason="no such pages")
@pytest.mark.parametrize("limit", [resource.RLIM_INFINITY, LITTLE])
def test_mesh_and_fields_lie_in_large_pages(limit, tmp_path):
    assert part_during_run(cavity(tmp_path, "400 320 1"), limit) > 0.8


def test_a_mesh_whose_header_has_no_number_of_cells(tmp_path):
    case = cavity(tmp_path, "40 32 1")
    for entry, value in {
        "writeControl": "timeStep", "writeInterval": 1, "stopAt": "writeNow"
    }.items():
        case.set("system/controlDict", entry, value)
    want = case.copy(tmp_path, "want")
    want.run("foamRun")
    owner = case.path/"constant/polyMesh/owner"
    text, found = re.subn(
        rb"^\s*note .*\n", b"", owner.read_bytes(), flags=re.M
    )
    assert found == 1
    owner.write_bytes(text)
    case.run("foamRun")
    got, wanted = (
        (run.path/"0.02/U").read_bytes() for run in (case, want)
    )
    assert got == wanted
