# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the states of a study side by side. A state that has finished leaves a
record, written at once or not at all; what has none is run, from its start."""

import fcntl
import hashlib
import json
import os
import pathlib
import shutil
import signal
import subprocess
import time

from . import entries, results
from .dictionary import StudyError
from .states import settings

RECORD, RUNNING = "state.json", "running.json"


def started(pid):
    """When a process began, in ticks of the kernel; None if it is not there."""
    try:
        text = pathlib.Path(f"/proc/{pid}/stat").read_text()
    except OSError:
        return None
    return text.rpartition(")")[2].split()[19]


def digest(*parts):
    """A checksum of texts."""
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:16]


def template_digest(case, names, besides):
    """A checksum of the files that states are copied from, besides one."""
    total = hashlib.sha256()
    for name in names:
        top = case/name
        for file in sorted([top, *top.rglob("*")]):
            if file.is_file() and file != besides:
                total.update(f"{file.relative_to(case)}\0".encode())
                total.update(file.read_bytes())
    return total.hexdigest()


def fatal(log):
    """What a log says last: of OpenFOAM's errors their text."""
    lines = log.read_text(errors="replace").splitlines() if log.exists() else []
    for i, line in enumerate(lines):
        if "FOAM FATAL" in line:
            text = [part.strip() for part in lines[i + 1:i + 6] if part.strip()]
            return " ".join(text)[:300]
    return next((line.strip()[:300] for line in reversed(lines)
                 if line.strip()), "no output")


