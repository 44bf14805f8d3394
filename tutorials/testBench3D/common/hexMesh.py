# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of hexahedra, put together from blocks that share nodes, and written
in Gmsh's format (MSH 2.2) for gmshToFoam.

    mesh = HexMesh()
    layer = mesh.addPoints(xyz)               # indices of points, any shape
    mesh.addHexes(corners)                    # (n, 8) indices
    mesh.addPatch("outlet1", quads)           # (n, 4) indices
    mesh.write("tube.msh")

Points that coincide are merged. All faces with a cell on one side only that are
of no patch are of the patch `walls`. Lengths in m.
"""

import numpy as np

# Points nearer to each other than this are one [m]; no round number, so that no
# coordinate anyone would think of lies between two multiples of it
TOLERANCE = 1.2345678e-8

HEX_FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5),
             (2, 3, 7, 6), (3, 0, 4, 7))


class HexMesh:
    def __init__(self):
        self.points, self.hexes, self.patches = [], [], {}
        self.count = 0

    def addPoints(self, xyz):
        xyz = np.asarray(xyz, dtype=float)
        start = self.count
        self.count += xyz[..., 0].size
        self.points.append(xyz.reshape(-1, 3))
        return np.arange(start, self.count).reshape(xyz.shape[:-1])

    def addHexes(self, corners):
        self.hexes.append(np.asarray(corners).reshape(-1, 8))

    def addPatch(self, name, quads):
        self.patches.setdefault(name, []).append(
            np.asarray(quads).reshape(-1, 4))

    def addBox(self, nodes):
        """Hexes of a structured block, indices (ni, nj, nk)."""
        a, b = slice(None, -1), slice(1, None)
        self.addHexes(np.stack([
            nodes[a, a, a], nodes[b, a, a], nodes[b, b, a], nodes[a, b, a],
            nodes[a, a, b], nodes[b, a, b], nodes[b, b, b], nodes[a, b, b],
        ], axis=-1))

    def addSweep(self, layers, quads):
        """Hexes between layers (m, n) of n points each, which `quads` (q, 4)
        connects within a layer."""
        lower, upper = layers[:-1][:, quads], layers[1:][:, quads]
        self.addHexes(np.concatenate([lower, upper], axis=-1))

    def finish(self):
        """Points, hexes and {patch: quads}, of which walls comes last."""
        xyz = np.concatenate(self.points)
        cells = np.round(xyz/TOLERANCE).astype(np.int64)
        _, first, number = np.unique(
            cells, axis=0, return_index=True, return_inverse=True)
        xyz, number = xyz[first], number.reshape(-1)

        hexes = number[np.concatenate(self.hexes)]
        patches = {name: number[np.concatenate(quads)]
                   for name, quads in self.patches.items()}
        hexes = rightHanded(xyz, hexes)
        patches["walls"] = wallFaces(xyz, hexes, patches)

        # Without the points that no cell has
        used, number = np.unique(hexes, return_inverse=True)
        return xyz[used], number.reshape(-1, 8), {
            name: np.searchsorted(used, quads)
            for name, quads in patches.items()}

    def write(self, file):
        xyz, hexes, patches = self.finish()
        regions = [*patches, "air"]

        with open(file, "w") as out:
            out.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n")
            out.write(f"$PhysicalNames\n{len(regions)}\n")
            for tag, name in enumerate(regions, 1):
                out.write(f'{3 if name == "air" else 2} {tag} "{name}"\n')
            out.write(f"$EndPhysicalNames\n$Nodes\n{len(xyz)}\n")
            ids = np.arange(1, len(xyz) + 1)
            np.savetxt(out, np.column_stack([ids, xyz]),
                       fmt=["%d", "%.15g", "%.15g", "%.15g"])
            total = sum(map(len, patches.values())) + len(hexes)
            out.write(f"$EndNodes\n$Elements\n{total}\n")
            start = 1
            for tag, name in enumerate(regions, 1):
                nodes = hexes if name == "air" else patches[name]
                kind = 5 if name == "air" else 3
                ids = np.arange(start, start + len(nodes))[:, np.newaxis]
                head = np.tile([kind, 2, tag, tag], (len(nodes), 1))
                np.savetxt(out, np.hstack([ids, head, nodes + 1]), fmt="%d")
                start += len(nodes)
            out.write("$EndElements\n")

        return len(hexes)


def rightHanded(xyz, hexes):
    """Turn hexes of negative volume inside out."""
    corner = xyz[hexes]
    i, j, k = (corner[:, n] - corner[:, 0] for n in (1, 3, 4))
    left = np.einsum("ij,ij->i", np.cross(i, j), k) < 0
    hexes = hexes.copy()
    hexes[left] = hexes[left][:, [4, 5, 6, 7, 0, 1, 2, 3]]
    return hexes


def wallFaces(xyz, hexes, patches):
    """Faces of one cell that are of no patch."""
    faces = hexes[:, HEX_FACES].reshape(-1, 4)
    keys = np.sort(faces, axis=1)
    _, first, count = np.unique(
        keys, axis=0, return_index=True, return_counts=True)
    if count.max() > 2:
        raise RuntimeError("a face of more than two cells: blocks overlap")
    boundary = faces[first[count == 1]]

    named = {tuple(sorted(quad)) for quads in patches.values()
             for quad in quads.tolist()}
    at = [tuple(sorted(quad)) in named for quad in boundary.tolist()]
    if sum(at) != len(named):
        raise RuntimeError("a patch has faces that are not of the boundary")

    # Blocks that touch without sharing nodes would be a wall in between
    centres = np.round(xyz[boundary].mean(axis=1)/(100*TOLERANCE))
    if len(np.unique(centres, axis=0)) != len(boundary):
        raise RuntimeError("blocks touch without sharing nodes")
    return boundary[~np.array(at)]
