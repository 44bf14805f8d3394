# SPDX-License-Identifier: GPL-3.0-or-later
"""The drill as a piece of the bench: mesh and flow, and where its pressure is
taken. A feed pipe with a bend, the head, its tubes."""

import math

import numpy as np
from drillStations import pipeStations, tubeStations
from pieces import (cellLength, cells, headWithTubes, outletFrame, pipeCells,
                    shortTubes)


def bent(points, riser, radius):
    """Places of a pipe that comes up from below along z, with all that is
    further than `riser` below z = 0 on a bend, and what is beyond a quarter of
    a circle horizontal: the flow comes along x."""
    x, y, z = points.T
    along = np.maximum(-z - riser, 0)
    angle = np.minimum(along/radius, 0.5*math.pi)
    beyond = along - radius*angle
    turned = np.stack([
        (radius + x)*np.cos(angle) - radius - beyond*np.sin(angle), y,
        -riser - (radius + x)*np.sin(angle) - beyond*np.cos(angle)], axis=-1)
    return np.where((along > 0)[:, np.newaxis], turned, points)


def drillPipe(bench):
    """The bench with the whole length of the drill's feed pipe, and with its
    cells."""
    own = bench["drill"]
    length = (own["lengthBefore"] + 0.5*math.pi*own["bendRadius"]
              + own["riser"])
    return {**bench, "feedPipe": {**bench["feedPipe"], "length": length},
            "mesh": {**bench["mesh"],
                     **{name: own[name] for name in ("across", "along")}}}


def drill(bench):
    """Feed pipe with a bend, head, tubes; a blocked outlet is closed where its
    tube would begin."""
    own, bench = bench["drill"], drillPipe(bench)
    if own["bendRadius"] < bench["feedPipe"]["diameter"]:
        raise ValueError("drill.bendRadius: one diameter of the feed pipe at "
                         "least")
    mesh, flow = headWithTubes(
        bench, shortTubes(bench), True, longestCell(bench))
    mesh.points = [bent(points, own["riser"], own["bendRadius"])
                   for points in mesh.points]
    planes = [plane for s in drillStations(bench) for plane in s.planes()]
    flow["stations"], flow["pressures"] = [], (planes, flow["outlets"])
    flow["outlets"] = ["fanInlet", *flow["outlets"]]
    flow["values"] = {name: own[name] for name in (
        "fanPressure", "fanFlow", "endTime", "timeStep")}
    return mesh, flow


def longestCell(bench):
    """Longest cells of the feed pipe [m]: of ten degrees in its bend."""
    return math.radians(10)*bench["drill"]["bendRadius"]


def drillStations(bench):
    """Of the feed pipe of the drill and of its open tubes."""
    bench = drillPipe(bench)
    head, length = bench["head"], bench["outletTubes"]["shortLength"]
    frames = {number: outletFrame(bench, number - 1)[:2]
              for number in range(1, head["outlets"] + 1)
              if number != head["blocked"]}
    n = cells(length, cellLength(bench, "outletTubes"))
    return [*pipeStations(bench, pipeCells(bench, longestCell(bench))),
            *tubeStations(bench, n, frames)]
