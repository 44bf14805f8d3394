# SPDX-License-Identifier: GPL-3.0-or-later
"""What the case needs besides mesh and fields, from the parameters of the run.

Writes constant/seedValues: the seed of etc/grains, its contact with the walls,
the metering roller and the place where it drops the grains; and
system/sensorPlanes: planes of an opticalSensor across the feed pipe, afterBend
and underHead, and across the open outlet tubes, outlet1 ... outletN, a
centimetre before their ends; beforeBend and inTube1 ... inTubeN where the
pressure is taken too."""

import math
import pathlib
import sys

sys.dont_write_bytecode = True

here = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(here.parent/"common"))

from benchPlots import parameters
from drillPiece import drillStations

BEFORE_END = 0.01
CELLS, GRAINS_PER_CELL = 24, 12
MISSES = DOUBLES = 0.03


def vector(values):
    return "(" + " ".join(f"{x:.9g}" for x in values) + ")"


def plane(name, point, normal, diameter, rate):
    return (f"{name} {{ point {vector(point)}; normal {vector(normal)}; "
            f"radius {diameter/2:.9g}; rate {rate:.9g}; }}")


def openOutlets(bench):
    head = bench["head"]
    return [number for number in range(1, head["outlets"] + 1)
            if number != head["blocked"]]


def sensorPlanes(bench):
    own, pipe, head, tubes = (
        bench[name] for name in ("drill", "feedPipe", "head", "outletTubes"))
    numbers, up = openOutlets(bench), (0, 0, 1)
    total, d = own["rate"]*len(numbers), pipe["diameter"]
    lines = [plane("afterBend", (0, 0, 0.2*d - own["riser"]), up, d, total),
             plane("underHead", (0, 0, -0.2*d), up, d, total)]
    for s in drillStations(bench):
        if s.name == "beforeBend":
            lines.append(plane(s.name, *s.frames[1], d, total))
        elif s.name.startswith("inTube"):
            lines.append(plane(s.name, *s.frames[1], tubes["diameter"],
                               own["rate"]))
    end = (head["diameter"]/2
           + tubes["diameter"] + tubes["shortLength"] - BEFORE_END)
    for number in numbers:
        angle = 2*math.pi*(number - 1)/head["outlets"]
        out = (math.cos(angle), math.sin(angle), 0)
        point = (end*out[0], end*out[1], head["outletHeight"])
        lines.append(plane(f"outlet{number}", point, out, tubes["diameter"],
                           own["rate"]))
    return lines


def seedValues(bench):
    own, d = bench["drill"], bench["feedPipe"]["diameter"]
    perTurn = CELLS*(GRAINS_PER_CELL*(1 - MISSES) + DOUBLES)
    turns = own["rate"]*len(openOutlets(bench))/perTurn
    start = -own["bendRadius"] - own["lengthBefore"]
    level = -own["riser"] - own["bendRadius"] + 0.2*d
    grain = f"$:grains.{own['seed']}"
    contact = f"{grain}.contact;"
    if own["restitution"]:
        contact += f" restitution {own['restitution']:.9g};"
    ends = [vector((start + x*d, 0, level)) for x in (0.3, 1.8)]
    return [
        f"rho {bench['air']['density']:.9g};",
        *(f"{name} {own[name]:.9g};"
          for name in ("wallRoughness", "rollingFriction", "airAlone")),
        f"contact {{ {contact} }}",
        f"population {{ {grain}.population; }}",
        f"roller {{ revolutionsPerSecond {turns:.9g}; cells {CELLS}; "
        f"grainsPerCell {GRAINS_PER_CELL}; }}",
        f"region {{ type cylinder; p1 {ends[0]}; p2 {ends[1]}; "
        f"radius {0.22*d:.9g}; }}"]


def main():
    bench = parameters(here)
    for file, lines in (("constant/seedValues", seedValues(bench)),
                        ("system/sensorPlanes", sensorPlanes(bench))):
        (here/file).write_text(
            "\n".join(["// Written by setUp.py", *lines]) + "\n")


if __name__ == "__main__":
    main()
