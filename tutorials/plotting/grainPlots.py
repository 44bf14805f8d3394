# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads what grainFoam's function objects write, and draws it.

Needs numpy and matplotlib only, and no screen. The scripts plot.py of the
tutorials show the use; for a case in folder `case`:

    motion = readMotion(case)             # {name: columns of one body}
    plane = readPlane(case, "U", time)    # points and values of a cut plane
"""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Circle
from matplotlib.tri import LinearTriInterpolator, Triangulation

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]/"python"))

from grainfoam import tables

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


def bodies(columns):
    """Columns of each body: {name: {"time": ..., "position_x": ..., ...}}."""
    order = np.argsort(columns["body"], kind="stable")
    starts = np.flatnonzero(np.diff(columns["body"][order], prepend=-1))
    parts = [np.split(v[order], starts)[1:] for v in columns.values()]
    motions = (dict(zip(columns, part)) for part in zip(*parts))
    return {motion["name"][0]: motion for motion in motions}


def readMotion(case, functionObject="motion"):
    return bodies(
        tables.run_columns(case, functionObject, "immersedBodyMotion"))


def readPassage(case):
    """Bodies that enter and leave, one {"time": ..., "what": ...} each."""
    columns = tables.run_columns(case, "immersedBodies", "passage")
    return [dict(zip(columns, row)) for row in zip(*columns.values())]


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
