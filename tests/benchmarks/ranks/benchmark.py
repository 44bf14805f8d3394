# SPDX-License-Identifier: GPL-3.0-or-later
"""What one of many ranks holds and sends, with as much work on each."""

import math
import re
import sys
from pathlib import Path

import numpy as np

from bodyCase import BodyCase
from foamCase import FoamError

HERE = Path(__file__).resolve().parent
BENCHMARKS = HERE.parent
sys.path.append(str(BENCHMARKS/"cost"))

from measure import Result  # noqa: E402
from report import Report  # noqa: E402
from timedRun import TimedRun  # noqa: E402

CROWD = Report.load(BENCHMARKS/"crowd")
GRAINS = Report.load(BENCHMARKS/"manyGrains")

# Parts along x, y, z, and cells per side of the cube of the crowd
PARTS = {1: (1, 1, 1), 2: (2, 1, 1), 4: (2, 2, 1), 8: (2, 2, 2),
         16: (4, 2, 2)}
CUBES = {1: 32, 2: 40, 4: 50, 8: 64, 16: 80}
QUICK = (1, 2, 4)
FRACTION, CELLS = 0.147, 8
# Cells per side of the cubes of a row, one per rank, and its contact
IN_ROW = 32
SPRINGS = "type softSphere; collisionTime {dt:.12g};"
# Grains per rank, with as many cells as 32^3
PER_RANK, SIDE = 2000, 32
# Iterations, so that they are the same for all
TWICE = "coupling { nOuterCorrectors 2; minOuterCorrectors 2; }"
# Two runs: what the start takes is in both
FEW, MORE = 3, 8

# Of Open MPI: counts what each rank sends to which
MONITORING = (
    "--mca", "pml_monitoring_enable", "2",
    "--mca", "pml_monitoring_enable_output", "3",
    "--mca", "pml_monitoring_filename", "sent",
)
COMMAND = ("foamRun", "-solver", "immersedFluid")
SURFACES = (
    "surfaces { type immersedBodySurfaces; libs (immersedBodyFunctionObjects);"
    " writeControl writeTime; }"
)


class Counted(Result):
    """Runs of a case on so many ranks.

    memory: peak of the largest rank [MB], without files; written, going_on: of
    runs that write states and surfaces at the end, and that go on from there;
    sent: by the rank that sends most, in a time step [kB].
    """

    def __init__(
        self, case, settings, D_over_h, cells, ranks, dt, parts=None
    ):
        super().__init__(f"{settings}, {ranks} ranks", D_over_h, cells, MORE)
        path = case.path/"system/controlDict"
        path.write_text(
            path.read_text().split("functions\n{", 1)[0]
            + f"functions {{ {SURFACES if D_over_h else ''} }}\n"
        )
        if ranks > 1:
            case.decompose(ranks, parts or PARTS[ranks])
        sent, memory = [], []
        for first, steps, every in (
            (0, FEW, 1000), (0, MORE, 1000), (0, MORE, MORE),
            (MORE, FEW, 1000),
        ):
            case.controls(
                deltaT=f"{dt:.12g}", endTime=f"{(first + steps)*dt:.12g}",
                startFrom="latestTime" if first else "startTime",
                writeControl="timeStep", writeInterval=every,
            )
            total, _ = TimedRun.execute(case, COMMAND, ranks, MONITORING)
            memory.append(total/ranks/1024)
            sent.append(self.bytes(case, ranks))
        self.memory, self.written, self.going_on = memory[1:]
        self.sent = max(sent[1] - sent[0])/(MORE - FEW)/1000
        times = re.findall(
            r"ExecutionTime = (\S+)", (case.path/"log").read_text()
        )
        self.cpu = float(times[-1])

    @staticmethod
    def bytes(case, ranks):
        """Sent by each rank to all others."""
        if ranks == 1:
            return np.zeros(1)
        files = sorted(case.path.glob("sent.*.prof"))
        if len(files) != ranks:
            raise FoamError(f"{case.path}: the MPI is not an Open MPI that"
                            " counts what is sent")
        return np.array([
            sum(int(n) for n in re.findall(
                r"^[EI]\t\d+\t\d+\t(\d+) bytes", file.read_text(), re.M
            ))
            for file in files
        ])

    def rows(self):
        yield self.row("MB, largest rank", self.memory)
        yield self.row("MB, if it writes", self.written)
        yield self.row("MB, if it goes on", self.going_on)
        yield self.row("kB sent per step", self.sent)


def crowd(folder, ranks):
    """Spheres in a cube, the same number of cells for each rank."""
    box = CUBES[ranks]
    number = round(FRACTION*box**3/(math.pi/6*CELLS**3))
    centres = CROWD.random_centres(number, box/CELLS, CROWD.GAP, 1)
    case = CROWD.crowd(
        folder, f"crowd{ranks}", centres, box, CELLS, MORE, coupling=TWICE
    )
    return Counted(
        case, f"{number} spheres", CELLS, box**3, ranks,
        CROWD.COURANT/(0.5*CELLS),
    )


def row(folder, ranks):
    """Spheres in cubes of cells in a row, one for each rank."""
    number = round(FRACTION*IN_ROW**3/(math.pi/6*CELLS**3))
    side = IN_ROW/CELLS
    centres = CROWD.random_centres(
        ranks*number, (ranks*side, side, side), CROWD.GAP, 1
    )
    dt = CROWD.COURANT/(0.5*CELLS)
    case = CROWD.crowd(
        folder, f"row{ranks}", centres, IN_ROW, CELLS, MORE, coupling=TWICE,
        contact=SPRINGS.format(dt=dt), row=ranks,
    )
    return Counted(
        case, f"{ranks*number} spheres in a row", CELLS, ranks*IN_ROW**3,
        ranks, dt, (ranks, 1, 1),
    )


def grains(folder, ranks, per_rank):
    """Grains that the mesh does not resolve, or none."""
    place = folder/f"grains{per_rank}_{ranks}"
    place.mkdir()
    size = tuple(SIDE*n for n in PARTS[ranks])
    case = BodyCase(GRAINS.make(place, size), place, "case")
    if per_rank:
        GRAINS.add_grains(case, size, per_rank*ranks)
    return Counted(
        case, f"{per_rank*ranks} grains",
        GRAINS.DIAMETER if per_rank else None, int(np.prod(size)), ranks, 0.5,
    )


def rows(folder, quick):
    for case in (crowd, row):
        for ranks in QUICK if quick else PARTS:
            yield from case(folder, ranks).rows()
    for per_rank in (PER_RANK, 0):
        for ranks in QUICK if quick else PARTS:
            yield from grains(folder, ranks, per_rank).rows()
