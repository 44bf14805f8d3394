# SPDX-License-Identifier: GPL-3.0-or-later
"""A copy of an OpenFOAM case that a test may edit and run.

    case = FoamCase("tutorials/settlingDisc", tmp_path)
    case.set("system/controlDict", "endTime", 0.1)
    case.run("blockMesh")
    case.run("foamRun")
    t, x, y = case.read_dat("postProcessing/body/0/position.dat").T

The programs are taken from PATH: etc/bashrc has been sourced.
"""

import contextlib
import copy
import fcntl
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]/"python"))

from grainfoam import tables


# File that runs lock, if there are other processes
ranks_lock = None


@contextlib.contextmanager
def place_for(ranks):
    """Wait until there is no run on several ranks; for one on several, until
    there is none at all. Its ranks wait for each other: beside a process that
    keeps one of two cores busy four of them took more than seven times as long.
    """
    if not ranks_lock:
        yield
        return
    with open(ranks_lock, "w") as file:
        fcntl.flock(file, fcntl.LOCK_EX if ranks > 1 else fcntl.LOCK_SH)
        yield


class FoamError(Exception):
    """A program failed; the message ends with the end of its log."""


class FoamCase:
    """The case folder `source`, copied to `tmp_path`.

    0.orig becomes 0 where there is no 0.
    """

    def __init__(self, source, tmp_path, name=None):
        source = Path(source)
        self.path = Path(tmp_path) / (name or source.name)
        shutil.copytree(source, self.path)
        start = self.path / "0"
        if (self.path / "0.orig").is_dir() and not start.exists():
            shutil.copytree(self.path / "0.orig", start)

    def copy(self, folder, name):
        """The same in another folder, with its mesh and results."""
        other = copy.copy(self)
        other.path = Path(folder) / name
        shutil.copytree(self.path, other.path)
        return other

    def run(self, app, *args, ranks=1):
        """Run a program, return its log; FoamError if it fails.

        On several ranks the case must have been decomposed before, by
        run("decomposePar").
        """
        command = [app, *map(str, args)]
        if ranks > 1:
            command = [
                "mpirun", "--oversubscribe", "-np", str(ranks),
                *command, "-parallel",
            ]
        environment = dict(
            os.environ,
            OMPI_ALLOW_RUN_AS_ROOT="1",
            OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
            # Waiting ranks leave the core to others: there may be too few
            OMPI_MCA_mpi_yield_when_idle="1",
        )
        with place_for(ranks):
            done = subprocess.run(
                command, cwd=self.path, env=environment, text=True,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            )
        (self.path / f"log.{app}").write_text(done.stdout)
        if done.returncode != 0:
            tail = "\n".join(done.stdout.splitlines()[-40:])
            raise FoamError(f"{' '.join(command)} in {self.path}\n{tail}")
        return done.stdout

    def set(self, file, entry, value):
        """Set or add an entry, "a/b" being b in the dictionary a."""
        value = str(value)
        self.run(
            "foamDictionary", "-disableFunctionEntries", file,
            "-entry", entry, "-set", value,
        )

    def times(self, folder="."):
        """Names of the time folders, in order; `folder`: e.g. processor0."""
        names = (entry.name for entry in (self.path / folder).iterdir())
        number = re.compile(r"\d+(\.\d*)?(e[-+]?\d+)?")
        return sorted(filter(number.fullmatch, names), key=float)

    def latest_time(self, folder="."):
        """Name of the last time folder."""
        return self.times(folder)[-1]

    def results(self, ranks=1, headers=False):
        """Contents of the files of the last time, by their names.

        Without headers, and without uniform/time: the name of the time, a sum
        of time steps, may differ in its last digit. With them: all of it.
        """
        folders = [f"processor{i}" for i in range(ranks)] if ranks > 1 else "."
        found = {}
        for folder in folders:
            time = self.path / folder / self.latest_time(folder)
            assert float(time.name) > 0
            for file in time.rglob("*"):
                if not file.is_file():
                    continue
                content = file.read_bytes()
                if not headers:
                    if file.name == "time":
                        continue
                    content = content.split(b"// * *", 1)[1]
                found[f"{folder}/{file.relative_to(time)}"] = content
        return found

    def read_dat(self, path):
        """Rows of numbers of a .dat file; brackets of vectors are dropped."""
        with open(self.path / path) as file:
            lines = [re.sub("[()]", " ", line) for line in file]
        return np.loadtxt(lines, comments="#", ndmin=2)
