# SPDX-License-Identifier: GPL-3.0-or-later
"""Two discs and two spheres that fall one behind the other: drafting, kissing
and tumbling."""

from pathlib import Path

import numpy as np

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform
from measure import Run, set_direct, set_viscosity

PLOT = Path(__file__).resolve().parents[1] / \
    "results/draftingKissingTumbling_curves.png"

# Discs, in cm and s: a box of 8 x 24 diameters, follower and leader at 4 and 6
# from the top, 1/250 beside the middle (Uhlmann 2005, after Glowinski 2001).
# Spheres: diameter and gravity 1, as in the benchmark of FeatFloWer.
# near: centre distance [diameters] that counts as kissing; far: as being apart
DISCS = {
    "shape": "disc", "D": 0.25, "ratio": 1.5, "nu": 0.01, "g": 981,
    "box": (2, 6), "follower": (0.001, 5), "leader": (-0.001, 4.5),
    "end": 0.3, "fastest": 20, "near": 1.12, "far": 1.3,
}
SPHERES = {
    "shape": "sphere", "D": 1, "ratio": 1.14, "nu": 4.7e-3, "g": 1,
    "box": (6, 24, 6), "follower": (0.05, 21.5, 0), "leader": (0, 20, 0),
    "end": 40, "fastest": 0.5, "near": 1.005, "far": 1.02,
}
# By shape and source
REFERENCES = {
    "disc": {
        "Uhlmann": {"kissing": 0.1658, "level": 0.280, "follower": 19.3},
        "Koblitz": {"kissing": 0.1700, "level": 0.261, "follower": 21.4},
    },
    "sphere": {
        "FeatFloWer": {"kissing": 18.34, "apart": 29.64, "level": 32.92},
    },
}
# Of the fastest body
COURANT = 0.4
# D/h
QUICK = ((DISCS, 16),)
FULL = ((DISCS, 16), (DISCS, 32), (SPHERES, 8))
CONTACT = "inelastic"
EMPTY = '"frontAndBack.*" { type empty; }'


def make_case(folder, pair, cells):
    """A closed box with the two at rest, and its number of cells."""
    case = BodyCase("tube", folder, f"{pair['shape']}_D{cells}")
    h = pair["D"]/cells
    width, height, *depth = pair["box"]
    case.conditions(*(
        f"walls {{ type {kind}; }} {EMPTY}"
        for kind in ("noSlip", "zeroGradient")
    ))
    n = boxMesh.write(
        case,
        *(uniform(low, low + size, round(size/h)) for low, size in (
            (-0.5*width, width), (0, height), *((-0.5*d, d) for d in depth)
        )),
        patches={"walls": "x- x+ y- y+" + " z- z+"*len(depth)},
    )
    case.run("blockMesh")
    set_viscosity(case, pair["nu"])
    set_direct(case)
    case.gravity(0, -pair["g"])
    bodies = "\n".join(f"""
        {name}
        {{
            shape       {{ type {pair["shape"]}; radius {0.5*pair["D"]}; }}
            densityRatio {pair["ratio"]};
            position    ({" ".join(map(str, (*pair[name], 0)[:3]))});
            velocity    (0 0 0);
            angularVelocity (0 0 0);
        }}
    """ for name in ("follower", "leader"))
    case.bodies(bodies, f"contact {{ type {CONTACT}; }}")
    dt = COURANT*h/pair["fastest"]
    case.controls(endTime=f"{pair['end']}", deltaT=f"{dt:.6g}")
    return case, n


def first(time, value, limit):
    """Time at which a value first falls below the limit, None if it never
    does; interpolated."""
    below = np.flatnonzero(value < limit)
    if not len(below):
        return None
    i = below[0]
    if not i:
        return time[0]
    part = (value[i-1] - limit)/(value[i-1] - value[i])
    return time[i-1] + part*(time[i] - time[i-1])


