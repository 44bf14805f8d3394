# SPDX-License-Identifier: GPL-3.0-or-later
"""Programs of others that the user has built: their paths, their runs and the
compilers that made them."""

import os
import re
import subprocess
from pathlib import Path
from typing import NamedTuple

# What compilers leave in a program
COMPILERS = (
    rb"GCC: \([^)]*\) ([\w.]+)", rb"clang version ([\w.]+)",
    rb"Intel\(R\)[^\x00]*Compiler[^\x00]*Version ([\w.]+)",
)
NAMES = ("gcc", "clang", "Intel")

# Memory that is freed stays with the program, as grainFoam has it for itself:
# to clear pages again takes over half of a step where the system is slow at it
ENVIRONMENT = {
    "OMP_NUM_THREADS": "1",
    "MALLOC_MMAP_MAX_": "0",
    "MALLOC_TRIM_THRESHOLD_": str(1 << 40),
}


class NotExecutable(ValueError):
    """A path that was given and cannot be run."""


class PeerError(RuntimeError):
    """A run of another's program that failed or left no results."""


def program(option, path):
    """The absolute path of what was given by the option or variable."""
    found = Path(path).expanduser().resolve()
    if not found.exists():
        raise NotExecutable(f"{option}: '{path}' does not exist")
    if found.is_dir() or not os.access(found, os.X_OK):
        raise NotExecutable(f"{option}: '{path}' is not an executable file")
    return found


class Done(NamedTuple):
    """A run: seconds of the processor, what it printed, its exit code."""

    cpu: float
    log: str
    code: int

    def check(self, solver):
        """Itself; an error with the last lines of its log if it failed."""
        if self.code:
            end = "\n".join(self.log.splitlines()[-5:])
            raise PeerError(f"{solver} ended with code {self.code}:\n{end}")
        return self


def run(command, folder):
    """Run on one core, with the log in folder/log."""
    environment = {**os.environ, **ENVIRONMENT}
    with open(folder/"log", "w") as log:
        process = subprocess.Popen(
            [str(word) for word in command], cwd=folder, env=environment,
            stdin=subprocess.DEVNULL, stdout=log, stderr=log,
        )
        _, status, usage = os.wait4(process.pid, 0)
    # Its end has been waited for above
    process.returncode = os.waitstatus_to_exitcode(status)
    text = (folder/"log").read_text(errors="replace")
    return Done(usage.ru_utime + usage.ru_stime, text, process.returncode)


def late_step(timed, steps):
    """Seconds per step of the second half of the steps, and what
    timed(steps) returned last; it returns a tuple whose first is a Done.

    Two runs: what it takes to start cancels."""
    half = steps//2
    begin = timed(half)[0].cpu
    last = timed(steps)
    return (last[0].cpu - begin)/(steps - half), last


def compiler(path):
    """Names and versions of the compilers in a program, as it says."""
    text = Path(path).read_bytes()
    found = dict.fromkeys(
        f"{name} {version.decode()}"
        for name, pattern in zip(NAMES, COMPILERS, strict=True)
        for version in re.findall(pattern, text)
    )
    return ", ".join(found) or "compiler unknown"


def machine():
    """Processor, number of cores and system."""
    names = re.findall(
        r"^model name\s*:\s*(.*)", Path("/proc/cpuinfo").read_text(), re.M
    )
    release = Path("/etc/os-release")
    system = re.findall(
        r'^PRETTY_NAME="?([^"\n]*)', release.read_text(), re.M
    ) if release.exists() else []
    parts = [*names[:1], f"{os.cpu_count()} cores", *system]
    return ", ".join(parts)
