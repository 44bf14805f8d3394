# SPDX-License-Identifier: GPL-3.0-or-later
"""The function object opticalSensor in a BodyCase, and what it writes.

    add_sensor(case, "middle { point (0 0 0); normal (1 0 0); }", "rate 5;")
    case.solve()
    rows = passages(case)
    table(case, "1", "summary")["misses"]
"""

from dataclasses import dataclass

import numpy as np

from foamCase import tables

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
    columns = tables.run_columns(case.path, "sensor", "passages")
    rows = [
        Passage(x[0], x[2], np.array(x[3:6]), *x[6:])
        for x in zip(*columns.values())
    ]
    return [row for row in rows if plane in (None, row.plane)]


def table(case, time, name):
    """Columns of the statistics of a time by their names without units."""
    file = case.path / f"postProcessing/sensor/{time}/{name}.dat"
    return tables.read_columns(file)
