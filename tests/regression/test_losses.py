# SPDX-License-Identifier: GPL-3.0-or-later
"""Published losses against values by hand, and the pressure of the drill part
by part: where it is taken, and what is read from tables of which it is known."""

import math
import os
import sys

import numpy as np
import pytest

from benchCase import BENCH, BenchCase

sys.path.insert(0, str(BENCH.parent/"plotting"))
os.environ.setdefault("MPLBACKEND", "Agg")

import drillLosses  # noqa: E402
import drillPressure  # noqa: E402
import drillPressurePlot  # noqa: E402
import drillStations  # noqa: E402
import losses  # noqa: E402
from benchParameters import readBench  # noqa: E402
from drillStatistics import Drill  # noqa: E402
from friction import blasius, colebrook  # noqa: E402
from drillPiece import bent, drillPipe  # noqa: E402
from drillPiece import drillStations as stationsOf  # noqa: E402


@pytest.mark.parametrize("value, expected", [
    # 23200^-0.17 = 0.18108, 4^0.84 = 3.2043, alpha = 0.95 + 17.2*0.066064
    (losses.ito(23200, 4, 90), 0.2626),
    (losses.ito(1e5, 20, 90), 0.00241*90*20**0.84*1e5**-0.17),
    (losses.idelchik(0.0175, 2), 0.21/math.sqrt(2) + 0.0175*math.pi),
    # Idelchik's table has 1.18 for a radius of half the diameter
    (losses.idelchik(0, 0.5), 1.188),
    (losses.idelchik(0, 1), 0.21),
    (losses.expansion(0.25), 9/16),
    (losses.contraction(0), 0.5),
    (losses.contraction(15/16), 1/16),
    (losses.momentum(0.9, 4), 3.6),
    (losses.lift(0.9, 4.5, 0.35), 0.68670),
    (losses.bendWithSolids(30, 0.05), 1.5),
    (losses.stemerding(4.5, 0.1), 0.003),
    # In feet and seconds 0.206 u^-1.22
    (losses.capesNakamura(4.5, 0.1), 0.206*(4.5/0.3048)**-1.22),
    # f of 2 f G u L/D that makes 0.057 G L sqrt(g/D)
    (losses.konnoSaito(4.5, 0.1), 0.057*math.sqrt(9.81/0.1)*0.1/(2*4.5)),
])
def test_published_losses(value, expected):
    assert value == pytest.approx(expected, rel=2e-3)


def test_Ito_is_told_where_he_is_known_only():
    assert losses.ito(1e5, 4, 60) is None
    assert losses.ito(1e4, 20, 90) is None
    assert losses.ito(1e4, 2, 90) == pytest.approx(
        0.00241*90*(0.95 + 17.2/2**1.96)*2**0.84/1e4**0.17)


def test_kinetic_energy_of_the_profile():
    """Of u = y^(1/7), y from the wall."""
    y = (np.arange(200000) + 0.5)/200000
    u, r = y**(1/7), 1 - y
    mean = 2*(u*r).mean()
    assert 2*(u**3*r).mean()/mean**3 == pytest.approx(losses.PROFILE, abs=1e-3)


def test_friction_of_solids_is_the_range_of_the_formulas():
    low, high = losses.solidsFriction(0.9, 4.5, 2, 0.1)
    f = [x(4.5, 0.1) for x in losses.SOLIDS_FRICTION]
    assert len(f) == 3
    assert (low, high) == pytest.approx(
        (2*min(f)*0.9*4.5*20, 2*max(f)*0.9*4.5*20))
    assert low < high


@pytest.mark.parametrize("changes", [
    [], ["drill.bendRadius=0.1"], ["drill.across=4", "drill.along=0.5"],
    ["drill.riser=0.6", "drill.lengthBefore=0.5"]])
