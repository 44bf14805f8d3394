# SPDX-License-Identifier: GPL-3.0-or-later
"""Short runs of free bodies, and what is wrong with them."""

import numpy as np

from measure import Run

# Over the speed of the flow: a velocity of a body or its rim that is not
# physical, and one of its changes from step to step that is large
FAST, JITTER = 2.5, 0.05


def why(log):
    """What the solver said when it stopped."""
    if "FOAM FATAL" in log:
        lines = log.split("FOAM FATAL", 1)[1].splitlines()[1:]
        return " ".join(" ".join(lines).split("From ")[0].split())
    if "sigFpe" in log:
        return "floating point exception"
    return "stopped: " + " ".join(log.splitlines()[-1:])


class FreeRun(Run):
    """A run of a few whole steps dt; its attributes say what is wrong:

    reason      why it diverged, empty if it did not
    overlap     step after which bodies overlap, 0 if they do not
    repeats     time steps that were repeated with half their length
    fastest     largest velocity over the flow's
    jitter      by how much it changes from step to step in the end"""

    def __init__(
        self, case, settings, cells, n, dt, radius, speed, bodies=1
    ):
        super().__init__(case, settings, cells, n, may_fail=True)
        self.dt = dt
        log = (case.path / "log.foamRun").read_text()
        self.repeats = log.count(", repeated with deltaT")
        self.reason, self.fastest, self.jitter, self.overlap = "", 0, 0, 0
        if self.failed and "bodies overlap" in log:
            self.overlap = self.steps
        elif self.failed:
            self.reason = why(log)
            return
        for body in range(bodies):
            self.judge(case.table("motion", body), radius, speed)
        if self.jitter > 1 or self.fastest > 10:
            self.reason = f"velocity up to {self.fastest:.3g} times the " \
                f"flow's, last changes from step to step {self.jitter:.2g}"

    def judge(self, table, radius, speed):
        """Take one body's velocity and rim velocity at the whole steps."""
        motion = np.array(
            [table[f"velocity_{c}"] for c in "xyz"]
            + [radius*table[f"angularVelocity_{c}"] for c in "xyz"]
        ).T/speed
        part = table["time"]/self.dt
        motion = motion[abs(part - np.round(part)) < 1e-3]
        self.fastest = max(self.fastest, np.abs(motion).max())

        # Change of the change over a step: a smooth motion has little
        bend = np.linalg.norm(np.diff(motion, 2, axis=0), axis=1)
        if len(bend):
            last = np.sqrt(np.mean(bend[-6:]**2))
            self.jitter = max(self.jitter, last)

    def missed(self):
        """Number of steps that did not converge."""
        return self.steps - self.converged

    def faults(self):
        """Marks: X diverged, O large velocity, ~ jitter, number of steps not
        converged."""
        if self.reason:
            return "X"
        missed = self.missed()
        return ("O" if self.fastest > FAST else "") \
            + ("~" if self.jitter > JITTER else "") \
            + (f"{missed}" if missed else "")

    def rows(self):
        if self.reason:
            print(f"{self.settings} D/h {self.D_over_h}: {self.reason}")
            yield self.diverged()
            return
        if self.overlap:
            yield self.row("overlap after step", self.overlap)
        if self.repeats:
            yield self.row("steps repeated", self.repeats)
        if self.fastest > FAST:
            yield self.row("largest velocity", self.fastest)
        if self.jitter > JITTER:
            yield self.row("jitter", self.jitter)
        if self.missed():
            yield self.row("steps converged", self.converged)
