# SPDX-License-Identifier: GPL-3.0-or-later
"""The pieces of the bench but the drill: mesh and flow of each, from its
parameters.

    mesh, flow = PIECES["bend"](bench)

flow: mean velocity and diameter at the inlet; stations, where the mean pressure
is wanted, and planes for pictures, (name, point, normal, reach) each, with the
names of fields; outlets. Tubes begin at the origin and go up, z.
"""

import math

import numpy as np

from distributionHead import Head, addHead
from hexMesh import HexMesh
from tubes import Path, Section, sweep

# Where the mean pressure along the measuring tube is taken
STATIONS = 12


def cells(length, size):
    return max(1, round(length/size))


def tubeSection(bench):
    mesh = bench["mesh"]
    fine = mesh["resolution"]
    if mesh["wallLayer"] > 0.2:
        raise ValueError("mesh.wallLayer: 0.2 diameters at most")
    return Section(max(2, round(fine*mesh["across"])),
                   1 + max(1, round(fine*mesh["rings"])), 2*mesh["wallLayer"])


def centres(places, length, n):
    """Places along a tube of n cells, moved to the nearest centres of cells,
    where pressures are not half a cell off."""
    return (np.floor(np.asarray(places)/length*n) + 0.5)*length/n


def cellLength(bench, piece, entry="along"):
    mesh = bench["mesh"]
    return mesh[entry]*bench[piece]["diameter"]/mesh["resolution"]


def oneTube(bench, piece, path):
    """A tube with the patches fanInlet and outlet1."""
    mesh = HexMesh()
    diameter = bench[piece]["diameter"]
    first, last = sweep(mesh, tubeSection(bench), diameter/2, path)
    mesh.addPatch("fanInlet", first)
    mesh.addPatch("outlet1", last)
    return mesh, {"meanVelocity": bench["air"]["tubeVelocity"],
                  "diameter": diameter}


def upwards():
    return Path((0, 0, 0), (0, 0, 1), (1, 0, 0))


def measuringTube(bench):
    tube, path = bench["measuringTube"], upwards()
    length = tube["length"]
    n = cells(length, cellLength(bench, "measuringTube"))
    path.line(length, n)
    mesh, flow = oneTube(bench, "measuringTube", path)

    up, reach = (0, 0, 1), 2*tube["diameter"]
    if not all(0 < z < length for z in tube["sensorPlanes"]):
        raise ValueError(f"measuringTube.sensorPlanes: not all in its length, "
                         f"{length} m")
    stations = centres(
        length*(np.arange(STATIONS) + 0.5)/STATIONS, length, n)
    flow["distances"] = {"pressure": stations}
    flow["stations"] = [(f"pressure{i}", (0, 0, z), up, reach)
                        for i, z in enumerate(stations)]
    flow["planes"] = [("along", (0, 0, length/2), (0, 1, 0), length)]
    flow["planes"] += [(f"sensor{i}", (0, 0, z), up, reach)
                       for i, z in enumerate(tube["sensorPlanes"], 1)]
    return mesh, flow


def periodicTube(bench):
    tube, path = bench["periodicTube"], upwards()
    path.line(tube["length"], tube["cells"])
    mesh, flow = oneTube(bench, "periodicTube", path)
    first = (0, 0, 0.5*tube["length"]/tube["cells"])
    flow["planes"] = [
        ("section", first, (0, 0, 1), tube["diameter"]),
        ("along", (0, 0, 0.5*tube["length"]), (0, 1, 0), 10)]
    return mesh, flow


def periodicTubeLES(bench):
    """With a section and a velocity of its own."""
    own = bench["periodicTubeLES"]
    section = {name: own[name] for name in ("across", "rings", "wallLayer")}
    mesh, flow = periodicTube({
        **bench, "periodicTube": own, "mesh": {**bench["mesh"], **section},
        "air": {**bench["air"], "tubeVelocity": own["velocity"]}})
    flow["fields"] = "U p UMean UPrime2Mean"
    return mesh, flow


def addBend(path, radius, angle, towards, size):
    """A bend, if the angle [degrees] is not 0, with cells of this length at
    its outer side and no more than 7.5 degrees each."""
    if angle:
        n = max(cells(radius*math.radians(angle), size), math.ceil(angle/7.5))
        path.bend(radius, angle, towards, n)


def bend(bench):
    tube, path = bench["bend"], upwards()
    size = cellLength(bench, "bend")
    path.line(tube["lengthBefore"], cells(tube["lengthBefore"], size))
    addBend(path, tube["radius"], tube["angle"], (1, 0, 0), size)
    path.line(tube["lengthAfter"], cells(tube["lengthAfter"], size))
    mesh, flow = oneTube(bench, "bend", path)
    flow.update(bendSampling(tube, path, size))
    return mesh, flow


