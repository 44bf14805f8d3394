# SPDX-License-Identifier: GPL-3.0-or-later
"""Heads for gmsh, with its OpenCASCADE kernel: that of bench.ini, or any from a
STEP file.

The head with the beginnings of pipe and tubes is one volume, of tetrahedra. The
rest of each tube is swept from its end in prisms, whose sections have a ring at
the wall of the thickness mesh.wallLayer, as the hexahedral mesh has. What comes
from a STEP file is all of tetrahedra.
"""

import math

import numpy as np

from pieces import HEADS, cells, outletFrame
from tubes import Path

try:
    import gmsh
except (ImportError, OSError):
    gmsh = None

# Part of the feed pipe's diameter that belongs to the volume of the head; cells
# of the pipe over those of the outlets
STUB, COARSER = 0.5, 2

# Largest distance of the centre of an opening from its place, over the length
# of the model
NEAR = 0.01


def centre(face):
    return np.array(gmsh.model.occ.getCenterOfMass(*face))


class SweptPath(Path):
    """A tube that is swept from faces at its beginning as the path goes on."""

    def __init__(self, start, tangent, side, faces):
        super().__init__(start, tangent, side)
        self.faces = faces

    def follow(self, grown):
        """Go on from the faces of what has grown that are at the new end."""
        end = self.frames[-1][0]
        self.faces = [
            face for face in grown
            if face[0] == 2 and np.allclose(centre(face), end, atol=1e-7)]

    def line(self, length, n):
        start = self.frames[-1][0]
        super().line(length, 1)
        self.follow(gmsh.model.occ.extrude(
            self.faces, *(self.frames[-1][0] - start), numElements=[n],
            recombine=True))

    def bend(self, radius, angle, towards, n):
        middle = self.frames[-1][0] + radius*np.asarray(towards, dtype=float)
        axis = np.cross(self.tangent, towards)
        super().bend(radius, angle, towards, 1)
        self.follow(gmsh.model.occ.revolve(
            self.faces, *middle, *axis, math.radians(angle), numElements=[n],
            recombine=True))


def cylinder(start, along, radius):
    return 3, gmsh.model.occ.addCylinder(*start, *along, radius)


def disc(place, tangent, radius):
    """A disc normal to a tangent that is upright or level."""
    occ = gmsh.model.occ
    face = [(2, occ.addDisk(0, 0, 0, radius, radius))]
    if abs(tangent[2]) < 0.5:
        occ.rotate(face, 0, 0, 0, 0, 1, 0, math.pi/2)
        occ.rotate(face, 0, 0, 0, 0, 0, 1, math.atan2(tangent[1], tangent[0]))
    occ.translate(face, *place)
    return face[0]


def ends(bench):
    """Beginnings of the swept parts: (place, tangent, side, radius) of the feed
    pipe, then of the outlets."""
    pipe, tubes = bench["feedPipe"], bench["outletTubes"]
    stub = min(STUB*pipe["diameter"], 0.5*pipe["length"])
    found = [(np.array([0, 0, -stub]), np.array([0, 0, -1]), (1, 0, 0),
              pipe["diameter"]/2)]
    for number in range(bench["head"]["outlets"]):
        place, out, side = outletFrame(bench, number)
        found.append((place + tubes["diameter"]*out, out, side,
                      tubes["diameter"]/2))
    return found


def addCore(bench):
    """The volume of the head, with the rings of the ends imprinted."""
    occ, head = gmsh.model.occ, bench["head"]
    volumes = [cylinder((0, 0, 0), (0, 0, head["height"]), head["diameter"]/2)]
    for place, tangent, _, radius in ends(bench):
        # From inside of the head: as far as it takes at the sides of a tube
        depth = 0.5*head["height"] if tangent[2] else radius
        wall = 0 if tangent[2] else 0.5*head["diameter"]
        inside = place - (abs(place @ tangent) - wall + depth)*tangent
        volumes.append(cylinder(inside, place - inside, radius))
    core, _ = occ.fuse(volumes[:1], volumes[1:])

    ring = 1 - 2*bench["mesh"]["wallLayer"]
    discs = [disc(place, tangent, ring*radius)
             for place, tangent, _, radius in ends(bench)]
    occ.fragment(core, discs)
    return occ.getEntities(2)


