# SPDX-License-Identifier: GPL-3.0-or-later
"""Effective viscosity of suspensions of free discs and spheres in shear."""

import math

import numpy as np
from measure import Run, set_over_relaxed, set_smoother, set_stokes, set_viscosity
from slidingBox import (
    centres, set_stress, set_velocity, sliding_box, stress,
)

# Side and shear rate are 1; viscosity: Re = 1/NU
NU, STEP = 10, 0.01
EINSTEIN = {2: 2, 3: 2.5}
# Random suspensions: diameters per side, cells per diameter, strains
SIDE, CELLS = {2: 8, 3: 5}, {2: 12, 3: 8}
FROM, TO = 2, {2: 10, 3: 6}
# Square arrays of discs, exact: at shifts 0 and 1/2 (shearedArray)
SQUARE = {
    0.1: (1.19222, 1.20999), 0.24: (1.46536, 1.56648), 0.4: (1.86797, 2.22104),
}
# Quick; in full
FRACTIONS = {
    2: ((0.1, 0.24), (0.05, 0.1, 0.15, 0.24, 0.3, 0.4)),
    3: ((), (0.05, 0.1, 0.2, 0.3)),
}


def correlations(phi, dims):
    """Beside: names and values."""
    if dims == 2:
        return {
            "1 + 2 c": 1 + 2*phi,
            "Krieger-Dougherty, 0.82": (1 - phi/0.82)**-1.64,
        }
    return {
        "1 + 2.5 phi": 1 + 2.5*phi,
        "1 + 2.5 phi + 5.2 phi^2": 1 + 2.5*phi + 5.2*phi**2,
        "1 + 2.5 phi + 7.6 phi^2": 1 + 2.5*phi + 7.6*phi**2,
        "Krieger-Dougherty, 0.64": (1 - phi/0.64)**-1.6,
    }


def radius(fraction, n, dims):
    """Of n bodies in a box of side 1."""
    one = fraction/n
    return math.sqrt(one/math.pi) if dims == 2 else (0.75*one/math.pi)**(1/3)


def body(name, place, R, dims):
    """Moves with the shear to begin with."""
    shape = "disc" if dims == 2 else "sphere"
    x, y, z = place
    return f"""
        {name}
        {{
            shape       {{ type {shape}; radius {R:.12g}; }}
            densityRatio 1;
            position    ({x:.12g} {y:.12g} {z:.12g});
            velocity    ({y - 0.5:.12g} 0 0);
            angularVelocity (0 0 -0.5);
        }}
    """


def case_of(folder, name, n, dims, bodies, strains, contact=""):
    """The run of a box of n^dims cells."""
    cells = (n,)*dims
    case = sliding_box(folder, name, cells, (1,)*dims)
    set_stokes(case)
    set_viscosity(case, NU)
    set_smoother(case)
    set_over_relaxed(case)
    x = centres(cells, (1,)*dims)
    velocity = 0*x
    velocity[:, 0] = x[:, 1] - 0.5
    set_velocity(case, velocity)
    case.bodies(bodies, f"coupling {{ tolerance 1e-3; }}\n{contact}")
    case.controls(endTime=f"{strains:g}", deltaT=f"{STEP:g}")
    set_stress(case)
    return case


def array(folder, fraction, cells, dims):
    """Rows of one body, over one period."""
    R = radius(fraction, 1, dims)
    n = round(cells/(2*R))
    middle = [0.5 + 0.3/n]*dims + [0]*(3 - dims)
    name = f"array_{dims}D_{fraction:g}_{n}"
    case = case_of(folder, name, n, dims, body("one", middle, R, dims), 1.1)
    settings = f"array {dims}D, {fraction:g}"
    run = Run(case, settings, round(2*R*n, 2), n**dims)
    viscosity = stress(case)["viscosity"]/NU
    slope = (viscosity[-round(1/STEP):].mean() - 1)/fraction
    yield run.row("slope", slope, EINSTEIN[dims])


