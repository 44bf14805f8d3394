# SPDX-License-Identifier: GPL-3.0-or-later
"""The benchmark `league`: what it writes for each program of others, and reads
from it."""

import re

import numpy as np
import pytest
from leagueCase import scenes, settling, small_crowd, stand_in
from peers import cans, cp3d, cp3dInput, given, walberla

pytestmark = pytest.mark.fast


def entries(text):
    """Values by name of the namelists in a text, and the namelists."""
    found = dict(re.findall(r"^ *([\w:,()]+) *= *(.*?) *$", text, re.M))
    return found, re.findall(r"^&(\w+)", text, re.M)


# CaNS

LOG = """ *** Calculation loop starts now ***
 Time step #           1 Time =   0.5
 Time step #           2 Time =   1.0
 Checking stability and divergence...
 Velocity divergence norms: Mean =   1.2E-017 | Maximum =   {}
 *** Fim ***
"""


def test_input_of_CaNS(tmp_path):
    cans.write_fluid(tmp_path/"run", scenes.Fluid(64, 20), 20)
    text = (tmp_path/"run/input.nml").read_text()
    found, names = entries(text)
    assert names[0] == "dns" and text.count("\n/\n") == len(names)
    assert found["ng(1:3)"] == "64, 64, 64"
    assert float(found["visci"]) == pytest.approx(5)
    assert "dt_f = 0.5" in text and "nstep = 20," in text
    assert (tmp_path/"run/data").is_dir()


def test_results_of_CaNS():
    assert cans.read_steps(LOG.format("4.4E-016")) == 2
    for wrong in (LOG.format("0.3"), LOG.format("NaN"), LOG[:120], ""):
        with pytest.raises(given.PeerError, match="CaNS"):
            cans.read_steps(wrong)


def test_run_of_CaNS(tmp_path):
    program = stand_in(tmp_path, """
        import re, time
        n = int(re.search(r"nstep = (\\d+)", open("input.nml").read())[1])
        end = time.process_time() + 0.02*n
        while time.process_time() < end:
            pass
        for i in range(n):
            print(" Time step #", i + 1, "Time =", 0.5*i)
        print(" *** Fim ***")
    """)
    rows = list(cans.fluid(program, tmp_path, scenes.Fluid(10, 40)))
    assert [row["quantity"] for row in rows] == [
        "s per step", "ns per cell and step"
    ]
    assert rows[0]["steps"] == 40
    assert rows[0]["value"] == pytest.approx(0.02, rel=0.4)
    assert rows[1]["value"] == pytest.approx(1e6*rows[0]["value"])


# CP3d

def test_numbers_of_CP3d():
    """Markers: its own case Re3000Phi20 has 765 at 16 cells."""
    assert cp3dInput.markers(16) == pytest.approx(765, abs=2)
    assert [cp3dInput.fft_size(n) for n in (96, 66.7, 53.3, 106.7)] == [
        96, 66, 54, 108
    ]
    assert cp3dInput.namelist("a", b=True, c=[1.0, 0.5], d="x", e=3) == (
        '&a\n  b = T\n  c = 1, 0.5\n  d = "x"\n  e = 3\n/\n'
    )


def test_input_of_CP3d():
    text = cp3dInput.fluid_input(
        [12.0]*3, [96]*3, 0.025, 1.0, 0.125, 20, "AB2", True, 20
    )
    found, names = entries(text)
    assert names == ["BasicParam", "MeshSection", "MeshOptions", "IO_Options"]
    assert found["ischeme"] == "1" and found["IsUxConst"] == "T"
    assert found["BcOption"] == "0, 0, 0, 0, 0, 0"
    assert (found["nyc"], found["nycSection"]) == ("96", "96")
    assert (found["xnu"], found["dtMax"]) == ("0.025", "0.125")

    text = cp3dInput.spheres_input(
        500, 1.0, 8, 2.0, [1.0, 0.0, 0.0], floor=False, fixed=True
    )
    found, names = entries(text)
    assert "CFDACMCoupling" in names and found["UpdateACMflag"] == "F"
    assert (found["numPrtcl"], found["nplane"]) == ("500", "0")
    assert found["gravity"] == "1, 0, 0"
    assert int(found["icouple"]) % 15 == 0
    assert text.count("\n/\n") == len(names)


def test_results_of_CP3d(tmp_path):
    order = np.array([2, 3, 1], np.int32)
    place, speed = np.arange(9.0).reshape(3, 3), np.eye(3)
    file = tmp_path/"PartVisuForspheres0000000004"
    file.write_bytes(place.tobytes() + order.tobytes() + speed.tobytes())
    x, v = cp3d.read_spheres(file, 3)
    assert (x == place[[2, 0, 1]]).all() and (v == speed[[2, 0, 1]]).all()
    with pytest.raises(given.PeerError, match="is not of 4 spheres"):
        cp3d.read_spheres(file, 4)


