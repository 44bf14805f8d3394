# SPDX-License-Identifier: GPL-3.0-or-later
"""What the case needs besides the air of distributionHead.

Multiplies the velocity of that air in the cells, 0/U, by what headGrains.feedVelocity
is of air.feedVelocity, and turbulence as goes with it: at these Reynolds numbers the
flow is much the same. Writes system/outletPlanes: planes of an opticalSensor across
the outlet tubes, outlet1 ... outletN a centimetre before the ends of the open ones,
mouth<i> where a blocked one begins."""

import math
import pathlib
import re
import sys

sys.dont_write_bytecode = True

here = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(here.parent/"common"))

from benchPlots import parameters

BEFORE_END = 0.01


def plane(name, bench, number, distance):
    """distance: from the axis of the head [m]."""
    head, tubes = bench["head"], bench["outletTubes"]
    angle = 2*math.pi*(number - 1)/head["outlets"]
    out = (math.cos(angle), math.sin(angle), 0)
    point = (distance*out[0], distance*out[1], head["outletHeight"])
    words = [" ".join(f"{x:.9g}" for x in v) for v in (point, out)]
    return (f"{name} {{ point ({words[0]}); normal ({words[1]}); "
            f"radius {tubes['diameter']/2:.9g}; }}")


def multiply(file, factor):
    """The values in the cells of a field in ascii."""
    text = file.read_text()
    start = text.index("(", text.index("internalField"))
    end = text.index("boundaryField")
    cells = re.sub(r"[-+]?[0-9][-+0-9.e]*",
                   lambda number: f"{factor*float(number[0]):.8g}",
                   text[start:end])
    file.write_text(text[:start] + cells + text[end:])


def main():
    bench = parameters(here)
    head, tubes = bench["head"], bench["outletTubes"]
    end = (head["diameter"]/2
           + tubes["diameter"] + tubes["shortLength"] - BEFORE_END)
    lines = ["// Written by setUp.py"]
    for number in range(1, head["outlets"] + 1):
        if number == head["blocked"]:
            lines.append(plane(f"mouth{number}", bench, number,
                               head["diameter"]/2))
        else:
            lines.append(plane(f"outlet{number}", bench, number, end))
    (here/"system/outletPlanes").write_text("\n".join(lines) + "\n")

    factor = bench["headGrains"]["feedVelocity"]/bench["air"]["feedVelocity"]
    for name, power in (("U", 1), ("k", 2), ("omega", 1), ("nut", 1)):
        multiply(here/"0"/name, factor**power)


if __name__ == "__main__":
    main()
