# SPDX-License-Identifier: GPL-3.0-or-later
"""A run in milliseconds per step, by parts, and bytes per cell."""

import os
import re
import subprocess
import time

from foamCase import FoamError
from measure import Result

WARM = 3                    # steps before those that are timed
COARSE = 1                  # s; times in the log have hundredths of seconds
SHORT = 15                  # s; other work on the machine makes runs slower
WORK = 2e6                  # cells times steps of a run, about
MOST = 24                   # steps, lest grains meet
# What names of entries of the profile begin with
BODIES = ("immersedBodies::", "resolvedBodies::")
STEPS = "time.run() "
PARTS = ("momentumPredictor", "pressureCorrector", BODIES)


def times_of(log):
    """Seconds of the processor at the ends of the steps."""
    return [float(t) for t in re.findall(r"ExecutionTime = (\S+) s", log)]


class TimedRun(Result):
    """Runs a case of unit cells at Courant number 0.5; the faster of two short
    runs.

    step: time per step [ms], without the last, which writes; parts: that of
    PARTS; memory [kB] per cell, on the rank with most; outers: their mean;
    steps: those that are timed, by default so many that a run is short.
    Times are those of the processor, of the first rank; of less than COARSE
    seconds of steps the clock's, when the lines of the log come. exchange: time
    in MPI per step, mean of the ranks [ms].
    """

    def __init__(self, case, command, settings, D_over_h, cells, ranks=1,
                 steps=None):
        steps = steps or min(MOST, max(6, round(WORK/cells)))
        super().__init__(
            settings, D_over_h, cells, WARM + steps, solver=command[-1]
        )
        if ranks > 1:
            case.replace(
                "system/controlDict", "functions\n{",
                "functions\n{ mpi { type parProfiling; "
                "libs (utilityFunctionObjects); }",
            )
        self.case, self.command, self.ranks = case, command, ranks
        # How long the system takes to clear pages differs from run to run
        begin = min(
            (self.run(WARM)[3] for _ in range(2)),
            key=lambda seconds: seconds[STEPS],
        )
        runs = [self.run(self.steps)]
        if times_of(runs[0][2])[-1] < SHORT:
            runs.append(self.run(self.steps))
        self.step, self.memory, log, end = min(runs, key=lambda run: run[0])
        self.cpu = times_of(log)[-1]
        self.memory /= cells
        outers = re.findall(r"outer iterations (\d+)", log)[WARM:]
        self.outers = sum(map(int, outers))/max(1, len(outers))
        self.exchange = self.time_in_mpi(log, steps)
        self.parts = [
            self.step*(end[part] - begin[part])/(end[STEPS] - begin[STEPS])
            for part in PARTS
        ]

    def run(self, steps):
        """Time per step after WARM [ms], memory [kB], the log, and the seconds
        of PARTS and of all STEPS."""
        folder = self.case.path/("processor0" if self.ranks > 1 else "")
        self.case.controls(
            deltaT="0.5", endTime=f"{0.5*steps}", startFrom="startTime",
            profiling="{}", writeControl="timeStep", writeInterval=steps,
        )
        memory, clock = self.execute(self.case, self.command, self.ranks)
        log = (self.case.path/"log").read_text()
        times = times_of(log)
        if times[-1] - times[WARM - 1] < COARSE:
            times = clock
        step = 1000*(times[-2] - times[WARM - 1])/max(1, steps - WARM - 1)
        file = folder/f"{0.5*steps:g}"/"uniform"/"profiling"
        return step, memory, log, self.profile(file)

    @staticmethod
    def execute(case, command, ranks, options=()):
        """Run, with the log in the file log: peak of memory [kB], and the clock
        [s] at the ends of the steps. options: of mpirun."""
        if ranks > 1:
            command = [
                "mpirun", "-np", str(ranks), *options, *command, "-parallel"
            ]
        clock = []
        with open(case.path/"log", "w") as log:
            run = subprocess.Popen(
                command, cwd=case.path, stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT, text=True,
            )
            for line in run.stdout:
                if line.startswith("ExecutionTime"):
                    clock.append(time.monotonic())
                log.write(line)
            _, status, usage = os.wait4(run.pid, 0)
        if status:
            raise FoamError(f"{' '.join(command)} in {case.path}")
        return ranks*usage.ru_maxrss, clock

    @staticmethod
    def time_in_mpi(log, steps):
        """ms per step, from the sums that parProfiling prints after each."""
        sums = [
            float(reduced) + float(others) for reduced, others in re.findall(
                r"reduce    : avg = (\S+)s[\s\S]*?all-all   : avg = (\S+)s", log
            )
        ]
        return 1000*(sums[-1] - sums[WARM - 1])/steps if sums else None

    @staticmethod
    def profile(file):
        """Seconds of PARTS and of all STEPS; bodies count once."""
        entry = re.compile(
            r"id\s+(\d+);\s+(?:parentId\s+(\d+);\s+)?"
            r'description\s+"(.*)";\s+calls.*;\s+totalTime\s+(\S+);'
        )
        found = entry.findall(file.read_text())
        names = {key: name for key, _, name, _ in found}
        parents = {key: parent for key, parent, _, _ in found}
        seconds = dict.fromkeys((STEPS, *PARTS), 0.0)
        for key, _, name, time in found:
            part = next(filter(name.startswith, seconds), None)
            if part is None:
                continue
            above = []
            while key := parents[key]:
                above.append(names[key])
            if part == BODIES:
                if any(name.startswith(BODIES) for name in above):
                    continue
                for name in set(above) & set(PARTS):
                    seconds[name] -= float(time)
            seconds[part] += float(time)
        return seconds