def test_stations_are_on_the_axis_and_in_their_legs(changes):
    bench = readBench(changes)
    own, legs = bench["drill"], drillStations.legs(bench)
    found = {s.name: s for s in stationsOf(bench)}
    assert set(found) == {name for names in drillStations.LEGS.values()
                          for name in names} | {
        f"inTube{n}" for n in range(1, 13)}
    length = drillPipe(bench)["feedPipe"]["length"]
    for leg, names in drillStations.LEGS.items():
        low, high = legs[leg]
        for name in names:
            s = found[name]
            assert low < s.distance < high
            # The straight pipe's axis, bent as the mesh is
            straight = np.array([[0, 0, s.distance - length]])
            assert s.frames[1][0] == pytest.approx(
                bent(straight, own["riser"], own["bendRadius"])[0], abs=1e-12)
            if leg != "bend":
                for point, normal in s.frames:
                    assert abs(normal[0 if leg == "before" else 2]) == 1
    tube = found["inTube4"]
    assert tube.frames[1][0] == pytest.approx((0, 0.1 + tube.distance, 0.03))
    assert tube.distance == pytest.approx(6*0.035, abs=0.02)


def test_pressures_are_weighted_with_the_flow(tmp_path):
    """Half of the sections with 1 m/s, the other half with 3, on one rank and
    on three; a mean by area would have 1.2 Pa of dynamic pressure less."""
    case = BenchCase("drill", tmp_path, ["drill.across=2"])
    folder = case.path
    (folder/"0/p").write_text(field("volScalarField", "p", "2 -2", "10"))
    (folder/"0/U").write_text(field("volVectorField", "U", "1 -1", "(1 0 0)"))
    (folder/"system/controlDict").write_text(CONTROL)
    (folder/"system/setFieldsDict").write_text(HALVES)
    (folder/"system/decomposeParDict").write_text(PARTS)
    case.run("setFields")
    for ranks in (1, 3):
        if ranks > 1:
            case.run("decomposePar")
        case.run("postProcess", "-time", "0", "-fields", "(p U)", ranks=ranks)
        for name in ("fan_2", "beforeBend_1", "inTube1_3", "outlet1End"):
            p, total = drillPressure.table(folder, name)[0, 1:]
            assert p == pytest.approx(10, rel=1e-6)
            assert total == pytest.approx(12 + 0.6*(1 + 27)/4, rel=2e-3)


HEAD = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"
CONTROL = HEAD.format("dictionary", "controlDict") + """
#include "<case>/constant/benchValues"
application foamRun;
startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;
writeControl timeStep; writeInterval 1; writePrecision 12;
functions
{
    #include "benchFunctionObjects"
}
"""
HALVES = HEAD.format("dictionary", "setFieldsDict") + """
regions (boxToCell
{
    box (-10 0 -10) (10 10 10);
    fieldValues (volVectorFieldValue U (3 0 0));
});
"""
PARTS = HEAD.format("dictionary", "decomposeParDict") + """
numberOfSubdomains 3; method simple; coeffs { n (3 1 1); }
"""


def field(kind, name, dimensions, value):
    return HEAD.format(kind, name) + (
        f"dimensions [0 {dimensions} 0 0 0 0]; internalField uniform {value};\n"
        'boundaryField { ".*" { type zeroGradient; } }\n')


# A run of 3 s without seeds for 1 s; pressures [Pa] without seeds at a flow of
# 0.12 m3/s, and what seeds add to the loss of each part
FLOWS = (0.12, 0.114)
TOTALS = {"fan": 400, "beforeBend": 395, "inBend1": 380, "inBend2": 370,
          "afterBend": 355, "inRiser": 352, "underHead": 349, "inTubes": 90,
          "ends": 80}
ADDED = {"feed pipe": 2, "bend": 4, "riser": 1, "head": 3, "tubes": 0.5,
         "exit": 0}
SPEEDS = {"beforeBend": 2, "afterBend": 4, "underHead": 5, "inTube": 2,
          "outlet": 3}
RATE, MASS = 600, 4.2e-6


