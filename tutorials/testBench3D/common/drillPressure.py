# SPDX-License-Identifier: GPL-3.0-or-later
"""The pressure of the drill part by part, without seeds and with them, beside
what published losses give for the same flow.

    found = pressures(run)      # run: a Drill; {station: times, static, total}
    rows = parts(run, found)    # [Part], in the order of PARTS

Losses are those of the total pressure, weighted with the flow. What seeds add
is the loss with them less that of the air alone, as the square of the flow.
"""

import math
from dataclasses import dataclass

import benchPlots as bp
import numpy as np
from drillLosses import Air, Seeds
from drillPiece import drillStations
from drillStations import PARTS, WEIGHTS
from grainfoam.study import analysis

# Of means: about as long, and so many at least [s]
BLOCK, LEAST_BLOCKS = 0.25, 8


@dataclass
class Part:
    """Values are (mean, half of the 95 % interval), published ones (least,
    greatest), in Pa; None: no seeds, or none has come to the tubes."""

    name: str
    alone: tuple
    published: tuple
    withSeeds: tuple = None
    added: tuple = None
    publishedAdded: tuple = None


def table(case, name):
    """(times, columns) of a function object, each time once."""
    rows = bp.table(case, name)[::-1]
    _, last = np.unique(rows[:, 0], return_index=True)
    return rows[last]


def station(run, name):
    """Times, static and total pressure [Pa] of a station."""
    planes = [table(run.case, f"{name}_{i}") for i in (1, 2, 3)]
    time, p, total = sum(w*rows for w, rows in zip(WEIGHTS, planes)).T
    return time, run.bench["air"]["density"]*p, total


def tubes(run, pattern):
    """The same of all tubes, weighted with their flow; pattern: inTube{} or
    outlet{}End, the patch."""
    found = []
    for number in run.outlets():
        name = pattern.format(number)
        flow = np.abs(table(run.case, f"outlet{number}")[:, -1])
        if name.endswith("End"):
            time, p, total = table(run.case, name).T
            p = run.bench["air"]["density"]*p
        else:
            time, p, total = station(run, name)
        found.append((flow, flow*p, flow*total))
    flow, p, total = np.sum(found, axis=0)
    return time, p/flow, total/flow


def pressures(run):
    """{station: (times, static, total)}, of each of the feed pipe and of the
    tubes together."""
    found = {s.name: station(run, s.name) for s in drillStations(run.bench)
             if not s.name.startswith("inTube")}
    found["inTubes"] = tubes(run, "inTube{}")
    found["ends"] = tubes(run, "outlet{}End")
    return found


def blockMeans(time, values, window):
    """Means of blocks of the window; a short one may have less than are
    wanted."""
    start, end = window
    inside = values[(time > start) & (time <= end)]
    number = max(LEAST_BLOCKS, int((end - start)/BLOCK))
    return np.array([block.mean() for block in np.array_split(
        inside, min(number, len(inside)))])


def mean(blocks):
    """(mean, half of its 95 % interval)."""
    value, low, high = analysis.mean_interval(blocks)
    return value, 0.5*(high - low)


def means(run, found):
    """{station: [(static, total)]} [Pa], without seeds and with them."""
    return {name: [tuple(blockMeans(time, p, window).mean() for p in values)
                   for window in run.windows()]
            for name, (time, *values) in found.items()}


def losses(run, found):
    """{part: [(mean, half of its interval)]}, without seeds and with them."""
    result = {}
    for name, first, last in PARTS:
        time, _, total = found[first]
        loss = total - (found[last][2] if last else 0)
        result[name] = [mean(blockMeans(time, loss, window))
                        for window in run.windows()]
    return result


def parts(run, found):
    """[Part]."""
    lost = losses(run, found)
    air = [Air(run, flow) for flow in run.flowRate()]
    published = air[0].published()
    rows = [Part(name, alone, tuple(published[name]))
            for name, (alone, *_) in lost.items()]
    if len(air) > 1:
        addSeeds(run, rows, lost, air)
    return rows


def loading(run):
    """Mass of the seeds that go through the feed pipe over that of the air."""
    air = Air(run, run.flowRate()[1])
    return Seeds(run, air).flow/air.mass


def addSeeds(run, rows, lost, air):
    """What the parts lose with seeds."""
    ratio = (air[1].U/air[0].U)**2
    published = Seeds(run, air[1]).published(ratio*lost["bend"][0][0])
    for part in rows:
        (alone, spread), part.withSeeds = lost[part.name]
        part.added = (part.withSeeds[0] - ratio*alone,
                      math.hypot(part.withSeeds[1], ratio*spread))
        if published:
            part.publishedAdded = tuple(published[part.name])