def bendSampling(tube, path, size):
    """Stations in the straight parts, up to one diameter from the ends and from
    the bend; planes before, in and after the bend."""
    D, R = tube["diameter"], tube["radius"]
    angle = math.radians(tube["angle"])
    centre = np.array([R, 0, tube["lengthBefore"]])
    up, out = np.array([0, 0, 1]), path.tangent

    def inBend(part):
        a = part*angle
        return (centre + R*np.array([-math.cos(a), 0, math.sin(a)]),
                np.array([math.sin(a), 0, math.cos(a)]))

    end, _ = inBend(1)
    before, after = (
        centres(np.linspace(D, length - D, n), length, cells(length, size))
        for length, n in ((tube["lengthBefore"], 4), (tube["lengthAfter"], 12)))
    stations = [(f"before{i}", s*up, up, D) for i, s in enumerate(before)]
    stations += [(f"after{i}", end + s*out, out, D)
                 for i, s in enumerate(after)]
    planes = [("along", centre, (0, 1, 0), 10),
              ("before", (tube["lengthBefore"] - D)*up, up, D),
              ("middle", *inBend(0.5), D), ("end", *inBend(1), D),
              ("after2D", end + 2*D*out, out, D),
              ("after10D", end + 10*D*out, out, D)]
    return {"stations": stations, "planes": planes,
            "distances": {"before": before, "after": after}}


def headShape(bench):
    """The head, with what has to fit checked."""
    pipe, head, tubes = bench["feedPipe"], bench["head"], bench["outletTubes"]
    if head["blocked"] > head["outlets"]:
        raise ValueError(f"head.blocked: {head['blocked']} is none of the "
                         f"{head['outlets']} outlets")
    section, width = tubeSection(bench), tubes["diameter"]
    return Head(pipe["diameter"]/2, head["diameter"]/2, head["height"],
                head["outlets"], width/2, head["outletHeight"], section,
                width/section.n)


def outletFrame(bench, number):
    """Place of an outlet (from 0) on the wall of the head, direction of its
    tube, and a direction across."""
    head = bench["head"]
    angle = 2*math.pi*number/head["outlets"]
    out = np.array([math.cos(angle), math.sin(angle), 0])
    return (0.5*head["diameter"]*out + (0, 0, head["outletHeight"]), out,
            (-out[1], out[0], 0))


def headFlow(bench, outlets):
    """Flow of a piece with a head; outlets: names of the open ones."""
    pipe = bench["feedPipe"]
    # Planes through nodes would miss cells
    beside = np.array([0, 1e-4, bench["head"]["outletHeight"] + 1e-4])
    return {
        "meanVelocity": bench["air"]["feedVelocity"],
        "diameter": pipe["diameter"],
        "outlets": outlets,
        "planes": [("vertical", beside, (0, 1, 0), 10),
                   ("horizontal", beside, (0, 0, 1), 10)],
        "stations": [("feedPipe", (0, 0, -0.5*pipe["length"]), (0, 0, 1),
                      pipe["diameter"])],
    }


def pipeCells(bench, longest=math.inf):
    """Number of cells along the feed pipe, none longer than `longest` [m]."""
    return cells(bench["feedPipe"]["length"],
                 min(3*headShape(bench).h, longest))


def headWithTubes(bench, addTube, closed=False, longest=math.inf):
    """Feed pipe, head, and a tube at each outlet; addTube(path) adds its legs
    but the first, short one. The blocked one ends in a wall, or has no tube if
    it is closed. longest: of cells along the feed pipe [m]."""
    pipe, head, tubes = bench["feedPipe"], bench["head"], bench["outletTubes"]
    shape = headShape(bench)

    mesh = HexMesh()
    places = addHead(mesh, shape, pipe["length"], 2*bench["mesh"]["wallLayer"],
                     pipeCells(bench, longest))
    for number, first in enumerate(places):
        if closed and number + 1 == head["blocked"]:
            continue
        path = Path(*outletFrame(bench, number))
        path.line(tubes["diameter"], 4)
        addTube(path)
        _, last = sweep(mesh, shape.section, tubes["diameter"]/2, path, first)
        if number + 1 != head["blocked"]:
            mesh.addPatch(f"outlet{number + 1}", last)

    return mesh, headFlow(
        bench, [name for name in mesh.patches if name != "fanInlet"])


def shortTubes(bench):
    """What adds the legs of an outlet tube to a path: one, straight."""
    size = cellLength(bench, "outletTubes", "along")
    length = bench["outletTubes"]["shortLength"]
    return lambda path: path.line(length, cells(length, size))


def longTubes(bench):
    """The same for whole tubes, with bends if wanted."""
    tubes = bench["outletTubes"]
    size = cellLength(bench, "outletTubes", "alongOutletTubes")

    def addTube(path):
        path.line(tubes["length"], cells(tubes["length"], size))
        if tubes["bendAngle"]:
            addBend(path, tubes["bendRadius"], tubes["bendAngle"], (0, 0, -1),
                    size)
            if tubes["endLength"]:
                path.line(tubes["endLength"], cells(tubes["endLength"], size))

    return addTube


# Pieces with a head, by what their outlet tubes are
HEADS = {"distributionHead": shortTubes, "wholeBench": longTubes}


def distributionHead(bench):
    return headWithTubes(bench, shortTubes(bench))


def wholeBench(bench):
    return headWithTubes(bench, longTubes(bench))


PIECES = {f.__name__: f for f in (
    measuringTube, periodicTube, periodicTubeLES, bend, distributionHead,
    wholeBench)}
