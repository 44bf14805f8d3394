# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs in which ranks have their own bodies."""

from xml.etree import ElementTree

import numpy as np

from bodyCase import BodyCase

SURFACES = """functions
{
    surfaces
    {
        type    immersedBodySurfaces;
        libs    (immersedBodyFunctionObjects);
        writeControl writeTime;
    }
"""


def surfaces(case):
    """Arrays of the surfaces at all times."""
    return [
        np.array(array.text.split(), float)
        for file in sorted(case.path.glob("postProcessing/surfaces/*.vtp"))
        for array in ElementTree.parse(file).iter("DataArray")
    ]


def write_twice(case, step, steps):
    """Run so many steps, and write in the middle and at the end, tables as
    well."""
    case.controls(
        deltaT=step, endTime=step*steps, writeControl="timeStep",
        writeInterval=steps//2, writeFormat="ascii", writePrecision=17,
        timePrecision=15,
    )
    path = case.path/"system/controlDict"
    path.write_text(
        path.read_text().replace(
            "writeControl    timeStep;\n        writePrecision",
            "writeControl    writeTime;\n        writePrecision",
        )
    )


def motions(case):
    """Velocities, spins and positions in all time steps, by time and body."""
    table = case.columns("motion")
    order = np.lexsort((table["body"], table["time"]))
    return np.array([
        table[f"{name}_{axis}"][order]
        for name in ("position", "velocity", "angularVelocity")
        for axis in "xyz"
    ])


def run_in_parts(at_once, folder, step, steps, n):
    """Run a case on four ranks, in n parts along the axes, at once, and as a
    copy that stops and goes on in the middle, from binary files. Returns the
    copy."""
    at_once.controls(writeFormat="binary")
    at_once.decompose(4, n)
    parts = BodyCase(at_once, folder, "parts")
    at_once.solve(4)
    for end in (step*steps/2, step*steps):
        parts.controls(endTime=end)
        assert "Bodies are spread over the ranks" in parts.solve(4)
    return parts
