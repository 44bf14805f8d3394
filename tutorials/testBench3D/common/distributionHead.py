# SPDX-License-Identifier: GPL-3.0-or-later
"""The distribution head: a flat cylinder about the z axis from z = 0 up, into
which the feed pipe opens from below, with round outlets all around.

Outside of the feed pipe's radius the cells are rings, in as many sectors as
there are outlets. In front of each outlet a box of n x n cells across and m
cells deep is taken out. A smaller box of as many cells, which continues the
middle of the tube's section, is put in its place, and a shell of cells between
the two, which continues the rings of the tube's section:

    from above     wall of the head
               ----+---+-----+---+----
                   |   |     |   |
                   |   +-----+   |
                   |  /       \\  |
               ----+-------------+----
                     to the axis
"""

import math
from dataclasses import dataclass

import numpy as np

from tubes import CORE, Section, outline, squareToDisc

# Depth of the box over the radius of the outlet; of the inner box over it
DEPTH, INNER_DEPTH = 0.8, 0.5


@dataclass
class Head:
    """Lengths [m] and numbers of cells."""

    pipeRadius: float
    radius: float
    height: float
    outlets: int
    outletRadius: float
    outletHeight: float
    section: Section        # of an outlet
    h: float                # size of other cells

    def __post_init__(self):
        self.n = self.section.n
        a = self.outletRadius
        self.pitch = 2*math.pi/self.outlets
        self.edge = math.asin(a/math.sqrt(2)/self.radius)
        self.depth = DEPTH*a
        if math.asin(a/self.radius) >= 0.49*self.pitch:
            raise ValueError(
                f"{self.outlets} outlets of diameter {2*a} m do not fit into "
                f"a head of diameter {2*self.radius} m")
        if not 1.1*a < self.outletHeight < self.height - 1.1*a:
            raise ValueError(
                f"outlets of diameter {2*a} m at {self.outletHeight} m do not "
                f"fit into a head of height {self.height} m")
        if self.radius - self.depth < 1.05*self.pipeRadius:
            raise ValueError("the feed pipe is too wide for this head")

        # Columns between outlets: the circle is divided by 4 as well
        gap = 2*self.radius*(0.5*self.pitch - self.edge)
        self.gap = max(1, round(gap/self.h))
        while self.outlets*(self.n + self.gap) % 4:
            self.gap += 1
        self.columns = self.n + self.gap
        self.angles = self.pitch*np.arange(self.columns + 1)/self.columns
        self.angles -= self.angles[self.n]/2

        half = 0.85*a
        low, high = self.outletHeight - half, self.outletHeight + half
        self.below = max(1, round(low/self.h))
        above = max(1, round((self.height - high)/self.h))
        self.z = np.concatenate([
            np.linspace(0, low, self.below + 1)[:-1],
            np.linspace(low, high, self.n + 1),
            np.linspace(high, self.height, above + 1)[1:]])
        self.m = max(2, round(0.7*self.n))


def transfinite(grid, i, j):
    """Fill grid[i0:i1+1, j0:j1+1] from its edges (Coons)."""
    block = grid[i[0]:i[1] + 1, j[0]:j[1] + 1]
    u = np.linspace(0, 1, block.shape[0])[:, np.newaxis, np.newaxis]
    v = np.linspace(0, 1, block.shape[1])[np.newaxis, :, np.newaxis]
    left, right = block[:1].copy(), block[-1:].copy()
    low, high = block[:, :1].copy(), block[:, -1:].copy()
    corners = ((1 - u)*(1 - v)*left[:, :1] + u*(1 - v)*right[:, :1]
               + (1 - u)*v*left[:, -1:] + u*v*right[:, -1:])
    block[:] = (1 - u)*left + u*right + (1 - v)*low + v*high - corners


def sectorOfWall(head):
    """(columns+1, rows+1, 2) angles and heights at the wall of the head, with
    nodes on the circle of the outlet; inside of it there are none."""
    n, top = head.n, len(head.z) - 1
    j0, j1 = head.below, head.below + n
    angle, z = np.meshgrid(head.angles, head.z, indexing="ij")
    grid = np.stack([angle, z], axis=-1)

    s = np.linspace(-1, 1, n + 1)
    disc = head.outletRadius*squareToDisc(*np.meshgrid(s, s, indexing="ij"))
    circle = np.stack([np.arcsin(disc[..., 0]/head.radius),
                       head.outletHeight + disc[..., 1]], axis=-1)
    grid[:n + 1, j0:j1 + 1] = circle
    grid[-1, j0:j1 + 1] = circle[0] + (head.pitch, 0)

    # Columns at the height of the outlet, then what is below and above
    grid[:n + 1, 0, 0] = grid[:n + 1, -1, 0] = np.linspace(
        circle[0, 0, 0], circle[-1, 0, 0], n + 1)
    grid[n:, 0, 0] = grid[n:, -1, 0] = np.linspace(
        circle[-1, 0, 0], grid[-1, j0, 0], head.gap + 1)
    for j in (j0, j1):
        grid[n:, j] = np.linspace(grid[n, j], grid[-1, j], head.gap + 1)
    for i in (0, n, head.columns):
        for a, b in ((0, j0), (j1, top)):
            grid[i, a:b + 1] = np.linspace(grid[i, a], grid[i, b], b - a + 1)
    for i in ((0, n), (n, head.columns)):
        transfinite(grid, i, (0, j0))
        transfinite(grid, i, (j1, top))
    transfinite(grid, (n, head.columns), (j0, j1))
    return grid