def places(count, R, dims, seed):
    """Centres at random with gaps of at least R/20, periodic."""
    draw = np.random.default_rng(seed)
    found = []
    for _ in range(200_000):
        x = draw.random(3)*([1, 1, 1] if dims == 3 else [1, 1, 0])
        apart = [x - y - np.round(x - y) for y in found]
        if all(np.linalg.norm(d) > 2.05*R for d in apart):
            found.append(x)
        if len(found) == count:
            return found
    raise RuntimeError("no room")


def standard_error(values):
    """Of the mean of correlated values: largest over block lengths."""
    errors = [0.0]
    length = 1
    while len(values)//length >= 16:
        blocks = values[:len(values)//length*length].reshape(-1, length)
        means = blocks.mean(axis=1)
        errors.append(means.std(ddof=1)/math.sqrt(len(means)))
        length *= 2
    return max(errors)


def random(folder, fraction, dims):
    """Rows of a random suspension."""
    side = SIDE[dims]
    one = math.pi/4 if dims == 2 else math.pi/6
    count = round(fraction*side**dims/one)
    R = radius(fraction, count, dims)
    n = round(CELLS[dims]/(2*R))
    bodies = "".join(
        body(f"body{i}", x, R, dims)
        for i, x in enumerate(places(count, R, dims, 1))
    )
    case = case_of(
        folder, f"random_{dims}D_{fraction:g}", n, dims, bodies, TO[dims],
        "contact { type inelastic; }",
    )
    settings = f"random {dims}D, {fraction:g}, {count} bodies"
    run = Run(case, settings, round(2*R*n, 2), n**dims)
    values = stress(case)["viscosity"][round(FROM/STEP):]/NU
    yield run.row("viscosity", values.mean())
    yield run.row("standard error", standard_error(values))
    for name, value in correlations(fraction, dims).items():
        yield run.row(name, value)


def rows(folder, quick):
    for dims in (2, 3):
        for fraction in (0.01, 0.02, 0.05):
            for cells in (8, 16) if dims == 2 or not quick else (8,):
                if dims == 2 or cells*fraction**(-1/3) < 60:
                    yield from array(folder, fraction, cells, dims)
    for dims, (few, all_of_them) in FRACTIONS.items():
        for fraction in few if quick else all_of_them:
            yield from random(folder, fraction, dims)


def draw(rows, file):
    """Write the figure: viscosity of random suspensions over the fraction."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(
        1, 2, figsize=(9, 4), layout="constrained"
    )
    for dims, ax in zip((2, 3), axes):
        points = {}
        for row in rows:
            if row["settings"].startswith(f"random {dims}D"):
                fraction = float(row["settings"].split(", ")[1])
                point = points.setdefault(fraction, {})
                point[row["quantity"]] = float(row["value"])
        phi = np.linspace(0, max(points, default=0.1), 50)
        for k, name in enumerate(correlations(0, dims)):
            values = [correlations(x, dims)[name] for x in phi]
            ax.plot(phi, values, ("--", "-", ":", "-.")[k], color="0.4",
                    label=name)
        ax.errorbar(
            list(points), [point["viscosity"] for point in points.values()],
            [2*point["standard error"] for point in points.values()],
            fmt="o", capsize=3, label="computed, two standard errors",
        )
        ax.set(
            xlabel="area fraction c" if dims == 2 else "volume fraction phi",
            ylabel="viscosity over that of the fluid",
            title="discs" if dims == 2 else "spheres",
        )
        ax.grid(alpha=0.3)
        ax.legend(fontsize=8)
    # Square arrays, smallest and largest of any shift
    axes[0].vlines(
        list(SQUARE), *zip(*SQUARE.values()), color="C1", linewidth=4,
        alpha=0.6, label="square arrays, exact",
    )
    axes[0].legend(fontsize=8)
    figure.savefig(file, dpi=110)
    pyplot.close(figure)
