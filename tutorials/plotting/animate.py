# SPDX-License-Identifier: GPL-3.0-or-later
"""Animates a run: CASE/plots/animation/*.png, and from them animation.gif, or
animation.mp4 where there is ffmpeg.

    animate.py CASE [-frames 80] [-fps 12] [-field U] [-start T] [-end T]

CASE is a folder with postProcessing, as every tutorial with grains has after
its run. Bodies move with the rows of immersedBodyMotion, and have the outlines
that immersedBodySurfaces has written; behind them is the speed, or the
magnitude of another field, on the cut plane that the function object `surfaces`
has written in raw format, interpolated between its times. Without one, bodies
are seen on the two directions in which they and their ways are longest. In a
comoving window the picture is that of the window. Needs numpy, matplotlib and
pillow, and no screen.
"""

import argparse
import json
import pathlib
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree

import numpy as np
from PIL import Image

import grainPlots as gp
from grainPlots import plt


def turned(q, points):
    """Points (n, 3) turned by the unit quaternion w, x, y, z."""
    w, v = q[0], np.asarray(q[1:])
    return points + 2*np.cross(v, np.cross(v, points) + w*points)


def quaternion(state):
    return [state["q_" + c] for c in "wxyz"]


def position(state):
    """In the window, if there is one."""
    name = "windowPosition_" if "windowPosition_x" in state else "position_"
    return np.array([state[name + c] for c in "xyz"])


def hull(points):
    """Corners of the convex hull of points (n, 2), in order."""
    points = sorted(map(tuple, np.round(points, 12)))

    def toTheLeft(a, b, c):
        return (b[0] - a[0])*(c[1] - a[1]) > (b[1] - a[1])*(c[0] - a[0])

    def half(ordered):
        corners = []
        for p in ordered:
            while len(corners) > 1 and not toTheLeft(*corners[-2:], p):
                corners.pop()
            corners.append(p)
        return corners[:-1]

    return np.array(half(points) + half(points[::-1]))


def readSurfaces(file):
    """Points of each body's surface from a .vtp file: {number: (n, 3)}."""
    piece = ElementTree.parse(file).getroot().find("PolyData/Piece")

    def array(path, kind):
        return np.array(piece.find(path).text.split(), dtype=kind)

    points = array("Points/DataArray", float).reshape(-1, 3)
    corners = array("Polys/DataArray[@Name='connectivity']", int)
    ends = array("Polys/DataArray[@Name='offsets']", int)
    bodies = array("CellData/DataArray[@Name='body']", int)
    bodies = bodies[int(piece.get("NumberOfVerts")):]
    ofCorner = np.repeat(bodies, np.diff(np.append(0, ends)))

    return {body: points[np.unique(corners[ofCorner == body])]
            for body in np.unique(bodies)}


def readShapes(case, grains, numbers):
    """Points of the surface of each body about its centre, as it would be if it
    had not turned: {name: (n, 3)}. Of those that no file has: of another."""
    shapes = {}

    for series in case.glob("postProcessing/*/bodies.vtp.series"):
        for entry in json.loads(series.read_text())["files"]:
            surfaces = readSurfaces(series.parent/entry["name"])
            for name, grain in grains.items():
                points = surfaces.get(numbers[name])
                if points is None or name in shapes:
                    continue
                q = quaternion(gp.at(grain, entry["time"]))
                shapes[name] = turned([q[0], *np.negative(q[1:])],
                                      points - points.mean(axis=0))

    return {name: shapes.get(name, next(iter(shapes.values()), None))
            for name in grains}


def readGrains(case):
    """Motion of all bodies by their names, and their numbers."""
    for folder in sorted(case.glob("postProcessing/*")):
        if any(folder.glob("*/immersedBodyMotion.dat")):
            grains = gp.readMotion(case, folder.name)
            if grains:
                return grains, {n: g["body"][0] for n, g in grains.items()}
    raise SystemExit(f"{case} has no table of the function object"
                     " immersedBodyMotion: has it been run?")


class Plane:
    """A field on a cut plane, interpolated in time on a regular grid."""

    def __init__(self, case, field):
        files = sorted(case.glob(f"postProcessing/*/*/{field}_*.raw"))
        self.case, self.field, self.known = case, field, {}
        self.times = []
        if not files:
            return

        self.name = files[0].parent.parent.name
        self.times = gp.planeTimes(case, self.name)
        points, _ = gp.readPlane(case, field, self.times[0], self.name)
        low, high = points.min(axis=0), points.max(axis=0)
        normal = int(np.argmin(high - low))
        self.axes = tuple(i for i in range(3) if i != normal)
        span = (high - low)[list(self.axes)]
        n = np.maximum(2, (400*span/span.max()).astype(int))
        self.grid = [np.linspace(low[a], high[a], k)
                     for a, k in zip(self.axes, n)]
        last = self.values(len(self.times) - 1)
        self.limit = 0, float(np.nanmax(last.filled(0)))*1.05

    def values(self, i):
        if i not in self.known:
            points, values = gp.readPlane(self.case, self.field,
                                          self.times[i], self.name)
            if values.ndim > 1:
                values = np.linalg.norm(values, axis=1)
            self.known = {k: v for k, v in self.known.items() if k == i - 1}
            self.known[i] = gp.resample(points, values, *self.grid, self.axes)
        return self.known[i]

    def at(self, time):
        times = np.array(self.times, dtype=float)
        i = int(np.clip(np.searchsorted(times, time) - 1, 0,
                        max(len(times) - 2, 0)))
        if len(times) == 1 or time <= times[i]:
            return self.values(i)
        part = min((time - times[i])/(times[i + 1] - times[i]), 1)
        return (1 - part)*self.values(i) + part*self.values(i + 1)


