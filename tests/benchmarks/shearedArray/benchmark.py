# SPDX-License-Identifier: GPL-3.0-or-later
"""Square array of free discs in shear, in a box that slides (Lees & Edwards).

On its own, any fraction and shifts, with etc/bashrc sourced:

    $GRAINFOAM_PYTHON benchmark.py --fraction 0.3 --cells 16 --shift 0.1 0.4
"""

import argparse
import math
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parents[1]/"regression")]

from measure import Run, set_stokes, set_viscosity
from slidingBox import (
    centres, set_stress, set_velocity, sliding_box, stress,
)

# Effective over own viscosity, and spin over the shear rate, by fraction and
# shift over the side
EXACT = {
    0.1: {
        0: (1.19222419, -0.5), 0.25: (1.20140731, -0.494998374),
        0.5: (1.20999258, -0.490202004),
    },
    0.24: {
        0: (1.46535637, -0.5), 0.25: (1.51942958, -0.487002787),
        0.5: (1.56648162, -0.475185624),
    },
    0.4: {
        0: (1.8679657, -0.5), 0.25: (2.0673313, -0.47636135),
        0.5: (2.22104425, -0.45572855),
    },
}
SHIFTS = (0, 0.25, 0.5)
# Side and shear rate are 1. Viscosity: Re = 1/NU; time step; shift at the start
NU, STEP, START = 200, 0.005, -0.1


class Array:
    """A disc in a box of n x n cells, about D/h of them per diameter."""

    def __init__(self, fraction, cells, place=(0.5, 0.5)):
        self.fraction = fraction
        self.radius = math.sqrt(fraction/math.pi)
        self.n = round(cells/(2*self.radius))
        self.D_over_h = round(2*self.radius*self.n, 2)
        self.place = place

    def solve(self, folder, shifts):
        """The run, with the fields at the times of these shifts."""
        times = [shift - START for shift in shifts]
        settings = f"{self.fraction:g}"
        name = f"array_{self.fraction:g}_{self.n}_{self.place[1]:g}"
        case = sliding_box(folder, name, (self.n, self.n), shift=START)
        set_stokes(case)
        set_viscosity(case, NU)
        x = centres((self.n, self.n), (1, 1))
        velocity = 0*x
        velocity[:, 0] = x[:, 1] - 0.5
        set_velocity(case, velocity)
        # Off the mesh, but for rounding where the box is cut
        at = [place + 0.3/self.n for place in self.place]
        speed = self.place[1] - 0.5
        case.bodies(f"""
            disc
            {{
                shape       {{ type disc; radius {self.radius:.15g}; }}
                densityRatio 1;
                position    ({at[0]:.15g} {at[1]:.15g} 0);
                velocity    ({speed:.15g} 0 0);
                angularVelocity (0 0 -0.5);
            }}
        """)
        case.controls(endTime=f"{max(times):.12g}", deltaT=f"{STEP:.12g}")
        set_stress(case)
        return Run(case, settings, self.D_over_h, self.n**2), case

    def figures(self, folder, shifts):
        """Rows, for each shift."""
        run, case = self.solve(folder, shifts)
        motion = case.table("motion")
        viscosity = stress(case)["viscosity"]/NU
        for shift in shifts:
            time = shift - START
            step = round(time/STEP) - 1
            spin = motion["angularVelocity_z"][step]
            exact = EXACT.get(self.fraction, {}).get(shift, (None, None))
            name = f"{self.fraction:g}, shift {shift:g}"
            run.settings = name
            if self.place[1] != 0.5:
                run.settings += ", across"
            yield run.row("viscosity", viscosity[step], exact[0])
            yield run.row("spin", spin, exact[1])


def rows(folder, quick):
    for fraction in EXACT:
        for cells in (8, 16) if quick else (8, 16, 32):
            yield from Array(fraction, cells).figures(folder, SHIFTS)
        # Discs that the sliding patches cut
        for cells in (8, 16):
            array = Array(fraction, cells, (0.5, 0.9))
            yield from array.figures(folder, SHIFTS)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--fraction", type=float, required=True)
    parser.add_argument("--cells", type=float, default=16, help="D/h")
    parser.add_argument(
        "--shift", type=float, nargs="+", default=SHIFTS,
        help="over the side, multiples of 0.005",
    )
    args = parser.parse_args()
    from report import Report

    report = Report("shearedArray", HERE.parent/"results")
    with tempfile.TemporaryDirectory() as folder:
        array = Array(args.fraction, args.cells)
        for row in array.figures(folder, args.shift):
            report.add(row)


if __name__ == "__main__":
    main()
