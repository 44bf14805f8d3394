# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections of round tubes and tubes along a path of straight and bent legs.

    section = Section(n=4, layers=2, wall=0.2)
    path = Path(start, tangent, side)
    path.line(0.5, n=20)
    path.bend(0.1, 90, towards=(0, 0, -1), n=12)
    layers = sweep(mesh, section, 0.0175, path)
"""

import numpy as np

# The middle of a section is the image of this part of the square; mean radius
CORE, CORE_RADIUS = 0.6, 0.57


def squareToDisc(u, v):
    """Unit disc from the square |u|, |v| <= 1. Squares about the middle become
    rounder outwards, until the outermost is the circle; equal steps along a
    side of the square are equal angles on the circle."""
    rho = np.maximum(np.abs(u), np.abs(v))
    safe = np.where(rho == 0, 1, rho)
    p, q = u/safe, v/safe
    across = np.abs(p) >= np.abs(q)
    angle = np.where(across, q, p)*np.pi/4
    x = np.where(across, np.sign(p)*np.cos(angle), np.sin(angle))
    y = np.where(across, np.sin(angle), np.sign(q)*np.cos(angle))
    blend = rho[..., np.newaxis]
    square = np.stack([p, q], axis=-1)/np.sqrt(2)
    return blend*((1 - blend)*square + blend*np.stack([x, y], axis=-1))


def outline(n):
    """Indices (i, j) of the 4n nodes around an n x n grid of cells."""
    s = range(n)
    return np.array(
        [(i, 0) for i in s] + [(n, j) for j in s]
        + [(n - i, n) for i in s] + [(0, n - j) for j in s])


class Section:
    """Quadrilaterals in the unit disc: n x n in the middle, `layers` rings of
    4n around them; the outermost ring is `wall` thick.

    grid    (n+1, n+1) nodes of the middle
    rings   (layers+1, 4n) nodes of the rings, from the middle out
    points  (m, 2) places of the nodes
    quads   (q, 4) nodes of the quadrilaterals
    """

    def __init__(self, n, layers, wall):
        self.n, self.layers = n, layers
        s = np.linspace(-1, 1, n + 1)
        u, v = np.meshgrid(s, s, indexing="ij")
        middle, circle = squareToDisc(CORE*u, CORE*v), squareToDisc(u, v)

        i, j = outline(n).T
        self.grid = np.arange((n + 1)**2).reshape(n + 1, n + 1)
        new = (n + 1)**2 + np.arange(4*n*layers).reshape(layers, 4*n)
        self.rings = np.vstack([self.grid[i, j], new])
        places = [middle.reshape(-1, 2)]
        for f in np.linspace(0, 1, layers)[1:]:
            places.append((1 - f)*middle[i, j] + f*(1 - wall)*circle[i, j])
        places.append(circle[i, j])
        self.points = np.concatenate(places)
        self.quads = np.concatenate(
            [gridQuads(self.grid), gridQuads(closed(self.rings))])

        # Places of the rings between the middle and the circle, about
        self.fractions = np.append(
            np.linspace(0, 1 - wall/(1 - CORE_RADIUS), layers), 1)


def closed(rings):
    """The first column again behind the last."""
    return np.hstack([rings, rings[:, :1]])


def gridQuads(nodes):
    """Quadrilaterals (q, 4) of a structured grid of nodes."""
    a, b = slice(None, -1), slice(1, None)
    return np.stack([nodes[a, a], nodes[b, a], nodes[b, b], nodes[a, b]],
                    axis=-1).reshape(-1, 4)


def unit(vector):
    vector = np.asarray(vector, dtype=float)
    return vector/np.linalg.norm(vector)


class Path:
    """Frames (position, side, up) along a tube; side and up span a section."""

    def __init__(self, start, tangent, side):
        self.tangent, side = unit(tangent), unit(side)
        self.frames = [(np.asarray(start, dtype=float), side,
                        np.cross(self.tangent, side))]

    def line(self, length, n):
        position, side, up = self.frames[-1]
        for s in np.linspace(0, length, n + 1)[1:]:
            self.frames.append((position + s*self.tangent, side, up))

    def bend(self, radius, angle, towards, n):
        """Turn by the angle [degrees] on a circle about the point that is
        `radius` away in the direction `towards`."""
        position, side, up = self.frames[-1]
        towards = np.asarray(towards, dtype=float)
        towards = unit(towards - towards @ self.tangent*self.tangent)
        centre = position + radius*towards
        axis = np.cross(self.tangent, towards)

        def turned(vector, a):
            return (np.cos(a)*vector + np.sin(a)*np.cross(axis, vector)
                    + (1 - np.cos(a))*(axis @ vector)*axis)

        for a in np.radians(np.linspace(0, angle, n + 1))[1:]:
            self.frames.append((centre + turned(position - centre, a),
                                turned(side, a), turned(up, a)))
        self.tangent = turned(self.tangent, np.radians(angle))


def sweep(mesh, section, radius, path, first=None):
    """Add the tube along the path; `first`: places (m, 3) of the nodes of its
    beginning instead of a plane section. Returns the nodes of the two ends as
    quadrilaterals."""
    a, b = radius*section.points.T[:, :, np.newaxis]
    layers = [p + a*side + b*up for p, side, up in path.frames]
    if first is not None:
        layers[0] = first
    nodes = mesh.addPoints(np.stack(layers))
    mesh.addSweep(nodes, section.quads)
    return nodes[0][section.quads], nodes[-1][section.quads]
