# SPDX-License-Identifier: GPL-3.0-or-later
"""waLBerla (walberla.net): lattice Boltzmann, moving bounce-back walls.

The program is SettlingSphereInBox of its apps/benchmarks/FluidParticleCoupling,
which has the four fluids, the box and the sphere of ten Cate built in and takes
the rest from its command line. Results are read from the table that it writes
after each step. Its sphere starts a quarter of a diameter higher than in the
experiment and goes on until it touches the bottom. If it turns back before, the
run has failed, as with the kernels that GeneratedLBM.py makes as it is: see
the README of the league. Built without these the program is right."""

import numpy as np

from measure import Result
from peers.given import PeerError, run

SOLVER = "waLBerla"
VARIABLE = "LEAGUE_WALBERLA"
MISSING = {
    "crowd": "none of its programs takes the places of spheres",
    "fluid": "its step is not one of a projection method",
}
# Blocks that its box is divided into along gravity
BLOCKS = 4
# Of the sphere in lattice units
VELOCITY = 0.05
# Gap over the diameter below which it is at the bottom
BOTTOM = 0.1


def resolution(scene):
    """Cells across the box: nearest at which its blocks are equal."""
    wanted = scene.cells*scene.width/scene.diameter

    def fits(n):
        return int(n*scene.height/scene.width + 0.5) % BLOCKS == 0

    choices = [n for n in range(8, 2*round(wanted) + 16) if fits(n)]
    return min(choices, key=lambda n: abs(n - wanted))


def arguments(scene):
    """Of its command line."""
    return [
        "--fluidType", scene.name[1:], "--resolution", str(resolution(scene)),
        "--velocity", str(VELOCITY), "--baseFolder", "results",
    ]


def read_table(folder):
    """Times [s], gaps over the diameter and velocities [m/s] downwards."""
    files = list((folder/"results").glob("LoggingSettlingSphere_*.txt"))
    if len(files) != 1:
        raise PeerError(f"{SOLVER} wrote {len(files)} tables, not one")
    table = np.loadtxt(files[0], ndmin=2)
    if table.size == 0:
        raise PeerError(f"{SOLVER} wrote an empty table")
    return table[:, 1], table[:, 4], -table[:, 6]


def tenCate(program, folder, scene, quick=False):
    """Rows of a sphere that settles in a closed box."""
    place = folder/f"{SOLVER}_{scene.name}_D{scene.cells}"
    place.mkdir(parents=True)
    # It ends with an error if its own is beyond 10 %: the table tells
    done = run([program, *arguments(scene)], place)
    try:
        time, gap, speed = read_table(place)
    except PeerError:
        done.check(SOLVER)
        raise
    if not abs(gap[-1]) < BOTTOM:
        raise PeerError(
            f"{SOLVER}: after {len(time)} steps its sphere ended at a gap "
            f"of {gap[-1]:.2f} diameters, not at the bottom"
        )
    n = resolution(scene)
    height = int(n*scene.height/scene.width + 0.5)
    result = Result(
        f"{scene.name} whole, U {VELOCITY}",
        round(n*scene.diameter/scene.width, 2), n*n*height, len(time),
        done.cpu, SOLVER,
    )
    yield result.row("V max, m/s", speed.max(), scene.fastest)
    yield result.row("gap/D at V max", gap[speed.argmax()])