def states():
    """{station: total pressure without seeds, with them}."""
    ratio = (FLOWS[1]/FLOWS[0])**2
    found, parts = {}, drillStations.PARTS[:-1]
    below = 0
    for name, first, last in reversed(parts):
        alone = TOTALS[first] - (TOTALS[last] if last else 0)
        below += ratio*alone + ADDED[name]
        found[first] = TOTALS[first], below
    return {name: found.get(name, (TOTALS[name], TOTALS[name]))
            for name in TOTALS}


def write(folder, name, columns):
    file = folder/f"postProcessing/{name}/0/surfaceFieldValue.dat"
    file.parent.mkdir(parents=True)
    np.savetxt(file, np.column_stack(columns))


@pytest.fixture
def run(tmp_path):
    """Planes of a station alternate by 100 Pa; outlets have unequal flows."""
    (tmp_path/"constant").mkdir()
    (tmp_path/"constant/benchChanges").write_text(
        "head.outlets=4\ndrill.airAlone=1\ndrill.filling=0.5\n")
    (tmp_path/"constant/seedValues").write_text("rho 1.2;\n")
    (tmp_path/"3/uniform").mkdir(parents=True)
    (tmp_path/"3/uniform/immersedBodies").write_text(
        "".join(f" volume {v}; densityRatio {MASS/v/1.2}; \n"
                for v in (4e-9, 5e-9)))
    t = np.arange(1, 601)*0.005
    late = (t > 1).astype(int)
    write(tmp_path, "fanInlet", (t, -np.array(FLOWS)[late]))
    shares = (0.1, 0.2, 0.3, 0.4)
    for n, share in enumerate(shares, 1):
        write(tmp_path, f"outlet{n}", (t, share*np.array(FLOWS)[late]))
    for name, totals in states().items():
        total = np.array(totals)[late]
        for n in range(1, 5):
            # The mean over the tubes, weighted with the flow, is the total
            tube = total + 7*(n - 3)
            if name == "ends":
                write(tmp_path, f"outlet{n}End", (t, 0*t, tube))
            elif name == "inTubes":
                alternating(tmp_path, f"inTube{n}", t, tube)
        if name not in ("inTubes", "ends"):
            alternating(tmp_path, name, t, total)
    return drill(tmp_path)


def alternating(folder, name, t, total):
    for plane, sign in ((1, -1), (2, 1), (3, -1)):
        write(folder, f"{name}_{plane}",
              (t, (0.5*total + 100*sign)/1.2, total + 100*sign))


def drill(folder):
    """A Drill with seeds of known speeds, RATE of them a second."""
    run = Drill.__new__(Drill)
    run.case, run.bench = folder, readBench(
        (folder/"constant/benchChanges").read_text().split())
    run.airAlone, run.start, run.end = 1, 1.5, 3
    count = round(RATE*1.5)
    run.planes = {name: {"axial": np.full(count, float(u))}
                  for name, u in SPEEDS.items()}
    for name in ("inTube", "outlet"):
        whole = run.planes.pop(name)["axial"]
        for n in range(1, 5):
            run.planes[f"{name}{n}"] = {"axial": whole[n - 1::4]}
    return run


def test_losses_part_by_part(run):
    found = drillPressure.pressures(run)
    parts = drillPressure.parts(run, found)
    assert [part.name for part in parts] == [*ADDED, drillStations.ALL]
    for part, (_, first, last) in zip(parts, drillStations.PARTS):
        alone = TOTALS[first] - (TOTALS[last] if last else 0)
        assert part.alone == pytest.approx((alone, 0), abs=1e-6)
        added = ADDED.get(part.name, sum(ADDED.values()))
        assert part.added == pytest.approx((added, 0), abs=1e-6)
        assert part.withSeeds[0] == pytest.approx(
            (FLOWS[1]/FLOWS[0])**2*alone + added)
    static = drillPressure.means(run, found)["fan"][0][0]
    assert static == pytest.approx(0.5*TOTALS["fan"])