def placesOf(grains):
    return np.concatenate([position(g).T for g in grains.values()])


def longestAxes(grains, shapes):
    """The two directions in which bodies and their ways are longest; of nearly
    equal ones x, then z. In two dimensions the third has no length at all."""
    span = np.ptp(placesOf(grains), axis=0) + np.max(
        [np.zeros(3)] + [np.ptp(s, axis=0) for s in shapes.values()
                         if s is not None], axis=0)
    span /= max(span.max(), 1e-300)

    def rank(axis):
        flat = span[axis] < 1e-6
        return flat, -round(span[axis], 1), axis if flat else (0, 2, 1)[axis]

    return tuple(sorted(sorted(range(3), key=rank)[:2]))


def extentOf(grains, shapes, axes):
    """Of all places of all bodies, with a margin: ((x0, x1), (y0, y1))."""
    places = placesOf(grains)
    sizes = [np.abs(s).max() for s in shapes.values() if s is not None]
    margin = 2*max(sizes, default=0.05*np.ptp(places))
    return [(places[:, a].min() - margin, places[:, a].max() + margin)
            for a in axes]


def drawFrame(file, time, grains, shapes, plane, extent, axes, label):
    spans = [high - low for low, high in extent]
    width = 9 if spans[0] >= spans[1] else 4.5
    height = min(9, max(2.4, width*spans[1]/spans[0] + 1.5))
    figure, ax = plt.subplots(figsize=(width, height), dpi=100)

    if plane.times:
        image = gp.drawField(ax, *plane.grid, plane.at(time), plane.limit,
                             cmap="viridis")
        figure.colorbar(image, ax=ax, label=label, aspect=40, shrink=0.7,
                        location="bottom" if width > 5 else "right")
    ax.set_aspect("equal")

    for name, grain in grains.items():
        step = np.median(np.diff(grain["time"], prepend=grain["time"][0]))
        if not -step <= time - grain["time"][0] \
                or time > grain["time"][-1] + step:
            continue
        state = gp.at(grain, time)
        centre = position(state)[list(axes)]
        if shapes[name] is None:
            ax.plot(*centre, "ko", markersize=4)
        else:
            points = turned(quaternion(state), shapes[name])[:, list(axes)]
            ax.fill(*(centre + hull(points)).T, facecolor="0.93",
                    edgecolor="k", linewidth=0.8, zorder=5)
    ax.set(xlim=extent[0], ylim=extent[1], title=f"t = {time:.4g} s",
           xlabel="xyz"[axes[0]] + " [m]", ylabel="xyz"[axes[1]] + " [m]")
    figure.savefig(file)
    plt.close(figure)


def join(frames, case, fps):
    """One file of all frames."""
    plots = case/"plots"
    images = [Image.open(f).convert("P", palette=Image.ADAPTIVE)
              for f in frames]
    images[0].save(plots/"animation.gif", save_all=True, loop=0,
                   append_images=images[1:], duration=int(1000/fps))
    print("Wrote", plots/"animation.gif")

    if shutil.which("ffmpeg"):
        subprocess.run(
            ["ffmpeg", "-y", "-loglevel", "error", "-framerate", str(fps),
             "-i", str(frames[0].parent/"frame%04d.png"), "-vf",
             "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p",
             str(plots/"animation.mp4")], check=True,
        )
        print("Wrote", plots/"animation.mp4")


def animate(case, frames=80, fps=12, field="U", start=None, end=None):
    case = pathlib.Path(case)
    grains, numbers = readGrains(case)
    shapes = readShapes(case, grains, numbers)
    plane = Plane(case, field)
    axes = plane.axes if plane.times else longestAxes(grains, shapes)
    extent = (
        [(g[0], g[-1]) for g in plane.grid] if plane.times
        else extentOf(grains, shapes, axes)
    )
    first = min(g["time"][0] for g in grains.values())
    last = max(g["time"][-1] for g in grains.values())
    times = np.linspace(first if start is None else start,
                        last if end is None else end, frames)
    folder = case/"plots/animation"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    files = [folder/f"frame{i:04d}.png" for i in range(frames)]
    label = "speed [m/s]" if field == "U" else field

    for file, time in zip(files, times):
        drawFrame(file, time, grains, shapes, plane, extent, axes, label)
    print(f"Wrote {frames} frames in {folder}")
    join(files, case, fps)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(
        description=__doc__, prefix_chars="-",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("case")
    parser.add_argument("-frames", type=int, default=80)
    parser.add_argument("-fps", type=float, default=12)
    parser.add_argument("-field", default="U")
    parser.add_argument("-start", type=float)
    parser.add_argument("-end", type=float)
    animate(**vars(parser.parse_args()))