def addHead(bench, piece):
    """The head of bench.ini: {name of patch: faces}."""
    faces = addCore(bench)
    addTube, pipe = HEADS[piece](bench), bench["feedPipe"]
    size = bench["outletTubes"]["diameter"]/bench["gmsh"]["across"]
    patches = {}
    for number, (place, tangent, side, _) in enumerate(ends(bench)):
        path = SweptPath(place, tangent, side, [
            face for face in faces
            if np.allclose(centre(face), place, atol=1e-7)])
        if number == 0:
            length = pipe["length"] + place[2]
            path.line(length, cells(length, COARSER*size))
        else:
            addTube(path)
        name = f"outlet{number}" if number else "fanInlet"
        if not number or number != bench["head"]["blocked"]:
            patches[name] = path.faces
    return patches


def places(bench):
    """Middles of the openings of distributionHead, by the names of their
    patches: those that a STEP file has, if no others are given."""
    found = {"fanInlet": np.array([0, 0, -bench["feedPipe"]["length"]])}
    for number, (place, out, *_) in enumerate(ends(bench)[1:], 1):
        if number != bench["head"]["blocked"]:
            length = bench["outletTubes"]["shortLength"]
            found[f"outlet{number}"] = place + length*out
    return found


def unite(volumes):
    """Make one volume of several."""
    if len(volumes) > 1:
        gmsh.model.occ.fuse(volumes[:1], volumes[1:])


def readStep(file, openings):
    """Any head: the volumes of a STEP file, and its plane faces at the given
    places; {name of patch: faces}. ValueError if there is none."""
    occ = gmsh.model.occ
    volumes = [v for v in occ.importShapes(str(file)) if v[0] == 3]
    if not volumes:
        raise ValueError(f"{file} has no volume: the air in the head is wanted,"
                         " as a solid")
    unite(volumes)
    occ.synchronize()
    plane = [face for face in occ.getEntities(2)
             if gmsh.model.getType(*face) == "Plane"]
    low, high = np.reshape(gmsh.model.getBoundingBox(-1, -1), (2, 3))
    near = NEAR*np.linalg.norm(high - low)

    patches = {}
    for name, place in openings.items():
        face = min(plane, default=None,
                   key=lambda f: np.linalg.norm(centre(f) - place))
        if not face or np.linalg.norm(centre(face) - place) > near:
            known = "\n".join("  {:.6g} {:.6g} {:.6g}".format(*centre(f))
                              for f in plane)
            raise ValueError(
                f"{file}: no plane face has its centre at that of {name}, "
                "({:.6g} {:.6g} {:.6g}) m. Centres of plane faces:\n".format(
                    *place) + known)
        patches[name] = [face]
    return patches


def setSizes(bench, patches):
    """Size of the cells; near walls another if wanted."""
    size = bench["outletTubes"]["diameter"]/bench["gmsh"]["across"]
    option, model = gmsh.option.setNumber, gmsh.model
    model.mesh.setSize(model.getEntities(0), size)
    model.mesh.setSize(model.getBoundary(
        patches["fanInlet"], combined=False, recursive=True), COARSER*size)
    option("Mesh.MeshSizeMax", COARSER*size)

    walls = bench["gmsh"]["walls"]
    if walls < 1:
        field = model.mesh.field
        field.add("Distance", 1)
        field.setNumbers(1, "FacesList", wallFaces(patches))
        field.add("Threshold", 2)
        for name, value in (("InField", 1), ("SizeMin", walls*size),
                            ("SizeMax", COARSER*size), ("DistMin", 0),
                            ("DistMax", 4*size)):
            field.setNumber(2, name, value)
        field.setAsBackgroundMesh(2)


def wallFaces(patches):
    """Numbers of the faces outside that belong to no opening."""
    open_ = {face for faces in patches.values() for face in faces}
    outside = gmsh.model.getBoundary(
        gmsh.model.getEntities(3), combined=True, oriented=False)
    return [tag for dim, tag in outside if (dim, tag) not in open_]


def write(bench, patches, file):
    """Mesh what there is, and write it; returns the number of cells."""
    model = gmsh.model
    model.addPhysicalGroup(3, [tag for _, tag in model.getEntities(3)], 1)
    model.setPhysicalName(3, 1, "air")
    groups = {name: [tag for _, tag in faces]
              for name, faces in patches.items()}
    groups["walls"] = wallFaces(patches)
    for number, (name, tags) in enumerate(groups.items(), 2):
        model.addPhysicalGroup(2, tags, number)
        model.setPhysicalName(2, number, name)
    setSizes(bench, patches)
    model.mesh.generate(3)
    gmsh.option.setNumber("Mesh.MshFileVersion", 2.2)
    gmsh.write(str(file))
    return sum(len(tags) for tags in model.mesh.getElements(3)[1])