class Pair:
    """Distance [diameters], tilt [degrees] and speeds of two over time."""

    def __init__(self, case, D):
        follower, leader = case.table("motion", 0), case.table("motion", 1)
        self.time = follower["time"]
        apart = np.array([
            follower[f"position_{k}"] - leader[f"position_{k}"] for k in "xyz"
        ])/D
        self.distance = np.linalg.norm(apart, axis=0)
        self.tilt = np.degrees(np.arccos(apart[1]/self.distance))
        self.speeds = -follower["velocity_y"], -leader["velocity_y"]
        self.places = [
            [body[f"position_{k}"]/D for k in "xy"]
            for body in (follower, leader)
        ]


def figures(pair, motion, run):
    """Rows of one run."""
    time = motion.time
    kissing = first(time, motion.distance, pair["near"])
    after = time > (kissing or time[-1])
    follower, leader = motion.speeds
    values = {
        "kissing": kissing,
        "apart": first(time[after], -motion.distance[after], -pair["far"]),
        "level": first(time, -motion.tilt, -90),
        "follower": follower.max(),
        "leader": leader.max(),
    }
    if kissing:
        for name, speed in zip(("follower", "leader"), motion.speeds):
            values[f"{name}, kissing"] = np.interp(kissing, time, speed)
    for source, known in REFERENCES[pair["shape"]].items():
        for name, reference in known.items():
            if values[name] is not None:
                quantity = f"{name}, {source}"
                yield run.row(quantity, values[name], reference)
    known = {name for of in REFERENCES[pair["shape"]].values() for name in of}
    for name, value in values.items():
        if value is not None and name not in known:
            yield run.row(name, value)
    yield run.row("least distance", motion.distance.min())
    yield run.row("not converged", run.steps - run.converged)
    yield run.row("outers, mean", np.mean(run.outers))


def plot(curves):
    """Distance, tilt, speeds and ways; a row for discs and one for spheres."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    shapes = list(dict.fromkeys(shape for shape, _ in curves))
    figure, axes = pyplot.subplots(
        len(shapes), 4, figsize=(12, 3.2*len(shapes)), squeeze=False,
        layout="constrained", width_ratios=(3, 3, 3, 1.6),
    )
    for shape, row in zip(shapes, axes):
        # Published times of kissing and of being level
        for (source, known), style in zip(
            REFERENCES[shape].items(), ("--", ":")
        ):
            row[0].axvline(
                known["kissing"], color="0.5", linestyle=style,
                label=f"{source}: kissing, level",
            )
            row[1].axvline(known["level"], color="0.5", linestyle=style)
        row[0].set(ylabel=f"{shape}s: centre distance / D", ylim=(0.8, 3))
        row[1].set(ylabel="tilt [degrees]", yticks=(0, 45, 90, 135))
        row[2].set(ylabel="speed (follower -, leader --)")
        row[3].set(xlabel="x / D", ylabel="y / D", aspect="equal")
        for ax in row[:3]:
            ax.set(xlabel="time")
            ax.grid(alpha=0.3)
    for k, ((shape, label), motion) in enumerate(curves.items()):
        row, look = axes[shapes.index(shape)], {"color": f"C{k}"}
        row[0].plot(motion.time, motion.distance, label=label, **look)
        row[1].plot(motion.time, motion.tilt, **look)
        for style, speed, (x, y) in zip(
            ("-", "--"), motion.speeds, motion.places
        ):
            row[2].plot(motion.time, speed, linestyle=style, **look)
            row[3].plot(x, y, linestyle=style, linewidth=1, **look)
            row[3].add_patch(
                pyplot.Circle((x[-1], y[-1]), 0.5, fill=False, **look)
            )
        row[0].legend(fontsize=8)
    PLOT.parent.mkdir(exist_ok=True)
    figure.savefig(PLOT, dpi=90)
    pyplot.close(figure)


def rows(folder, quick):
    curves = {}
    for pair, cells in QUICK if quick else FULL:
        case, n = make_case(folder, pair, cells)
        run = Run(case, f"{pair['shape']}s", cells, n, may_fail=True)
        if run.failed:
            yield run.diverged()
            continue
        motion = Pair(case, pair["D"])
        curves[pair["shape"], f"D/h {cells}"] = motion
        yield from figures(pair, motion, run)
    plot(curves)
