# SPDX-License-Identifier: GPL-3.0-or-later
"""The function object opticalSensor in a BodyCase, and what it writes.

    add_sensor(case, "middle { point (0 0 0); normal (1 0 0); }", "rate 5;")
    case.solve()
    rows = passages(case)
    table(case, "1", "summary")["misses"]
"""

import re
from dataclasses import dataclass

import numpy as np

SENSOR = """functions
{{
    sensor
    {{
        type            opticalSensor;
        libs            (immersedBodyFunctionObjects);
        writePrecision  16;
        {entries}
        planes
        {{
            {planes}
        }}
    }}"""


def add_sensor(case, planes, entries=""):
    case.replace(
        "system/controlDict", "functions\n{",
        SENSOR.format(planes=planes, entries=entries),
    )


@dataclass
class Passage:
    """A row of the table of passages."""

    time: float
    body: int
    velocity: np.ndarray
    axial: float
    radius: float
    angle: float
    direction: int
    interval: float
    spacing: float
    signal: int
    plane: str
    name: str


def passages(case, plane=None):
    """Rows of all parts of a run, or those of one plane."""
    rows = []
    folder = case.path / "postProcessing/sensor"
    for file in sorted(
        folder.glob("*/passages.dat"), key=lambda f: float(f.parent.name)
    ):
        for line in file.read_text().splitlines():
            if line.startswith("#"):
                continue
            w = line.split()
            x = np.array(w[:13], dtype=float)
            rows.append(Passage(
                x[0], int(x[2]), x[3:6], x[6], x[7], x[8], int(x[9]), x[10],
                x[11], int(x[12]), *w[13:],
            ))
    return [row for row in rows if plane in (None, row.plane)]


def table(case, time, name):
    """Columns of the statistics of a time by their names without units."""
    file = case.path / f"postProcessing/sensor/{time}/{name}.dat"
    lines = file.read_text().splitlines()
    (header,) = (line for line in lines if line.startswith("# plane"))
    rows = [line.split() for line in lines if not line.startswith("#")]
    columns = {}
    for column, values in zip(header.split()[1:], zip(*rows, strict=True)):
        kind = str if column == "name" else float
        columns[re.sub(r"\[.*", "", column)] = np.array(values, dtype=kind)
    return columns
