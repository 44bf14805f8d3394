# SPDX-License-Identifier: GPL-3.0-or-later
"""Time per step and grain of a bed whose void fraction is part of the equations
of the fluid."""

import re
import sys
from pathlib import Path

import numpy as np

from denseBox import COUPLING, column, grains, write_positions
from measure import Result

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parent/"cost"))

from timedRun import TimedRun  # noqa: E402

NUMBERS, QUICK_NUMBERS = (1000, 10000, 100000), (1000,)
KERNELS = {"1.5": "cells 1.5; diameters 3;", "3": "cells 3; diameters 3;"}
PHI, DIAMETER, CELL = 0.4, 1e-3, 2e-3       # volume fraction; [m]
SPEED, STEP = 0.6, 5e-4                     # of the air [m/s]; [s]
STEPS = 40
# The last step writes
REGIMES = {"few touch": (4, 11), "most touch": (30, STEPS - 1)}
# The first two are in momentum and pressure, contact is in the next two
PARTS = {
    "linearise": "immersedBodies::linearise",
    "advance": "immersedBodies::advance",
    "predict": "immersedBodies::predict",
    "end of step": "immersedBodies::endStep",
    "contact": "immersedBodies::contact",
    "momentum": "momentumPredictor", "pressure": "pressureCorrector",
}


def bed(folder, name, number, kernel):
    """Grains of 1 mm and 1200 kg/m3 on a jittered lattice in air, that is close
    to fluidising them, in a periodic column of cells of twice their width."""
    pitch = (np.pi/6/PHI)**(1/3)*DIAMETER
    across = max(3, round((number**(1/3)*pitch/CELL)/1.5))
    n = max(1, int(across*CELL/pitch))
    pitch_x = across*CELL/n
    layers = -(-number//n**2)
    pitch_z = np.pi/6*DIAMETER**3/PHI/pitch_x**2
    height = int(np.ceil(layers*pitch_z/CELL)) + 8
    case = column(folder, name, across, height, CELL, SPEED, 1.5e-5, False)
    x = (np.arange(n) + 0.5)*pitch_x
    z = (np.arange(layers) + 0.5)*pitch_z + 4*CELL
    places = np.array([(i, j, k) for k in z for j in x for i in x])[:number]
    room = np.array([pitch_x, pitch_x, pitch_z]) - DIAMETER
    places += np.random.default_rng(1).uniform(-0.45, 0.45, places.shape)*room
    write_positions(case, places)
    case.bodies(
        grains(DIAMETER/2, 1000, "free"),
        "contact { type softSphere; }"
        f" coupling {{ {COUPLING.format(drag='Gidaspow')}"
        f" kernel {{ {KERNELS[kernel]} }} }}",
    )
    case.gravity(0, 0, -9.81)
    end = f"{STEPS*STEP:.9g}"
    case.controls(deltaT=STEP, endTime=end, writeInterval=end)
    # Tables of all grains in each step are not what is timed
    path = case.path/"system/controlDict"
    path.write_text(
        path.read_text().split("functions\n{", 1)[0]
        + "profiling { active true; }\n"
    )
    return case, across**2*height


def ends(log):
    """Seconds of the processor, of the first rank, at the ends of the steps."""
    return [float(t) for t in re.findall(r"ExecutionTime = (\S+) s", log)]


def parts(case, ranks):
    """Seconds of a step, by part; of the first rank."""
    place = "processor0" if ranks > 1 else "."
    text = (
        case.path/place/case.latest_time(place)/"uniform/profiling"
    ).read_text()
    found = {}
    for block in text.split("description")[1:]:
        name = block.split('"')[1] if '"' in block else block.split()[0]
        total = re.search(r"totalTime\s+(\S+);", block)
        if total:
            found[name] = float(total.group(1))/STEPS
    return found


def rows(folder, quick):
    for number in QUICK_NUMBERS if quick else NUMBERS:
        for kernel in KERNELS:
            for ranks in (1, 2):
                case, cells = bed(
                    folder, f"{number}_{kernel}_{ranks}", number, kernel
                )
                if ranks > 1:
                    case.decompose(ranks, (1, 1, ranks))
                memory, _ = TimedRun.execute(case, ["foamRun"], ranks)
                times = ends((case.path/"log").read_text())
                result = Result(
                    f"{number} grains, kernel of {kernel} cells, {ranks}"
                    f" rank{'s'*(ranks > 1)}",
                    DIAMETER/CELL, cells, STEPS, solver="foamRun",
                )
                result.cpu = times[-1]
                for regime, (first, last) in REGIMES.items():
                    seconds = (times[last - 1] - times[first - 2])/(
                        last - first + 1
                    )
                    yield result.row(f"ms per step, {regime}", 1e3*seconds)
                    yield result.row(
                        f"us per grain and step, {regime}", 1e6*seconds/number
                    )
                yield result.row("memory MB", memory/1024)
                found = parts(case, ranks)
                for part, name in PARTS.items():
                    yield result.row(f"{part} ms", 1e3*found[name])
