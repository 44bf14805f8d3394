# SPDX-License-Identifier: GPL-3.0-or-later
"""What etc/paraview/grains.py finds in a case, without ParaView."""

import importlib.util
from pathlib import Path

import pytest

pytestmark = pytest.mark.fast

FILE = Path(__file__).resolve().parents[2]/"etc/paraview/grains.py"
spec = importlib.util.spec_from_file_location("grains", FILE)
grains = importlib.util.module_from_spec(spec)
spec.loader.exec_module(grains)


def test_files_of_a_case(tmp_path):
    folder = tmp_path/"postProcessing/immersedBodySurfaces"
    folder.mkdir(parents=True)
    (tmp_path/"0").mkdir()
    assert grains.series(tmp_path) == []
    (folder/"bodies.vtp.series").touch()
    assert grains.series(tmp_path) == [folder/"bodies.vtp.series"]
    assert grains.foam_file(tmp_path).exists()

    assert not grains.decomposed(tmp_path)
    (tmp_path/"processor0").mkdir()
    assert grains.decomposed(tmp_path)
    (tmp_path/"0.1").mkdir()
    assert not grains.decomposed(tmp_path)


def test_no_case(tmp_path):
    with pytest.raises(SystemExit, match="is not a case"):
        grains.main([str(tmp_path)])
