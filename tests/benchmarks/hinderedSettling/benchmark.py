# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres that settle in a triply periodic box without net volume flux."""

import math

import numpy as np

import boxMesh
import stream
from bodyCase import BodyCase
from boxMesh import graded
from measure import Run, driving_force, set_direct, set_viscosity
from periodicBox import periodic_case
from periodicTube import FLOW_RATE

# D = 1, gravity along x; the speed of one sphere is about 1
RATIO, CELLS, NUMBER = 2, 8, 27
FRACTIONS = 0.1, 0.2
# Courant number of the speed of one sphere
COURANT = 1
# Time to forget the start, and end, by the Reynolds number
TIMES = {1: (5, 20), 20: (10, 30)}
# Of the random places, by the Reynolds number
SEEDS = {1: (1,), 20: (1, 2)}
# Blocks of the time mean
BLOCKS = 5
# Window of the single sphere: width, ahead, behind
WIDTH, AHEAD, BEHIND = 30, 12, 30
CONTACT = "contact { type inelastic; }"


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


def random_centres(number, side, gap, seed):
    """Places in a periodic box, with a smallest gap between surfaces."""
    random = np.random.default_rng(seed)
    found = np.empty((0, 3))
    for _ in range(1_000_000):
        x = random.uniform(0, side, 3)
        away = found - x
        away -= side*np.round(away/side)
        if (np.linalg.norm(away, axis=1) > 1 + gap).all():
            found = np.vstack([found, x])
            if len(found) == number:
                return found
    raise ValueError(f"no room for {number} spheres")


def box_case(folder, name, reynolds, n, centres):
    """A periodic box of n cells in each direction, at D/h = CELLS."""
    case = periodic_case(folder, name, n, 3, 0, True, length=n/CELLS)
    case.replace("0/U", "uniform (1 0 0)", "uniform (0 0 0)")
    (case.path / "constant/fvOptions").write_text(FLOW_RATE.format(speed=0))
    set_direct(case)
    set_viscosity(case, 1/reynolds)
    case.gravity(weight(reynolds)/(RATIO - 1))
    positions = " ".join(
        "({:.12g} {:.12g} {:.12g})".format(*x) for x in centres
    )
    case.bodies(f"""
        sphere
        {{
            shape       {{ type sphere; radius 0.5; }}
            densityRatio {RATIO};
            positions   ({positions});
            velocity    (0 0 0);
            angularVelocity (0 0 0);
        }}
    """, CONTACT)
    return case


def suspension(folder, reynolds, fraction, single, seed=1, quick=False):
    """Rows of a suspension of this solid fraction, about."""
    number = NUMBER
    begin, end = TIMES[reynolds]
    end = begin + 5 if quick else end
    n = round(CELLS*(number*math.pi/(6*fraction))**(1/3))
    side = n/CELLS
    fraction = number*math.pi/(6*side**3)
    name = f"Re_t {reynolds:g}, solid fraction {fraction:.3f}"
    name += f", seed {seed}"
    case = box_case(
        folder, f"Re{reynolds:g}_{fraction:.3f}_{seed}", reynolds, n,
        random_centres(number, side, 0.1, seed),
    )
    case.controls(endTime=f"{end:g}", deltaT=f"{COURANT/CELLS:.12g}")
    run = Run(case, name, CELLS, n**3, may_fail=True)
    if run.failed:
        yield run.diverged()
        return

    motion = case.columns("motion")
    time, speed = motion["time"], motion["velocity_x"]
    times = np.unique(time)
    means = speed.reshape(len(times), number).mean(axis=1)
    late = times > begin
    value = means[late].mean()/single
    blocks = [b.mean()/single for b in np.array_split(means[late], BLOCKS)]
    error = np.std(blocks, ddof=1)/math.sqrt(BLOCKS)

    terminal = reynolds*single
    law = (1 - fraction)**exponent(terminal)
    yield run.row("speed/single", value, law)
    yield run.row("statistical error", error)
    yield run.row("prefactor of Richardson-Zaki", value/law)
    yield run.row("exponent without prefactor",
                  math.log(value)/math.log(1 - fraction))
    if reynolds <= 1:
        more = value + stokes_correction(fraction, number)
        yield run.row("speed/single, infinite box", more, law)
        yield run.row("prefactor, infinite box", more/law)

    # Without walls the mean force balances the weight of the spheres
    force = driving_force(case)[-late.sum():].mean()
    balance = -fraction*weight(reynolds)
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
    case.controls(endTime="30", deltaT=f"{COURANT*h:.12g}")
    run = Run(case, f"Re_t {reynolds:g}, one sphere", CELLS, n)
    speed = case.table("motion")["velocity_x"][-1]
    return run.row("speed", speed, clift_speed(reynolds)), speed


def rows(folder, quick):
    for reynolds in TIMES:
        row, single = single_sphere(folder, reynolds)
        yield row
        for fraction in FRACTIONS[1:] if quick else FRACTIONS:
            for seed in SEEDS[reynolds][:1] if quick else SEEDS[reynolds]:
                yield from suspension(
                    folder, reynolds, fraction, single, seed, quick
                )
