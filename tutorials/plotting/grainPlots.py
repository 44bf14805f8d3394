# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads what grainFoam's function objects write, and draws it.

Needs numpy and matplotlib only, and no screen. The scripts plot.py of the
tutorials show the use; for a case in folder `case`:

    motion = readMotion(case)             # {name: columns of one body}
    plane = readPlane(case, "U", time)    # points and values of a cut plane
"""

import pathlib
import re

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Circle
from matplotlib.tri import LinearTriInterpolator, Triangulation

plt.rcParams.update({
    "axes.grid": True,
    "axes.spines.right": False,
    "axes.spines.top": False,
    "figure.constrained_layout.use": True,
    "figure.dpi": 130,
    "font.size": 10,
    "grid.alpha": 0.3,
    "legend.frameon": False,
    "lines.linewidth": 1.6,
})


def readBodies(file):
    """Columns of a .dat file of one line per time and body, as
    {body name: {"time": ..., "position_x": ..., ...}}."""
    names, columns = {}, []

    with open(file) as lines:
        for line in lines:
            if not line.startswith("#"):
                continue
            if "time[" in line:
                columns = [re.sub(r"\[.*", "", c)
                           for c in line.strip("# \n").split("\t")]
                columns = [c.strip() for c in columns]
            elif re.match(r"#\s*\d+\s*:", line):
                number, name = line.strip("# \n").split(":")
                names[int(number)] = name.strip()

    if not names:
        return {}

    table = np.loadtxt(file, ndmin=2)
    bodyOf = table[:, columns.index("body")].astype(int)

    return {
        name: {c: table[bodyOf == body, i] for i, c in enumerate(columns)}
        for body, name in names.items()
    }


def readSeries(case, functionObject, file):
    """readBodies on all parts of a run: a restart begins a folder with its
    start time, and replaces what an earlier part has from there on."""
    folder = pathlib.Path(case)/"postProcessing"/functionObject
    starts = sorted((d for d in folder.iterdir() if (d/file).exists()),
                    key=lambda d: float(d.name))
    joined = {}

    for start in starts:
        for name, part in readBodies(start/file).items():
            if name in joined:
                keep = joined[name]["time"] < part["time"][0]
                part = {c: np.append(joined[name][c][keep], part[c])
                        for c in part}
            joined[name] = part

    return joined


def readMotion(case, functionObject="motion"):
    return readSeries(case, functionObject, "immersedBodyMotion.dat")


def readPassage(case):
    """Bodies that enter and leave, one {"time": ..., "what": ...} each."""
    folder = pathlib.Path(case)/"postProcessing/immersedBodies"
    events = []

    for file in sorted(folder.glob("*/passage.dat"),
                       key=lambda f: float(f.parent.name)):
        for line in file.read_text().splitlines():
            words = line.strip("# ").split()
            if "time[" in line:
                columns = [re.sub(r"\[.*", "", c) for c in words]
            elif not line.startswith("#"):
                values = [*map(float, words[:-3]), *words[-3:]]
                events.append(dict(zip(columns, values)))

    return events


def planeTimes(case, functionObject="plane"):
    folder = pathlib.Path(case)/"postProcessing"/functionObject
    return sorted((d.name for d in folder.iterdir()), key=float)


def readPlane(case, field, time, functionObject="plane"):
    """Points (n, 3) and values (n,) or (n, 3) of a field on a cut plane, as
    the function object `surfaces` writes them in its raw format."""
    folder = pathlib.Path(case)/"postProcessing"/functionObject/time
    table = np.loadtxt(next(folder.glob(f"{field}_*.raw")))
    values = table[:, 3:]
    return table[:, :3], values[:, 0] if values.shape[1] == 1 else values


def at(body, time):
    """State of a body at a time: {"position_x": ..., ...}."""
    i = int(np.argmin(np.abs(body["time"] - float(time))))
    return {c: values[i] for c, values in body.items()}


def angle(state, axis="z"):
    """Turn about an axis [rad]."""
    return 2*np.arctan2(state["q_" + axis], state["q_w"])


def resample(points, values, x, y, axes=(0, 1)):
    """Values interpolated to the grid of x and y, from scattered points in
    the plane of the two axes; masked outside of them."""
    triangles = Triangulation(points[:, axes[0]], points[:, axes[1]])
    X, Y = np.meshgrid(x, y)
    return LinearTriInterpolator(triangles, values)(X, Y)


def drawField(ax, x, y, values, limit, cmap="RdBu_r"):
    """Colour picture of values on the grid of x and y; limit: the largest
    magnitude, or the least and the largest value."""
    low, high = limit if isinstance(limit, tuple) else (-limit, limit)
    ax.grid(False)
    ax.set_aspect("equal")
    return ax.pcolormesh(x, y, values, cmap=cmap, vmin=low, vmax=high,
                         shading="gouraud", rasterized=True)


def colourBar(figure, image, axes, label):
    """One colour bar below all pictures."""
    return figure.colorbar(image, ax=axes, location="bottom", shrink=0.7,
                           aspect=40, pad=0.02, extend="both", label=label)


def drawGrain(ax, centre, radius, turn=None, **style):
    """Outline of a round grain, with a mark that shows its turn."""
    style = {"facecolor": "0.93", "edgecolor": "k", "linewidth": 1.2,
             "zorder": 5, **style}
    ax.add_patch(Circle(centre, radius, **style))

    if turn is not None:
        tip = radius*np.array([np.cos(turn), np.sin(turn)])
        ax.plot([centre[0], centre[0] + tip[0]], [centre[1], centre[1] + tip[1]],
                color=style["edgecolor"], linewidth=style["linewidth"],
                zorder=style["zorder"] + 1)


def save(figure, file):
    file = pathlib.Path(file)
    file.parent.mkdir(exist_ok=True)
    figure.savefig(file)
    plt.close(figure)
    print("Wrote", file)
