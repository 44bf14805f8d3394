# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag of fixed spheres at random places in a periodic cube, Stokes flow."""

import math

import numpy as np

from measure import LOCKED, Run, set_direct, set_stokes, set_viscosity
from periodicBox import periodic_case, superficial_speed

# Fraction, number of spheres, places (seeds), D/h of all of them; of the first
# places, besides
FRACTION, NUMBER, SEEDS, CELLS = 0.2, 50, 8, 12
OTHERS = 8, 16
QUICK = 4, 8
# Smallest gap between surfaces, over the diameter
GAP = 0.01
# Moves of each sphere to forget the array that they start from, and their size
# over the diameter
MOVES, SIZE = 500, 0.3
# Time step in h^2/nu, and their number
STEP, STEPS = 50, 200


def tenneti(fraction):
    """F/(3 pi mu D U), U superficial: Tenneti, Garg & Subramaniam at Re 0."""
    c = fraction
    return 1/(1 - c)**3 + 5.81*c/(1 - c)**3 + 0.48*c**(1/3)/(1 - c)**4


def beetstra(fraction):
    """The same by Beetstra, van der Hoef & Kuipers, whose F is (1 - c) times
    it."""
    c = fraction
    return 10*c/(1 - c)**3 + (1 - c)*(1 + 1.5*math.sqrt(c))


def hill(fraction):
    """The same by Hill, Koch & Ladd, fractions below 0.4."""
    c = fraction
    above = 1 + 3*math.sqrt(c/2) + 135/64*c*math.log(c) + 17.14*c
    return above/(1 + 0.681*c - 8.48*c**2 + 8.16*c**3)


def places(seed):
    """Centres in units of the diameter and side of the cube: hard spheres in
    equilibrium, by moves at random from a cubic array (Metropolis)."""
    random = np.random.default_rng(seed)
    side = (NUMBER*math.pi/(6*FRACTION))**(1/3)
    n = math.ceil(NUMBER**(1/3))
    lattice = np.stack(np.meshgrid(*3*[np.arange(n)]), axis=-1).reshape(-1, 3)
    x = (lattice[random.permutation(n**3)[:NUMBER]] + 0.5)*side/n
    for _ in range(MOVES):
        for i in range(NUMBER):
            to = x[i] + random.uniform(-SIZE, SIZE, 3)
            away = x - to
            away -= side*np.round(away/side)
            distance = (away**2).sum(axis=1)
            distance[i] = 2
            if distance.min() > (1 + GAP)**2:
                x[i] = to % side
    return x, side


def least_gap(x, side):
    """Over the diameter."""
    away = x[:, None] - x
    away -= side*np.round(away/side)
    distance = np.linalg.norm(away, axis=2) + 9*np.eye(len(x))
    return distance.min() - 1


def solve(folder, seed, cells):
    """Run, drag over 3 pi mu D U after all steps and after half of them, and
    the smallest gap in cells."""
    x, side = places(seed)
    n = round(cells*side)
    h = side/n
    D_over_h = round(1/h, 2)
    # A superficial speed of about 1
    gradient = NUMBER*3*math.pi*tenneti(FRACTION)/side**3
    name = f"seed {seed}"
    case = periodic_case(
        folder, f"seed{seed}_n{n}", n, 3, gradient, True, length=side
    )
    set_stokes(case)
    set_viscosity(case, 1)
    set_direct(case)
    positions = " ".join("({:.12g} {:.12g} {:.12g})".format(*y) for y in x)
    case.bodies(f"""
        sphere
        {{
            shape       {{ type sphere; radius 0.5; }}
            positions   ({positions});
            {LOCKED}
        }}
    """)
    dt = STEP*h**2
    case.controls(endTime=f"{STEPS*dt:.12g}", deltaT=f"{dt:.12g}")
    run = Run(case, name, D_over_h, n**3)
    speed = superficial_speed(case, side**2)
    drag = gradient*side**3/(NUMBER*3*math.pi*speed)
    return run, drag, least_gap(x, side)/h


def figures(folder, seed, cells):
    """Rows of one set of places, and its drag."""
    run, drag, gap = solve(folder, seed, cells)
    limit = 2*drag[-1] - drag[len(drag)//2 - 1]
    rows = [
        run.row("K", limit, tenneti(FRACTION)),
        run.row("last change, %", 100*abs(drag[-1]/limit - 1)),
        run.row("least gap/h", gap),
    ]
    return rows, limit, run


def rows(folder, quick):
    seeds, cells = QUICK if quick else (SEEDS, CELLS)
    found, cpu = [], 0
    for seed in range(1, seeds + 1):
        lines, drag, run = figures(folder, seed, cells)
        yield from lines
        found.append(drag)
        cpu += run.cpu
    for other in () if quick else OTHERS:
        yield from figures(folder, 1, other)[0]

    run.settings, run.cpu = f"{seeds} seeds", cpu
    mean, scatter = np.mean(found), np.std(found, ddof=1)
    yield run.row("K, Tenneti", mean, tenneti(FRACTION))
    yield run.row("K, Beetstra", mean, beetstra(FRACTION))
    yield run.row("K, Hill", mean, hill(FRACTION))
    yield run.row("scatter", scatter)
    yield run.row("standard error", scatter/math.sqrt(seeds))
