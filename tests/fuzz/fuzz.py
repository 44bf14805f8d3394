# SPDX-License-Identifier: GPL-3.0-or-later
"""Starts small cases with changed dictionaries. Whatever they say, foamRun has
to run, or to stop with a message: no signal, no hang, no NaN that goes for a
result.

    for outcome in fuzz(folder, n=25, seed=1): ...
"""

import os
import random
import re
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor

from mutations import mutate
from scenes import make

FILES = (
    "constant/immersedBodyProperties", "constant/immersedBodyProperties",
    "constant/immersedBodyProperties", "constant/immersedBodyProperties",
    "constant/transportProperties", "constant/turbulenceProperties",
    "constant/g", "system/controlDict", "system/controlDict",
    "system/fvSchemes", "system/fvSolution", "0/U", "0/p",
)
TIMEOUT = 90    # s; most starts take less than one


class Outcome:
    """verdict: 'runs', 'refused' or what is wrong."""

    def __init__(self, number, change, verdict, log):
        self.number, self.change = number, change
        self.verdict, self.log = verdict, log

    @property
    def good(self):
        return self.verdict in ("runs", "refused")


def change(dice, case):
    """Change the case, return what has been changed."""
    file = case/dice.choice(FILES)
    name = file.relative_to(case)
    if not file.exists():
        return f"{name}: is not there"
    if dice.random() < 0.02:
        file.unlink()
        return f"{name}: removed"
    text, what = mutate(dice, file.read_text(errors="replace"))
    file.write_text(text)
    return f"{name}: {what}"


def judge(code, log, case):
    """What a run that has ended says by its code, its log and its files."""
    if "FOAM aborting" in log:
        # OpenFOAM's way to end with a message, for some
        return "refused"
    signal = re.search(r"sig(Fpe|Segv|Abrt)\S*::sigHandler", log)
    if code < 0 or code > 128 or signal:
        return signal.group() if signal else f"signal, code {code}"
    if code != 0:
        return "refused" if "FOAM FATAL" in log or "ERROR" in log else \
            f"code {code} without a message"
    texts = [log, *(
        file.read_text(errors="replace")
        for file in case.glob("postProcessing/*/*/immersedBody*.dat")
    )]
    if any(re.search(r"(?<![\w/])-?nan\b", text) for text in texts):
        return "NaN, code 0"
    return "runs"


def start(number, seed, base, folder):
    """Change a copy of a case and run it."""
    dice = random.Random(f"{seed} {number}")
    case = folder/f"start{number}"
    shutil.copytree(base.path, case, symlinks=True)
    what = f"{base.path.name}/{change(dice, case)}"
    try:
        done = subprocess.run(
            ["foamRun"], cwd=case, timeout=TIMEOUT, errors="replace",
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            env={key: value for key, value in os.environ.items()
                 if key != "FOAM_ABORT"},
        )
        log = done.stdout
        verdict = judge(done.returncode, log, case)
    except subprocess.TimeoutExpired as late:
        log = (late.stdout or b"").decode(errors="replace")
        verdict = f"still runs after {TIMEOUT} s"
    shutil.rmtree(case)
    return Outcome(number, what, verdict, log)


def fuzz(folder, n, seed, first=0, jobs=2):
    """Outcomes of the starts from `first` on, in order."""
    bases = make(folder)
    with ThreadPoolExecutor(jobs) as pool:
        yield from pool.map(
            lambda i: start(i, seed, bases[i % len(bases)], folder),
            range(first, first + n),
        )
