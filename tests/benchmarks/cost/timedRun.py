# SPDX-License-Identifier: GPL-3.0-or-later
"""A run in milliseconds per step, by parts, and bytes per cell."""

import os
import re
import subprocess

from foamCase import FoamError
from measure import Result

WARM = 3                    # steps before those that are timed
WORK = 2e6                  # cells times steps of a run, about
MOST = 24                   # steps, lest grains meet
BODIES = "immersedBodies::"
PARTS = ("momentumPredictor", "pressureCorrector", BODIES)


class TimedRun(Result):
    """Runs a case of unit cells at Courant number 0.5.

    step: time per step [ms]; parts: that of PARTS; memory [kB] per cell, on
    the rank with most; outers: their mean. Times are those of the processor,
    of the first rank. exchange: time in MPI per step, mean of the ranks [ms].
    """

    def __init__(self, case, command, settings, D_over_h, cells, ranks=1):
        steps = min(MOST, max(6, round(WORK/cells)))
        super().__init__(
            settings, D_over_h, cells, WARM + steps, solver=command[-1]
        )
        case.controls(
            deltaT="0.5", endTime=f"{0.5*self.steps}", profiling="{}",
            writeControl="timeStep", writeInterval=WARM,
        )
        if ranks > 1:
            case.replace(
                "system/controlDict", "functions\n{",
                "functions\n{ mpi { type parProfiling; "
                "libs (utilityFunctionObjects); }",
            )
        self.memory = self.execute(case, command, ranks)/cells
        log = (case.path/"log").read_text()
        times = [
            float(t) for t in re.findall(r"ExecutionTime = (\S+) s", log)
        ]
        outers = re.findall(r"outer iterations (\d+)", log)[WARM:]
        self.outers = sum(map(int, outers))/max(1, len(outers))
        self.cpu = times[-1]
        self.step = 1000*(times[-1] - times[WARM - 1])/steps
        self.exchange = self.time_in_mpi(log, steps)
        self.parts = self.split(case.path/("processor0" if ranks > 1 else ""))

    @staticmethod
    def execute(case, command, ranks):
        """Run, with the log in the file log; peak of memory [kB]."""
        if ranks > 1:
            command = ["mpirun", "-np", str(ranks), *command, "-parallel"]
        with open(case.path/"log", "w") as log:
            run = subprocess.Popen(
                command, cwd=case.path, stdout=log, stderr=log
            )
            _, status, usage = os.wait4(run.pid, 0)
        if status:
            raise FoamError(f"{' '.join(command)} in {case.path}")
        return ranks*usage.ru_maxrss

    @staticmethod
    def time_in_mpi(log, steps):
        """ms per step, from the sums that parProfiling prints after each."""
        sums = [
            float(reduced) + float(others) for reduced, others in re.findall(
                r"reduce    : avg = (\S+)s[\s\S]*?all-all   : avg = (\S+)s", log
            )
        ]
        return 1000*(sums[-1] - sums[WARM - 1])/steps if sums else None

    def split(self, folder):
        """Time per step of PARTS [ms], from OpenFOAM's own profiling."""
        files = sorted(
            folder.glob("*/uniform/profiling"),
            key=lambda file: float(file.parent.parent.name),
        )
        first, last = self.profile(files[0]), self.profile(files[-1])
        all_steps = last["application::main"] - first["application::main"]
        return [
            self.step*(last[part] - first[part])/all_steps for part in PARTS
        ]

    @staticmethod
    def profile(file):
        """Seconds of the whole and of PARTS; bodies count once."""
        entry = re.compile(
            r"id\s+(\d+);\s+(?:parentId\s+(\d+);\s+)?"
            r'description\s+"(.*)";\s+calls.*;\s+totalTime\s+(\S+);'
        )
        found = entry.findall(file.read_text())
        names = {key: name for key, _, name, _ in found}
        parents = {key: parent for key, parent, _, _ in found}
        seconds = dict.fromkeys(("application::main", *PARTS), 0.0)
        for key, _, name, time in found:
            part = BODIES if name.startswith(BODIES) else name
            if part not in seconds:
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
