# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers that a study takes from the tables of a state, and its own table."""

import csv
import io
import os

import numpy as np

from .. import tables
from .states import evaluate

REDUCTIONS = {
    "last": lambda v: v[-1],
    "first": lambda v: v[0],
    "mean": np.mean,
    "min": np.min,
    "max": np.max,
    "change": lambda v: v[-1] - v[0],
}


def check(study):
    """Refuse wrong entries of `results`."""
    for content in study.dictionaries("results").values():
        content.check({"table", "column", "body", "value", "from", "expression"})
        if ("expression" in content) == ("table" in content):
            raise content.error("needs either 'table' and 'column', or"
                                " 'expression'")
        if "table" in content:
            content.get("column")
            content.choice("value", REDUCTIONS, "last")


def value(content, folder, names):
    """One result of the state in the folder. names: parameters, and results
    before it."""
    if "expression" in content:
        return float(evaluate(content.get("expression"), names, content))

    function_object, _, table = str(content.get("table")).partition("/")
    columns = tables.run_columns(folder, function_object, table or None)
    column = content.get("column")
    if column not in columns:
        raise content.error(f"{content.get('table')} of {folder} has no column"
                            f" '{column}', but {' '.join(columns)}")

    chosen = np.full(len(columns[column]), True)
    if "body" in content:
        chosen &= columns["name"] == content.get("body")
    if "from" in content:
        chosen &= columns["time"] >= content.number("from")
    if not chosen.any():
        raise content.error(f"{content.get('table')} of {folder} has no such"
                            " rows")
    return float(REDUCTIONS[content.get("value", "last")](
        columns[column][chosen]))


def collect(study, folder, parameters):
    """{name: number} of all results of the state in the folder."""
    names = dict(parameters)
    found = {}
    for name, content in study.dictionaries("results").items():
        found[name] = names[name] = value(content, folder, names)
    return found


def write_atomic(file, text):
    """Replace a file by one that is complete, whenever the machine stops."""
    file.parent.mkdir(parents=True, exist_ok=True)
    part = file.with_name(f".{file.name}.{os.getpid()}")
    with open(part, "w") as stream:
        stream.write(text)
        stream.flush()
        os.fsync(stream.fileno())
    os.replace(part, file)


def write_table(file, states, records):
    """A row per state that has a record: its parameters, status, run time [s]
    and results."""
    parameters = list(dict.fromkeys(n for s in states for n in s.parameters))
    results = list(dict.fromkeys(
        n for r in records.values() for n in r.get("results", {})))
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(["state", *parameters, "status", "runTime", *results])
    for state in states:
        record = records.get(state.name)
        if record:
            rows.writerow([
                state.name, *(state.parameters.get(n, "") for n in parameters),
                record["status"], f"{record['runTime']:.2f}",
                *(repr(record["results"][n]) if n in record.get("results", {})
                  else "" for n in results)])
    write_atomic(file, text.getvalue())


def read_table(file):
    """{column: values} of the states that finished; words if not numbers."""
    with open(file, newline="") as stream:
        rows = [row for row in csv.DictReader(stream)
                if row["status"] == "finished"]
    columns = {}
    for name in rows[0] if rows else ():
        words = [row[name] for row in rows]
        try:
            columns[name] = np.array(words, dtype=float)
        except ValueError:
            columns[name] = np.array(words, dtype=object)
    return columns
