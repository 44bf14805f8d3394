# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres that settle in a triply periodic box without net volume flux.

On its own, any box, with etc/bashrc sourced:

    $GRAINFOAM_PYTHON benchmark.py --reynolds 20 --fraction 0.2 --number 8
"""

import argparse
import math
import sys
import tempfile
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parents[1]/"regression")]

import boxMesh
import stream
from bodyCase import BodyCase
from boxMesh import graded
from measure import Run, driving_force, set_viscosity
from settlingBox import random_centres, settling_box

# D = 1, gravity along x; the speed of one sphere is about 1
RATIO, CELLS = 2, 8
FRACTIONS = 0.1, 0.2
# Time to forget the start, and end, by the Reynolds number
TIMES = {1: (5, 20), 20: (10, 30)}
# Numbers of spheres, and random places (seeds) of each, by the Reynolds number
BOXES = {1: {27: (1,)}, 20: {8: (1, 2), 27: (1, 2), 64: (1,)}}
# Blocks of the time mean
BLOCKS = 5
# Window of the single sphere: width, ahead, behind
WIDTH, AHEAD, BEHIND = 30, 12, 30
# Contact: the entries of its type
CONTACTS = {
    "inelastic": "",
    "softSphere": "restitution 0.88; friction 0; collisionTime 0.05;",
}


def weight(reynolds):
    """Gravity (r - 1) g with which one sphere has about the speed 1, by the
    drag of Schiller & Naumann."""
    return 18/reynolds*(1 + 0.15*reynolds**0.687)


def clift_speed(reynolds):
    """Speed of one sphere by the drag of Clift, Grace & Weber, Re 0.01 to 20;
    reynolds: for the speed 1."""
    speed = 1
    for _ in range(200):
        re = reynolds*speed
        factor = 1 + 0.1315*re**(0.82 - 0.05*math.log10(re))
        speed = weight(reynolds)*reynolds/18/factor
    return speed


def exponent(reynolds):
    """Of Garside & Al-Dibouni: (5.1 - n)/(n - 2.7) = 0.1 Re^0.9."""
    x = 0.1*reynolds**0.9
    return (5.1 + 2.7*x)/(1 + x)


def stokes_correction(fraction, number):
    """Of the speed over that of one sphere, for an infinite box: Stokes flow,
    hard spheres in equilibrium (Ladd 1990)."""
    compressibility = (1 - fraction)**4/(
        (1 + 2*fraction)**2 + fraction**3*(fraction - 4)
    )
    viscosity = 1 + 2.5*fraction + 6*fraction**2
    return 1.7601*compressibility/viscosity*(fraction/number)**(1/3)


class Box:
    """What a box of spheres may differ in: solid fraction (about), number,
    random places, D/h, contact, Courant number of the speed of one sphere."""

    def __init__(
        self, fraction, number=27, seed=1, cells=CELLS, contact="inelastic",
        courant=1,
    ):
        self.number = number
        self.seed = seed
        self.cells = cells
        self.contact = contact
        self.step = courant/cells
        self.n = round(cells*(number*math.pi/(6*fraction))**(1/3))
        self.side = self.n/cells
        self.fraction = number*math.pi/(6*self.side**3)

    def name(self):
        name = f"fraction {self.fraction:.3f}, {self.number}"
        name += f", seed {self.seed}"
        if self.cells != CELLS:
            name += f", D/h {self.cells}"
        if self.contact != "inelastic":
            name += f", {self.contact}"
        if self.step != 1/self.cells:
            name += f", Courant {self.step*self.cells:g}"
        return name


def box_case(folder, name, reynolds, box):
    """A periodic box of spheres at rest."""
    return settling_box(
        folder, name, box.n, box.side,
        random_centres(box.number, box.side, 0.1, box.seed),
        1/reynolds, weight(reynolds)/(RATIO - 1), RATIO,
        f"contact {{ type {box.contact}; {CONTACTS[box.contact]} }}",
    )


def suspension(folder, reynolds, box, single, quick=False):
    """Rows of a suspension."""
    begin, end = TIMES[reynolds]
    end = begin + 5 if quick else end
    name = f"Re_t {reynolds:g}, {box.name()}"
    place = name.replace(" ", "_").replace("/", "")
    case = box_case(folder, place, reynolds, box)
    case.controls(endTime=f"{end:g}", deltaT=f"{box.step:.12g}")
    run = Run(case, name, box.cells, box.n**3, may_fail=True)
    if run.failed:
        yield run.diverged()
        return

    motion = case.columns("motion")
    time, speed = motion["time"], motion["velocity_x"]
    times = np.unique(time)
    means = speed.reshape(len(times), box.number).mean(axis=1)
    late = times > begin
    value = means[late].mean()/single
    blocks = [b.mean()/single for b in np.array_split(means[late], BLOCKS)]
    error = np.std(blocks, ddof=1)/math.sqrt(BLOCKS)

    terminal = reynolds*single
    law = (1 - box.fraction)**exponent(terminal)
    yield run.row("speed/single", value, law)
    yield run.row("statistical error", error)
    yield run.row("prefactor of Richardson-Zaki", value/law)
    yield run.row("exponent without prefactor",
                  math.log(value)/math.log(1 - box.fraction))
    if reynolds <= 1:
        more = value + stokes_correction(box.fraction, box.number)
        yield run.row("speed/single, infinite box", more, law)
        yield run.row("prefactor, infinite box", more/law)

    # Without walls the mean force balances the weight of the spheres
    force = driving_force(case)[-late.sum():].mean()
    balance = -box.fraction*weight(reynolds)
    yield run.row("force/weight", force/balance, 1)
    yield run.row("not converged", run.steps - run.converged)
    yield run.row("outers, mean", np.mean(run.outers))


def single_sphere(folder, reynolds):
    """Row of one sphere in a wide window, and its speed."""
    h = 1/CELLS
    case = BodyCase("tube", folder, f"single_{reynolds:g}")
    case.conditions(stream.velocity(0), stream.P)
    core = h*round(0.9/h)
    across = graded(0, 0.5*WIDTH, (0, core), h)
    along = graded(-BEHIND, AHEAD, (-h*round(1.2/h), core), h)
    n = boxMesh.write(case, along, across, across, {
        "inlet": "x+", "outlet": "x-", "sides": "y+ z+",
        "middleY": "y-", "middleZ": "z-",
    })
    for plane in ("middleY", "middleZ"):
        case.set_symmetry(plane)
    case.run("blockMesh")
    set_viscosity(case, 1/reynolds)
    case.gravity(weight(reynolds)/(RATIO - 1))
    case.bodies(f"""
        sphere
        {{
            shape       {{ type sphere; radius 0.5; }}
            densityRatio {RATIO};
            position    (0 0 0);
            velocity    (1 0 0);
            angularVelocity (0 0 0);
        }}
    """, "window { type comoving; direction (1 0 0); }")
    case.controls(endTime="30", deltaT=f"{h:.12g}")
    run = Run(case, f"Re_t {reynolds:g}, one sphere", CELLS, n)
    speed = case.table("motion")["velocity_x"][-1]
    return run.row("speed", speed, clift_speed(reynolds)), speed


def boxes(reynolds, quick):
    """Of one Reynolds number."""
    if quick:
        return [Box(FRACTIONS[1])]
    return [
        Box(fraction, number, seed)
        for fraction in FRACTIONS
        for number, seeds in BOXES[reynolds].items()
        for seed in seeds
    ]


def rows(folder, quick):
    for reynolds in TIMES:
        row, single = single_sphere(folder, reynolds)
        yield row
        for box in boxes(reynolds, quick):
            yield from suspension(folder, reynolds, box, single, quick)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument(
        "--reynolds", type=int, choices=TIMES, required=True,
        help="of one sphere, about",
    )
    parser.add_argument(
        "--fraction", type=float, required=True, help="of solid, about"
    )
    parser.add_argument("--number", type=int, default=27, help="of spheres")
    parser.add_argument("--seed", type=int, default=1, help="of the places")
    parser.add_argument("--cells", type=int, default=CELLS, help="D/h")
    parser.add_argument("--contact", choices=CONTACTS, default="inelastic")
    parser.add_argument(
        "--courant", type=float, default=1, help="by the speed of one sphere"
    )
    args = parser.parse_args()
    box = Box(
        args.fraction, args.number, args.seed, args.cells, args.contact,
        args.courant,
    )
    from report import Report

    report = Report("hinderedSettling", HERE.parent/"results")
    with tempfile.TemporaryDirectory() as folder:
        row, single = single_sphere(folder, args.reynolds)
        report.add(row)
        for row in suspension(folder, args.reynolds, box, single):
            report.add(row)


if __name__ == "__main__":
    main()