def cylindrical(r, angle, z):
    return np.stack(np.broadcast_arrays(
        r*np.cos(angle), r*np.sin(angle), z), axis=-1)


def addSector(mesh, head, number):
    """The cells around outlet `number` (from 0), outside of the box too.
    Returns the places of the nodes of the outlet's section."""
    n, m, turn = head.n, head.m, number*head.pitch
    wall = sectorOfWall(head)
    angle, z = np.meshgrid(head.angles, head.z, indexing="ij")
    plain = np.stack([angle, z], axis=-1)

    # Layers from the depth of the box (k = 0) to the wall (k = m)
    s = np.linspace(0, 1, m + 1)[:, np.newaxis, np.newaxis, np.newaxis]
    grid = (1 - s)*plain + s*wall
    r = head.radius - head.depth*(1 - s[..., 0])
    nodes = mesh.addPoints(
        cylindrical(r, grid[..., 0] + turn, grid[..., 1]))

    j0, j1 = head.below, head.below + n
    mesh.addBox(nodes[:, n:, :])
    mesh.addBox(nodes[:, :n + 1, :j0 + 1])
    mesh.addBox(nodes[:, :n + 1, j1:])
    return addShell(mesh, head, turn, nodes[:, :n + 1, j0:j1 + 1])


def boxPlaces(head, turn, u, v, s):
    """Places in the box: u, v from -1 to 1 across, s = 1 at the wall."""
    a, j0 = head.outletRadius, head.below
    disc = a*squareToDisc(u, v)
    half = head.angles[head.n]
    low, high = head.z[j0], head.z[j0 + head.n]
    angle = (1 - s)*half*u + s*np.arcsin(disc[..., 0]/head.radius)
    z = (1 - s)*(0.5*(low + high) + 0.5*(high - low)*v) \
        + s*(head.outletHeight + disc[..., 1])
    r = head.radius - head.depth*(1 - s)
    return cylindrical(r, angle + turn, z)


def addShell(mesh, head, turn, box):
    """Fill the box (m+1, n+1, n+1) with the inner box and the shell."""
    n, m = head.n, head.m
    c = CORE*np.linspace(-1, 1, n + 1)
    s = 1 - INNER_DEPTH*(1 - np.linspace(0, 1, m + 1))
    s, u, v = np.meshgrid(s, c, c, indexing="ij")
    places = boxPlaces(head, turn, u, v, s)
    inner = mesh.addPoints(places)
    mesh.addBox(inner)

    points = np.concatenate(mesh.points)
    i, j = outline(n).T

    def between(a, b):
        """Nodes from a to b along a new first axis."""
        f = head.section.fractions[1:-1]
        f = f.reshape(-1, *(1,)*(a.ndim + 1))
        new = mesh.addPoints((1 - f)*points[a] + f*points[b])
        return np.concatenate([a[np.newaxis], new, b[np.newaxis]])

    sides = between(inner[:, i, j], box[:, i, j])
    mesh.addBox(np.concatenate([sides, sides[..., :1]], axis=-1))
    mesh.addBox(between(inner[0], box[0]))

    # The section at the wall, in the order of Section
    atWall = np.concatenate([inner[-1].reshape(-1), sides[1:, -1].reshape(-1)])
    return np.concatenate(mesh.points)[atWall]


def addHead(mesh, head, pipeLength, pipeWall, pipeCells):
    """Head and feed pipe; the latter begins at z = -pipeLength with the patch
    fanInlet. Returns the places of the nodes of each outlet's section."""
    quarter = head.outlets*head.columns//4
    section = Section(quarter, max(2, round(0.2*quarter)), pipeWall)
    turn = head.angles[0] - firstAngle(section)
    a, b = head.pipeRadius*section.points.T
    x, y = (a*math.cos(turn) - b*math.sin(turn),
            a*math.sin(turn) + b*math.cos(turn))

    z = np.concatenate(
        [np.linspace(-pipeLength, 0, pipeCells + 1)[:-1], head.z])
    layers = mesh.addPoints(np.stack(np.broadcast_arrays(
        x, y, z[:, np.newaxis]), axis=-1))
    mesh.addSweep(layers, section.quads)
    mesh.addPatch("fanInlet", layers[0][section.quads])

    # Rings from the pipe's radius to the boxes
    inner = head.radius - head.depth
    count = max(1, round((inner - head.pipeRadius)/head.h))
    r = np.linspace(head.pipeRadius, inner, count + 1)
    angles = head.pitch*np.arange(4*quarter)/head.columns + head.angles[0]
    rings = mesh.addPoints(cylindrical(
        r[:, np.newaxis, np.newaxis], angles[:, np.newaxis], head.z))
    mesh.addBox(np.concatenate([rings, rings[:, :1]], axis=1))

    return [addSector(mesh, head, k) for k in range(head.outlets)]


def firstAngle(section):
    """Angle of the first node of the circle of a section."""
    x, y = section.points[section.rings[-1, 0]]
    return math.atan2(y, x)