# Falls at 0.1 m/s at step 2 and half that elsewhere; along x in crowds
CHANNEL_ACM = """
    import re, numpy as np
    text = open("fluid").read() + open("spheres").read()
    def entry(name):
        return re.search(name + r" = (\\S+)", text)[1].strip(",")
    x = np.fromfile("ACM/SpheresCoord.dat").reshape(-1, 5)
    assert len(x) == int(entry("numPrtcl"))
    last, every = int(entry("ilast")), int(entry("SaveVisu"))
    for step in range(0, last + 1, every):
        v = np.zeros((len(x), 3))
        v[:, 0] = 0.1*x[:, 0]
        v[:, 1] = -0.1 if step == 2 else -0.05
        with open(f"ACM/PartVisuForspheres{step:010d}", "wb") as file:
            file.write(np.ascontiguousarray(x[:, :3]).tobytes())
            file.write(np.arange(1, len(x) + 1, dtype=np.int32).tobytes())
            file.write(v.tobytes())
"""


def test_runs_of_CP3d(tmp_path):
    program = stand_in(tmp_path, CHANNEL_ACM)
    rows = list(cp3d.tenCate(program, tmp_path, settling(), True))
    assert [row["quantity"] for row in rows] == [
        "V max, m/s", "gap/D at V max"
    ]
    assert rows[0]["value"] == pytest.approx(0.1)
    assert rows[0]["error_percent"] == pytest.approx(100*(0.1/0.12224 - 1))
    assert rows[0]["steps"] == 550 and rows[0]["D_over_h"] == 8.1
    assert rows[1]["value"] == pytest.approx(8)

    scene = small_crowd()
    found = list(cp3d.crowd(program, tmp_path, scene, small_crowd(1)))
    assert [result.settings.split()[-1] for result, *_ in found] == [
        "RK3", "AB2"
    ]
    for _, _, _, speed in found:
        assert speed == pytest.approx(0.1*scene.centres[:, 0])


def test_a_run_of_CP3d_that_stops_early_is_told(tmp_path):
    program = stand_in(tmp_path, "print('too big div')")
    with pytest.raises(given.PeerError, match="its end:\ntoo big div"):
        list(cp3d.tenCate(program, tmp_path, settling(), True))


# waLBerla

def test_arguments_of_waLBerla():
    """Its box must divide into four along gravity."""
    for cells in (8, 10, 16):
        scene = settling(cells)
        n = walberla.resolution(scene)
        assert int(1.6*n + 0.5) % 4 == 0
        assert n == pytest.approx(cells/0.15, abs=4)
    assert walberla.arguments(settling(10, "E2")) == [
        "--fluidType", "2", "--resolution", "65", "--velocity", "0.05",
        "--baseFolder", "results",
    ]


# Falls to the gap that its resolution is for, and fails its own check
SETTLING_SPHERE = """
    import os, sys
    cells = sys.argv[4]
    assert sys.argv[1:4] == ["--fluidType", "4", "--resolution"]
    end = {"55": "0.001", "65": "7.9", "105": "nan"}[cells]
    os.mkdir("results")
    with open(f"results/LoggingSettlingSphere_4_res{cells}_x.txt", "w") as f:
        f.write("#\\t t\\t t/tref\\t posZ\\t gapZ/D\\t velZ\\t velZ_SI\\n")
        for row in ("0 0.1 0 60 8.2 -0.01 -0.06", "1 0.2 0 59 8.1 -0.02 -0.12",
                    f"2 0.3 0 4 {end} -0.01 -0.06"):
            f.write("\\t".join([*row.split(), "1", "1", "1"]) + "\\n")
    sys.exit(1)
"""


def test_run_of_waLBerla(tmp_path):
    """Its own check of accuracy, which fails here, does not matter; whether
    the sphere came to the bottom does."""
    program = stand_in(tmp_path, SETTLING_SPHERE)
    rows = list(walberla.tenCate(program, tmp_path, settling()))
    assert [row["value"] for row in rows] == [0.12, 8.1]
    assert (rows[0]["steps"], rows[0]["cells"]) == (3, 55*55*88)
    for cells, gap in ((10, "7.90"), (16, "nan")):
        with pytest.raises(given.PeerError, match=f"3 steps .* {gap} diam"):
            list(walberla.tenCate(program, tmp_path, settling(cells)))
    program = stand_in(tmp_path, "raise SystemExit('no such option')")
    with pytest.raises(given.PeerError, match="no such option"):
        list(walberla.tenCate(program, tmp_path, settling(12)))
