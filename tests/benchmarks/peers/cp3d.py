# SPDX-License-Identifier: GPL-3.0-or-later
"""CP3d (github.com/GongZheng-Justin/CP3d): direct forcing and FFT.

The program is its channelACM. Spheres must not cross the sides across y: it
has no images of them. Velocities are read from its binary output."""

import math

import numpy as np

from measure import Result
from peers.cp3dInput import (
    fft_size, fluid_input, spheres_input, write_places,
)
from peers.given import PeerError, late_step, run

SOLVER = "CP3d"
VARIABLE = "LEAGUE_CP3D"
MISSING = {"fluid": "channelACM is for spheres"}
# Time steps of ten Cate's cases [ms]: about Courant number 0.15, and its own
STEPS = {"E1": (5, 1), "E2": (3, 1), "E3": (2, 1), "E4": (2, 1)}
# Of the velocity in a run
SAMPLES = 200


def read_spheres(file, number):
    """Places and velocities (number, 3) in the order in which they were
    given."""
    data = file.read_bytes()
    if len(data) != number*(24 + 4 + 24):
        raise PeerError(f"{SOLVER}: {file.name} is not of {number} spheres")
    order = np.argsort(np.frombuffer(data, np.int32, number, 24*number))
    place = np.frombuffer(data, float, 3*number).reshape(-1, 3)
    speed = np.frombuffer(data, float, 3*number, 28*number).reshape(-1, 3)
    return place[order], speed[order]


def outputs(folder):
    """Files of the spheres by time step."""
    found = folder.glob("ACM/PartVisuForspheres*[0-9]")
    return {int(file.name[-10:]): file for file in sorted(found)}


def execute(program, folder, fluid, spheres, steps):
    """Run with these two files. steps: the last of which there is output."""
    (folder/"fluid").write_text(fluid)
    (folder/"spheres").write_text(spheres)
    done = run([program, "fluid", "spheres"], folder).check(SOLVER)
    if steps not in outputs(folder):
        end = "\n".join(done.log.splitlines()[-5:])
        raise PeerError(f"{SOLVER} did not come to its end:\n{end}")
    return done


def settle(program, folder, scene, milliseconds):
    """The run of a sphere that settles along y with this time step; gaps over
    the diameter and velocities [m/s] downwards."""
    across = fft_size(scene.width*scene.cells/scene.diameter)
    along = 2*round(scene.height*across/scene.width/2)
    cells = across*scene.diameter/scene.width
    dt = 1e-3*milliseconds
    steps = math.ceil(scene.end/dt)
    every = max(1, steps//SAMPLES)

    place = folder/f"{SOLVER}_{scene.name}_D{scene.cells}_{milliseconds}"
    middle, start = 0.5*scene.width, 0.5*scene.diameter + scene.gap
    write_places(place, [(middle, start, middle)], scene.diameter)
    done = execute(
        program, place,
        fluid_input(
            (scene.width, scene.height, scene.width),
            (across, along, across), scene.mu/scene.rho, float(scene.rho),
            dt, steps, "RK3", periodic=False, every=every,
        ),
        spheres_input(
            1, scene.diameter, cells, float(scene.rho_s),
            [0.0, -scene.gravity, 0.0], floor=True, fixed=False,
        ),
        steps - steps % every,
    )
    read = [read_spheres(file, 1) for file in outputs(place).values()]
    gap = np.array([x[0, 1] for x, _ in read])/scene.diameter - 0.5
    speed = -np.array([v[0, 1] for _, v in read])
    result = Result(
        f"{scene.name} whole, RK3, {milliseconds} ms", round(cells, 2),
        across*along*across, steps, done.cpu, SOLVER,
    )
    return result, gap, speed


def tenCate(program, folder, scene, quick=False):
    """Rows of a sphere that settles in a closed box."""
    for milliseconds in STEPS[scene.name][:1 if quick else None]:
        result, gap, speed = settle(program, folder, scene, milliseconds)
        yield result.row("V max, m/s", speed.max(), scene.fastest)
        yield result.row("gap/D at V max", gap[speed.argmax()])


def solve_crowd(program, folder, scene, scheme, fixed=False):
    """Seconds per step in the second half, the whole run, places and
    velocities at its end."""
    number = len(scene.centres)

    def timed(steps):
        kind = "fixed" if fixed else "free"
        place = folder/f"{SOLVER}_{number}_{kind}_{scene.box}_{scheme}_{steps}"
        write_places(place, scene.centres, 1.0)
        done = execute(
            program, place,
            fluid_input(
                [scene.side]*3, [scene.box]*3, scene.nu, 1.0, scene.dt,
                steps, scheme, periodic=True, every=steps,
            ),
            spheres_input(
                number, 1.0, scene.cells, float(scene.ratio),
                [float(scene.gravity), 0.0, 0.0], floor=False, fixed=fixed,
            ), steps,
        )
        return done, read_spheres(outputs(place)[steps], number)

    step, (done, (place, speed)) = late_step(timed, scene.steps)
    crossed = np.abs(place[:, 1]/scene.side - 0.5).max() > (
        0.5 - 0.5/scene.side
    )
    if crossed:
        print(f"{SOLVER}: a sphere crossed a side, which has no image of it")
    result = Result(
        f"{scene.name}, {scheme}", scene.cells, scene.box**3, scene.steps,
        done.cpu, SOLVER,
    )
    return step, result, speed[:, 0]


def crowd(program, folder, scene, fixed):
    """Rows of a crowd and velocities at its end, for each scheme; fixed: the
    scene with one sphere, held."""
    for scheme in ("RK3", "AB2"):
        one, _, _ = solve_crowd(program, folder, fixed, scheme, fixed=True)
        step, result, speed = solve_crowd(program, folder, scene, scheme)
        yield result, step, one, speed
