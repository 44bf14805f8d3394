# SPDX-License-Identifier: GPL-3.0-or-later
"""The map of one disc by its height y: by the Stokes modes, and at finite Re
from the lift on a disc that is held. As a program: the states of the modes, to
modes/system/stokesModesDict. All are even or odd in y, and y < 0 is computed."""

import pathlib
import re

import numpy as np

from grainfoam import tables  # source etc/bashrc of grainFoam
from grainfoam.study import results

here = pathlib.Path(__file__).resolve().parent

HEIGHTS = np.linspace(-0.9, -0.02, 45)


def modes():
    """Columns of the modes, by height."""
    columns = tables.run_columns(here/"modes", "stokesModes")
    return {name: values for name, values in columns.items()}


def lateral():
    """Heights and lateral velocity over Re: {Re: (y, velocity)}, 0 being the
    limit; at finite Re the lift over the resistance."""
    stokes = modes()
    found = {0: (stokes["py0"], stokes["V1_y0"])}
    held = results.read_table(here/"window/postProcessing/held.csv")
    for Re in dict.fromkeys(held["Re"]):
        rows = held["Re"] == Re
        y = held["y"][rows]
        resistance = np.interp(y, stokes["py0"], stokes["A_y0_y0"])
        found[Re] = y, held["lift"][rows]/resistance
    return found


def arrivals():
    """Heights and lateral velocity over Re of free discs in time, in the second
    half of their runs, in which they settle: {Re: (y, velocity)}"""
    found = {}
    for case in sorted((here/"window/near").glob("Re*")):
        Re = float(re.match(r"Re([\d.]+)", case.name)[1])
        motion = tables.run_columns(case, "motion")
        late = motion["time"] > 0.5*motion["time"][-1]
        found.setdefault(Re, []).append(
            (motion["position_y"][late], motion["velocity_y"][late]/Re))
    return {Re: np.hstack(runs) for Re, runs in found.items()}


def main():
    rows = "\n".join(f"    ((0 {y:.6g} 0))" for y in HEIGHTS)
    (here/"modes/system/stokesModesDict").write_text(
        "FoamFile\n{\n    version     2.0;\n    format      ascii;\n"
        "    class       dictionary;\n    object      stokesModesDict;\n}\n\n"
        f"states\n(\n{rows}\n);\n\n"
        "drive { direction (1 0 0); meanVelocity 1; }\n")


if __name__ == "__main__":
    main()
