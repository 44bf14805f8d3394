# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads and draws what the pieces of the bench write, with plotting/grainPlots.

    import benchPlots as bp               # from a folder beside this one
    bench = bp.parameters(here)           # those of the run
    t, p = bp.series(here, "pressure0")
"""

import os
import pathlib
import re
import sys

here = pathlib.Path(__file__).resolve().parent
root = os.environ.get("GRAINFOAM_DIR", here/"../../..")
sys.path.insert(0, f"{root}/tutorials/plotting")

import grainPlots as gp  # source etc/bashrc of grainFoam
import numpy as np
from benchParameters import readBench
from grainPlots import plt
from matplotlib.collections import PolyCollection


def parameters(case):
    """bench.ini with the changes of the run of the case."""
    words = (pathlib.Path(case)/"constant/benchChanges").read_text().split()
    return readBench(words)


def table(case, name):
    """All that a function object surfaceFieldValue has written, a row a time."""
    folder = pathlib.Path(case)/"postProcessing"/name
    parts = sorted(folder.glob("*/surfaceFieldValue.dat"),
                   key=lambda file: float(file.parent.name))
    return np.concatenate([np.loadtxt(file, ndmin=2) for file in parts])


def series(case, name):
    """Times and values, those of the last column."""
    rows = table(case, name)
    return rows[:, 0], rows[:, -1]


def mean(case, name, part=0.5):
    """Time average over the last part of the run."""
    time, values = series(case, name)
    late = time >= time[-1] - part*(time[-1] - time[0])
    return values[late].mean()


def last(case, name):
    return series(case, name)[1][-1]


def seconds(case):
    """Run time of foamRun [s]."""
    log = (pathlib.Path(case)/"log.foamRun").read_text()
    return float(re.findall(r"ExecutionTime = (\S+) s", log)[-1])


class Plane:
    """A cut plane of a case, at the last time if none is given.

    polygons    list of (n, 3) corners [m], one for each cell that is cut
    centres     (m, 3) means of the corners
    fields      {name: values (m,) or (m, 3)}
    """

    def __init__(self, case, name, time=None):
        folder = pathlib.Path(case)/"postProcessing/planes"
        time = time or max((d.name for d in folder.iterdir()), key=float)
        words = (folder/time/f"{name}.vtk").read_text().split()
        start = words.index("POINTS")
        points = numbers(words, start + 3, 3*int(words[start + 1]), 3)
        start = words.index("POLYGONS")
        flat = numbers(words, start + 3, int(words[start + 2])).astype(int)
        self.polygons, i = [], 0
        while i < len(flat):
            self.polygons.append(points[flat[i + 1:i + 1 + flat[i]]])
            i += 1 + flat[i]
        self.centres = np.array([corners.mean(axis=0)
                                 for corners in self.polygons])
        self.fields = readFields(words[words.index("CELL_DATA"):])


def numbers(words, start, count, width=1):
    """Words as numbers, in rows if width > 1."""
    table = np.array(words[start:start + count], dtype=float)
    return table.reshape(-1, width) if width > 1 else table


def readFields(words):
    """Fields of CELL_DATA: name, width, number, kind, numbers."""
    fields, i = {}, 5
    for _ in range(int(words[4])):
        name, width, number = words[i], int(words[i + 1]), int(words[i + 2])
        end = i + 4 + width*number
        fields[name] = numbers(words, i + 4, width*number, width)
        i = end
    return fields


def drawPlane(ax, places, values, limit, cmap="viridis"):
    """Colour picture of polygons, places: list of (n, 2), cell by cell."""
    image = PolyCollection(places, array=values, cmap=cmap, linewidth=0.2,
                           edgecolor="face", rasterized=True)
    image.set_clim(*limit)
    ax.add_collection(image)
    ax.autoscale()
    ax.grid(False)
    ax.set_aspect("equal")
    return image