def test_published_losses_of_the_drill(run):
    air = drillLosses.Air(run, FLOWS[0])
    U = FLOWS[0]/(0.25*math.pi*0.1**2)
    u, q = FLOWS[0]/(math.pi*0.035**2), 0.6*U**2
    nu, at = 1.81e-5/1.2, drillLosses.distances(run)
    assert (air.Re, air.re) == pytest.approx((U*0.1/nu, u*0.035/nu))
    found = air.published()
    length = at["beforeBend"] - at["fan"]
    assert found["feed pipe"] == pytest.approx(sorted(
        f(U*0.1/nu)*length/0.1*q for f in (blasius, colebrook)))
    straight = 0.25 - at["beforeBend"] + at["afterBend"] - 0.25 - 0.1*math.pi
    assert found["bend"][1] == pytest.approx(
        (max(losses.ito(air.Re, 4, 90),
             losses.idelchik(colebrook(air.Re), 2))
         + blasius(air.Re)*straight/0.1)*q, rel=0.01)
    assert found["head"][0] > (1 - 0.1**2/4/0.2/0.06)**2*q
    assert found["exit"] == pytest.approx((0.6*u**2, 0.6*1.058*u**2))
    assert found["all"] == pytest.approx(
        sum(v for k, v in found.items() if k != "all"))


def test_published_losses_by_seeds(run):
    flow = RATE*MASS
    seeds = drillLosses.Seeds(run, drillLosses.Air(run, FLOWS[1]))
    assert seeds.flow == pytest.approx(flow)
    assert drillPressure.loading(run) == pytest.approx(flow/(1.2*FLOWS[1]))
    found, at = seeds.published(30), drillLosses.distances(run)
    G, g = flow/(0.25*math.pi*0.1**2), 9.81
    behind = at["afterBend"] - drillStations.legs(run.bench)["bend"][1]
    low = G*(4 - 2) + G*g*0.2/3 + G*g*behind/4.5
    assert found["bend"] == pytest.approx(
        (low, low + 30*flow/(1.2*FLOWS[1])))
    assert found["head"] == pytest.approx(
        (2*flow/(math.pi*0.2*0.06), 2*flow/(math.pi*0.035**2)))
    riser = at["underHead"] - at["afterBend"]
    assert found["riser"] == pytest.approx(
        G*(5 - 4) + G*g*riser/4.5
        + np.array(losses.solidsFriction(G, 4.5, riser, 0.1)))
    # Half of them again come back from the head and pass a second time
    again = run.planes["underHead"]["axial"]
    run.planes["underHead"]["axial"] = np.append(again, again[::2])
    more = seeds.published(30)["riser"] - found["riser"]
    assert more == pytest.approx(0.5*G*5)


def test_no_seed_has_come_to_the_tubes(run):
    for n in range(1, 5):
        del run.planes[f"outlet{n}"]
    parts = drillPressure.parts(run, drillPressure.pressures(run))
    assert all(part.publishedAdded is None for part in parts)


def test_air_alone(run):
    run.end = run.start
    parts = drillPressure.parts(run, drillPressure.pressures(run))
    assert parts[-1].alone[0] == pytest.approx(TOTALS["fan"])
    assert parts[-1].withSeeds is None and parts[-1].added is None
    last = drillPressurePlot.table(parts)[-1].split()
    assert last[:3] == ["all", f"{TOTALS['fan']:.2f}", "+-"]
    assert last[-3:] == ["-", "-", "-"]


def test_blocks_have_an_interval():
    """Of the mean of a noise of known deviation, independent from 0.1 s on."""
    noise = np.repeat(np.random.default_rng(3).normal(5, 1, 4000), 20)
    time = 0.005*np.arange(1, len(noise) + 1)
    value, half = drillPressure.mean(
        drillPressure.blockMeans(time, noise, (0, time[-1])))
    assert half == pytest.approx(1.96/math.sqrt(4000), rel=0.15)
    assert abs(value - 5) < 2*half


def test_few_samples_make_few_blocks():
    blocks = drillPressure.blockMeans(
        np.arange(10), np.arange(10)**2, (3, 6))
    assert blocks == pytest.approx((16, 25, 36))
