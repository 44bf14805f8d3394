# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the tables that a run has written to postProcessing.

    from grainfoam import tables              # etc/bashrc sets PYTHONPATH

    motion = tables.read_tables("case", "motion")
    grain = motion[motion["name"] == "grain1"]
    grain.plot("time", "velocity_x")          # with pandas
    motion.attrs["units"]["velocity_x"]       # "m/s"

A pandas.DataFrame where there is pandas, else a structured array of numpy,
which is indexed in the same way. A row per time, or per time and body; columns
have their names without units, those of vectors in brackets end in _x, _y, _z.
A column `name` has the names of the bodies. read_table reads one file, and
read_columns and run_columns do the same without pandas: {column: values}.

Of a run in several parts a restart replaces what earlier parts have after its
start.
"""

import pathlib
import re
import warnings

import numpy as np

INTEGERS = {"body", "plane", "direction", "signal", "state"}
COMPONENTS = {3: "xyz", 6: ("xx", "xy", "xz", "yy", "yz", "zz"),
              9: ("xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz")}


class TableError(Exception):
    """A table is missing or is none."""


def _header(file):
    """Names of the columns as they are in the file, {number: body or plane},
    and the first row, None if there is none."""
    names, things, first = [], {}, None

    with open(file) as lines:
        for line in lines:
            if not line.startswith("#"):
                first = first or line.strip() or None
                continue
            text = line.strip("# \n")
            numbered = re.fullmatch(r"(\d+)\s*:\s*(\S+)", text)
            if numbered:
                things[int(numbered[1])] = numbered[2]
            elif first is None:
                names = text.split("\t" if "\t" in text else None)

    return [name.strip() for name in names], things, first


def _words(line):
    """Words of a row; what is in brackets is one."""
    return re.findall(r"\([^()]*\)|\S+", line)


def _expanded(names, row):
    """Names of the columns with those of the components of vectors."""
    all_names = []
    for name, word in zip(names, row):
        n = len(word.strip("()").split())
        bare, unit, end = name.partition("[")
        all_names += [name] if n == 1 else [
            f"{bare}_{component}{unit}{end}" for component in COMPONENTS[n]]
    return all_names


def _rows(file):
    """Values of all columns: arrays of numbers, or of words."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return np.loadtxt(file, ndmin=2).T
    except ValueError:
        with open(file) as lines:
            rows = [re.sub("[()]", " ", line).split() for line in lines
                    if line.strip() and not line.startswith("#")]
        return [_numbers(column) for column in zip(*rows)]


def _numbers(words):
    try:
        return np.array(words, dtype=float)
    except ValueError:
        return np.array(words, dtype=object)


def _read(file):
    """{column with unit: values} of a file."""
    names, things, first = _header(file)
    if first is None:
        columns = {name: np.empty(0) for name in names}
    else:
        row = _words(first)
        if len(row) != len(names):
            raise TableError(f"{file}: {len(names)} columns in the header,"
                             f" {len(row)} in the first row")
        columns = dict(zip(_expanded(names, row), _rows(file)))

    for name in INTEGERS & columns.keys():
        columns[name] = columns[name].astype(int)
    if "body" in columns and things and "name" not in columns \
            and "plane" not in columns:
        name_of = np.full(max(things) + 1, "", dtype=object)
        name_of[list(things)] = list(things.values())
        columns["name"] = name_of[columns["body"]]
    return columns


def _without_units(columns):
    """{column: values} and {column: unit}. OpenFOAM's Time is time, in s."""
    bare, units = {}, {}
    for name, values in columns.items():
        split = re.fullmatch(r"(.*?)(?:\[(.*)\])?", name)
        name = "time" if split[1] == "Time" else split[1]
        bare[name] = values
        if split[2] or name == "time":
            units[name] = split[2] or "s"
    return bare, units


def _frame(columns):
    """As a DataFrame or a structured array."""
    columns, units = _without_units(columns)
    try:
        import pandas
    except ImportError:
        pairs = [(name, values.dtype) for name, values in columns.items()]
        array = np.empty(len(next(iter(columns.values()), ())), dtype=pairs)
        for name, values in columns.items():
            array[name] = values
        return array
    frame = pandas.DataFrame(columns)
    frame.attrs["units"] = units
    return frame


def table_files(case, function_object, table=None):
    """The files of a table, in the order of the starts of the parts of the run.
    Without a name of the table: of the only one that there is."""
    folder = pathlib.Path(case)/"postProcessing"/function_object
    if not folder.is_dir():
        there = sorted(f.name for f in folder.parent.glob("*") if f.is_dir())
        raise TableError(f"{folder} is not there; of function objects there"
                         f" are: {' '.join(there) or 'none'}")
    if table is None:
        tables = sorted({re.sub(rf"_{re.escape(f.parent.name)}$", "", f.stem)
                         for f in folder.glob("*/*.dat")})
        if len(tables) != 1:
            raise TableError(f"{folder}: which table? It has"
                             f" {' '.join(tables) or 'none'}")
        table = tables[0]

    files = []
    for start in sorted(folder.glob("*/"), key=_start):
        # Of a part that was begun twice the second file has its start in its name
        both = [start/f"{table}_{start.name}.dat", start/f"{table}.dat"]
        both = [file for file in both if file.is_file()]
        files += [f for f in both if _header(f)[2] is not None][:1] or both[:1]
    return files


def _start(folder):
    try:
        return float(folder.name)
    except ValueError:
        return np.inf


def _joined(files):
    """Parts of a run, each up to the start of the next one."""
    parts = []
    for file, following in zip(files, [*files[1:], None]):
        part = _read(file)
        time = part.get("time[s]", part.get("Time"))
        if time is None:
            if len(files) > 1:
                raise TableError(f"{file}: no column of the time")
            return part
        end = _start(following.parent) if following else np.inf
        parts.append({n: values[time <= end] for n, values in part.items()})

    # Tables that were empty do not know their vectors
    names = next((p for p in parts if len(next(iter(p.values())))), parts[0])
    return {name: np.concatenate([p[name] for p in parts if name in p])
            for name in names}


def _run(case, function_object, table):
    files = table_files(case, function_object, table)
    if not files:
        folder = pathlib.Path(case)/"postProcessing"/function_object
        raise TableError(f"{folder} has no table {table}: has it been run?")
    return _joined(files)


def read_columns(file):
    """{column: values} of one file."""
    return _without_units(_read(file))[0]


def run_columns(case, function_object, table=None):
    """{column: values} of all parts of a run."""
    return _without_units(_run(case, function_object, table))[0]


def read_table(file):
    """One file."""
    return _frame(_read(file))


def read_tables(case, function_object, table=None):
    """A table of a function object, by its name in system/controlDict, of all
    parts of a run. table: name of the file, needed if there are several."""
    return _frame(_run(case, function_object, table))