class Runner:
    """The states of a study: their folders, their records, their processes."""

    def __init__(self, study, case, states):
        self.study, self.case, self.states = study, case, states
        self.folder = case/study.get("folder", "states")
        self.copied = study.words("copy", ["0.orig", "constant", "system"])
        self.linked = study.words("link", [])
        self.commands = study.words("commands", ["foamRun"])
        programs = [os.path.basename(os.path.expandvars(c.split()[0]))
                    for c in self.commands]
        self.logs = [
            f"log.{name}" + (f".{i}" if programs.count(name) > 1 else "")
            for i, name in enumerate(programs, 1)]
        self.settings = settings(study)
        name = study.file.name.removesuffix("Dict")
        self.table = case/f"postProcessing/{name}.csv"
        self.records = {}
        self.running = {}
        self.times = []
        for name in (*self.copied, *self.linked):
            if not (case/name).exists():
                raise study.error(f"'copy' and 'link': there is no {case/name}")
        self._check_entries()
        kept = json.dumps([self.commands, self.linked,
                           [(s.file, s.entry, s.value) for s in self.settings]])
        self.template = digest(
            template_digest(case, self.copied, study.file), kept)
        self.asked = digest(repr([
            (n, sorted(c.entries.items(), key=str))
            for n, c in study.dictionaries("results").items()]))

    def _check_entries(self):
        """Refuse to set what the files do not have."""
        for setting in self.settings:
            file = self.case/setting.file
            if not any(file.is_relative_to(self.case/n) for n in self.copied):
                raise setting.where.error(
                    f"'file {setting.file}' is in none of what is copied:"
                    f" {' '.join(self.copied)}")
            if not file.is_file():
                raise setting.where.error(f"there is no file {file}")
            if not entries.find(file.read_text(), setting.entry):
                raise setting.where.error(f"{file} has no entry"
                                          f" '{setting.entry}'")

    def key(self, state):
        """Changes with all that the result of the state depends on."""
        return digest(self.template, json.dumps(state.parameters))

    def lock(self):
        """Refuse a second study in the same folder."""
        self.folder.mkdir(parents=True, exist_ok=True)
        self.locked = open(self.folder/".lock", "w")
        try:
            fcntl.flock(self.locked, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise StudyError(f"{self.folder}: a study is running here") from None

    def load(self, retry):
        """Read the records there are; returns the states to be run."""
        todo = []
        for state in self.states:
            folder = self.folder/state.name
            self._stop_left(folder)
            try:
                record = json.loads((folder/RECORD).read_text())
            except (OSError, ValueError):
                record = None
            if not record or record["key"] != self.key(state) or (
                    retry and record["status"] != "finished"):
                todo.append(state)
                continue
            if record["status"] == "finished" and record["asked"] != self.asked:
                record["results"] = results.collect(
                    self.study, folder, state.parameters)
                record["asked"] = self.asked
                self._write(folder, record)
            self.records[state.name] = record
            if record["status"] == "finished":
                self.times.append(record["runTime"])
        return todo

    def _stop_left(self, folder):
        """End processes that an earlier driver was killed above."""
        try:
            left = json.loads((folder/RUNNING).read_text())
        except (OSError, ValueError):
            return
        if started(left["pid"]) == left["started"]:
            os.killpg(left["pid"], signal.SIGKILL)
        (folder/RUNNING).unlink()

    def _write(self, folder, record):
        results.write_atomic(folder/RECORD, json.dumps(record, indent=1))

    def prepare(self, state):
        """A fresh folder with the files of the state."""
        folder = self.folder/state.name
        if folder.exists():
            shutil.rmtree(folder)
        folder.mkdir()
        for name in self.copied:
            source, target = self.case/name, folder/name
            target.parent.mkdir(parents=True, exist_ok=True)
            if source.is_dir():
                skip = [self.case/n for n in self.linked]
                shutil.copytree(
                    source, target, symlinks=True,
                    ignore=lambda d, names: [
                        n for n in names if pathlib.Path(d)/n in skip])
            else:
                shutil.copy2(source, target)
        for name in self.linked:
            (folder/name).parent.mkdir(parents=True, exist_ok=True)
            (folder/name).symlink_to((self.case/name).resolve())
        for setting in self.settings:
            file = folder/setting.file
            file.write_text(entries.replaced(
                file.read_text(), setting.entry, setting.text(state)))
        return folder

    def start(self, state):
        """Begin a state: all its commands in a group of processes."""
        folder = self.prepare(state)
        script = "\n".join(
            f"({command}) >{log} 2>&1 || exit {i}" for i, (command, log)
            in enumerate(zip(self.commands, self.logs), 1))
        # For scripts of the case
        names = {f"STUDY_{n}": str(v) for n, v in state.parameters.items()}
        process = subprocess.Popen(
            ["bash", "-c", script], cwd=folder, start_new_session=True,
            stdin=subprocess.DEVNULL,
            env={**os.environ, **names, "STUDY": str(self.case)})
        results.write_atomic(folder/RUNNING, json.dumps(
            {"pid": process.pid, "started": started(process.pid)}))
        self.running[process] = (state, folder, time.monotonic())

    def finish(self, process):
        """Write the record of a state that has ended."""
        state, folder, begun = self.running.pop(process)
        record = {
            "key": self.key(state), "asked": self.asked, "status": "finished",
            "parameters": state.parameters,
            "runTime": time.monotonic() - begun,
        }
        if process.returncode:
            i = min(max(process.returncode, 1), len(self.commands))
            command = self.commands[i - 1].split()[0]
            log = folder/self.logs[i - 1]
            record["status"] = f"failed: {command}: {fatal(log)}"
        else:
            try:
                record["results"] = results.collect(
                    self.study, folder, state.parameters)
            except (StudyError, results.tables.TableError) as error:
                record["status"] = f"failed: {error}"
        self._write(folder, record)
        (folder/RUNNING).unlink()
        self.records[state.name] = record
        self.times.append(record["runTime"])
        self.write_table()
        return state, record

    def stop(self):
        """End all that runs."""
        for process in self.running:
            os.killpg(process.pid, signal.SIGKILL)

    def write_table(self):
        results.write_table(self.table, self.states, self.records)

    def time_left(self, n, jobs):
        """About how long n states will take [s], by the mean of those done."""
        return sum(self.times)/max(len(self.times), 1)*n/jobs

    def run(self, jobs, retry=False, say=print):
        """Run all that has no record; returns the number that failed."""
        self.lock()
        todo = self.load(retry)
        done, total = len(self.states) - len(todo), len(self.states)
        if done:
            say(f"{done} of {total} states are there already")
        queue = list(reversed(todo))
        try:
            while queue or self.running:
                while queue and len(self.running) < jobs:
                    self.start(queue.pop())
                ended = [p for p in self.running if p.poll() is not None]
                for process in ended:
                    state, record = self.finish(process)
                    done += 1
                    left = self.time_left(total - done, jobs)
                    say(f"{done} of {total}: {state.name} {record['status']}"
                        f" in {record['runTime']:.3g} s"
                        + (f", about {duration(left)} left"
                           if done < total else ""))
                if not ended:
                    time.sleep(0.02)
        finally:
            self.stop()
        self.write_table()
        return sum(r["status"] != "finished" for r in self.records.values())


def duration(seconds):
    """Time in words."""
    for size, unit in ((86400, "days"), (3600, "h"), (60, "min")):
        if seconds >= 1.5*size:
            return f"{seconds/size:.1f} {unit}"
    return f"{seconds:.0f} s"
