# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the pressure of the drill is taken, from the fan to the ends of tubes.

    pipeStations(bench, n), tubeStations(bench, n, frames)      # [Station]
    PARTS                       # what losses are told of

A station is three planes through the centres of cells that follow each other,
NAME_1 ... NAME_3, and its pressure their mean with WEIGHTS: where the length of
cells jumps, p and U go up and down from cell to cell, behind the entrance of a
tube by more than what is looked for, and that mean is free of it.
"""

import math
from dataclasses import dataclass

import numpy as np

WEIGHTS = (0.25, 0.5, 0.25)
# Stations of the feed pipe, by its legs; the first and the last one of a
# straight leg are as near to its ends as three cells of it let them be
LEGS = {"before": ("fan", "beforeBend"),
        "bend": ("inBend1", "inBend2"),
        "riser": ("afterBend", "inRiser", "underHead")}
# That of a tube, from where on its entrance is not seen [diameters]
SETTLED = 6

# (what, its first station, its last one or, into the open, None); ALL of them
ALL = "all"
PARTS = (("feed pipe", "fan", "beforeBend"),
         ("bend", "beforeBend", "afterBend"),
         ("riser", "afterBend", "underHead"), ("head", "underHead", "inTubes"),
         ("tubes", "inTubes", "ends"), ("exit", "ends", None),
         (ALL, "fan", None))


@dataclass
class Station:
    name: str
    distance: float         # from the fan, of a tube from the head's wall [m]
    frames: list            # (point, the way of the flow) of its planes
    reach: float            # [m]

    def planes(self):
        return [(f"{self.name}_{i}", *frame, self.reach)
                for i, frame in enumerate(self.frames, 1)]


def legs(bench):
    """Ends of the straight parts and of the bend, along the axis [m]."""
    own = bench["drill"]
    first = own["lengthBefore"]
    second = first + 0.5*math.pi*own["bendRadius"]
    return {"before": (0, first), "bend": (first, second),
            "riser": (second, second + own["riser"])}


def numbersWithin(ends, length, n):
    """Numbers of those cells, of n along the length, that lie in a part of it
    and have a neighbour on each side that does, if any have."""
    first = math.ceil(ends[0]/length*n - 1e-6) + 1
    last = math.floor(ends[1]/length*n + 1e-6) - 2
    if first > last:
        first = last = round(0.5*sum(ends)/length*n - 0.5)
    return first, last


def around(i, n):
    """Three cells of n, i in the middle."""
    i = min(max(i, 1), n - 2) if n > 2 else i
    return i, [min(max(j, 0), n - 1) for j in (i - 1, i, i + 1)]


def pipeNumbers(bench, n):
    """{station: number of its cell}, of n along the feed pipe."""
    found = {}
    for leg, names in LEGS.items():
        ends = legs(bench)[leg]
        low, high = numbersWithin(ends, legs(bench)["riser"][1], n)
        parts = (np.linspace(0, 1, len(names)) if leg != "bend"
                 else (np.arange(len(names)) + 1)/(len(names) + 1))
        found.update((name, round(low + part*(high - low)))
                     for name, part in zip(names, parts))
    return found


def onAxis(bench, distance):
    """Place on the axis of the feed pipe, and the way of the flow there."""
    own = bench["drill"]
    R, riser = own["bendRadius"], own["riser"]
    (_, first), (_, second), _ = legs(bench).values()
    angle = min(max(distance - first, 0)/R, 0.5*math.pi)
    x = min(distance - first, 0) - R + R*math.sin(angle)
    z = max(distance - second, 0) - riser - R*math.cos(angle)
    return (x, 0, z), (math.cos(angle), 0, math.sin(angle))


def pipeStations(bench, n):
    """Of the feed pipe of n cells."""
    size, found = legs(bench)["riser"][1]/n, []
    for name, number in pipeNumbers(bench, n).items():
        i, cells = around(number, n)
        found.append(Station(
            name, (i + 0.5)*size,
            [onAxis(bench, (j + 0.5)*size) for j in cells],
            bench["feedPipe"]["diameter"]))
    return found


def tubeStations(bench, n, frames):
    """One in each tube, whose straight leg behind the first one, of a diameter,
    has n cells; frames: {number: (place, way out)}."""
    tubes = bench["outletTubes"]
    d, size = tubes["diameter"], tubes["shortLength"]/n
    i, cells = around(round((SETTLED - 1)*d/size - 0.5), n)
    at = [d + (j + 0.5)*size for j in cells]
    return [Station(f"inTube{number}", d + (i + 0.5)*size,
                    [(tuple(place + s*out), tuple(out)) for s in at], d)
            for number, (place, out) in frames.items()]
