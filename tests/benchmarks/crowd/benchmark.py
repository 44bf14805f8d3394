# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres that begin to settle in a periodic box: time per step.

On its own, any crowd, with etc/bashrc sourced:

    benchmark.py --spheres 500 --box 96 --cells 8 --steps 20 --ratio 2

Spheres lighter than the fluid, --ratio below 1, rise.
"""

import argparse
import math
import re
import sys
import tempfile
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parents[1]/"regression")]

from measure import LOCKED, Run  # noqa: E402
from report import Report  # noqa: E402
from settlingBox import random_centres, settling_box  # noqa: E402

# D = 1, sqrt((r - 1) g D) = 1, along x
RATIO, GALILEI = 2, 40
# Courant number of a speed of 0.5, about that in the end
COURANT = 0.5
# Smallest gap at the start, over D
GAP = 0.05
# Spheres, cells per side and per diameter
CROWDS = ((500, 96, 8), (253, 96, 10), (570, 128, 10))
QUICK = ((62, 48, 8),)
# The same places on coarse meshes and a fine one
COMPARED = (148, ((64, 8), (48, 6), (32, 4)), (128, 16))
STEPS = 20


def crowd(
    folder, name, centres, box, cells, steps, fixed=False, coupling="",
    ratio=RATIO, contact="type inelastic;", row=1,
):
    """A case of spheres in a cube of box cells a side, or in a row of them
    along x."""
    case = settling_box(
        folder, name, box, box/cells, centres, 1/GALILEI, 1/(ratio - 1),
        ratio, f"contact {{ {contact} }} {coupling}",
        LOCKED if fixed else "", row,
    )
    dt = COURANT/(0.5*cells)
    case.controls(endTime=f"{steps*dt:.12g}", deltaT=f"{dt:.12g}")
    return case


def step_times(case):
    """Processor time of each step [s]."""
    log = (case.path/"log.foamRun").read_text()
    times = re.findall(r"ExecutionTime = (\S+) s", log)
    return np.diff(np.array(times, dtype=float))


def speeds(case, number):
    """Velocities along gravity at the end, sphere by sphere."""
    return case.columns("motion")["velocity_x"][-number:]


def fixed_step(folder, box, cells):
    """Seconds per step with one fixed sphere."""
    case = crowd(
        folder, f"fixed_{box}_{cells}", np.full((1, 3), 0.5*box/cells),
        box, cells, 8, fixed=True,
    )
    Run(case, "one fixed sphere", cells, box**3)
    return np.median(step_times(case)[2:])


def solve(folder, number, box, cells, steps, coupling="", ratio=RATIO):
    """The run, and the velocities at the end."""
    centres = random_centres(number, box/cells, GAP, 1)
    case = crowd(
        folder, f"crowd_{number}_{box}", centres, box, cells, steps,
        coupling=coupling, ratio=ratio,
    )
    fraction = number*math.pi/6*(cells/box)**3
    name = f"{number} spheres, {box}^3, fraction {fraction:.3f}"
    if ratio != RATIO:
        name += f", ratio {ratio:g}"
    run = Run(case, name, cells, box**3)
    return run, step_times(case), speeds(case, number)


def figures(folder, number, box, cells, steps=STEPS, ratio=RATIO):
    """Rows of one crowd."""
    one = fixed_step(folder, box, cells)
    run, times, velocity = solve(
        folder, number, box, cells, steps, ratio=ratio
    )
    late = slice(steps//2, None)
    step = np.median(times[late])
    yield run.row("s per step, second half", step)
    yield run.row("that over one fixed sphere", step/one)
    yield run.row("ns per cell and step", 1e9*step/run.cells)
    yield run.row("outers, first step", run.outers[0])
    yield run.row("outers, second half", np.mean(run.outers[late]))
    yield run.row("outers, mean", np.mean(run.outers))
    yield run.row("outers, largest", max(run.outers))
    yield run.row("not converged", run.steps - run.converged)
    yield run.row("mean velocity", velocity.mean())


def compared(folder):
    """Rows of the same spheres and time on coarse meshes against a fine one."""
    number, coarse, fine = COMPARED

    def speeds_on(box, cells):
        steps = STEPS*cells//coarse[0][1]
        run, _, velocity = solve(folder, number, box, cells, steps)
        return run, velocity

    best, reference = speeds_on(*fine)
    yield best.row("mean velocity", reference.mean())
    for mesh in coarse:
        run, velocity = speeds_on(*mesh)
        yield run.row("mean velocity", velocity.mean(), reference.mean())
        error = math.sqrt(((velocity - reference)**2).mean())
        yield run.row(
            "rms error of a sphere, %", 100*error/abs(reference.mean())
        )


def rows(folder, quick):
    for number, box, cells in QUICK if quick else CROWDS:
        yield from figures(folder, number, box, cells)
    if not quick:
        yield from compared(folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--spheres", type=int, default=500)
    parser.add_argument("--box", type=int, default=96, help="cells per side")
    parser.add_argument(
        "--cells", type=int, default=8, help="per diameter"
    )
    parser.add_argument("--steps", type=int, default=STEPS)
    parser.add_argument(
        "--ratio", type=float, default=RATIO, help="of densities; not 1"
    )
    args = parser.parse_args()
    if args.ratio <= 0 or args.ratio == 1:
        parser.error(f"--ratio {args.ratio:g}: above 0, and not 1")
    with tempfile.TemporaryDirectory() as scratch:
        report = Report("crowd", Path(scratch))
        for row in figures(
            Path(scratch), args.spheres, args.box, args.cells, args.steps,
            args.ratio,
        ):
            report.add(row)


if __name__ == "__main__":
    main()
