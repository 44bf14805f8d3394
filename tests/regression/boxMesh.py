# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the blockMeshDict of a box, graded away from a core of equal cells.

    x = graded(-3, 3, core=(-0.3, 0.3), h=0.02)
    y = graded(-1, 1, core=(-0.5, 0.1), h=0.02)
    write(case, x, y, patches={"inlet": "x-", "outlet": "x+", "walls": "y- y+"})

A direction is a list of its start and its sections (length, cells, expansion).
"""

import math

HEADER = """FoamFile
{
    version     2.0;
    format      ascii;
    class       dictionary;
    object      blockMeshDict;
}
"""

# Corners of the faces of the one block
SIDES = {
    "x-": (0, 4, 7, 3), "x+": (1, 2, 6, 5),
    "y-": (0, 1, 5, 4), "y+": (3, 7, 6, 2),
    "z-": (0, 3, 2, 1), "z+": (4, 5, 6, 7),
}


def uniform(low, high, cells):
    """A direction with equal cells."""
    return [low, (high - low, cells, 1)]


def around(centre, half_width, h, offset=0.0):
    """Core of cells of size h about the centre, shifted by offset cells."""
    n = round(half_width/h)
    return centre - (n + offset)*h, centre + (n - offset)*h


def graded(low, high, core, h, growth=1.08):
    """Cells of size h in the core, at most `growth` times the last beyond."""
    cells = round((core[1] - core[0])/h)
    left = coarsen(core[0] - low, h, growth)
    right = coarsen(high - core[1], h, growth)
    if left:
        left = left[0], left[1], 1/left[2]
    sections = left, (core[1] - core[0], cells, 1), right
    return [low, *filter(None, sections)]


def coarsen(length, h, growth):
    """Section whose first cell is next to one of size h."""
    def reach(ratio, n):
        return sum(h*ratio**i for i in range(1, n + 1))

    if length < 1e-9*h:
        return None
    n = 1
    while reach(growth, n) < length:
        n += 1

    low, high = 0.5, growth
    for _ in range(60):
        middle = 0.5*(low + high)
        if reach(middle, n) < length:
            low = middle
        else:
            high = middle
    return length, n, low**(n - 1)


def write(case, x, y, z=None, patches=None):
    """Write system/blockMeshDict; in 2D (no z) the depth is 0.1.

    patches: sides by name; a name with "wall" is a wall; frontAndBack is added.
    """
    directions = x, y, z or uniform(-0.05, 0.05, 1)
    low = [d[0] for d in directions]
    high = [d[0] + sum(section[0] for section in d[1:]) for d in directions]
    patches = dict(patches)
    if z is None:
        patches["frontAndBack"] = "z- z+"

    corners = [
        (x, y, z)
        for z in (low[2], high[2])
        for x, y in (
            (low[0], low[1]), (high[0], low[1]),
            (high[0], high[1]), (low[0], high[1]),
        )
    ]
    cells = [sum(section[1] for section in d[1:]) for d in directions]
    grading = [
        " ".join("({:.15g} {} {:.15g})".format(*section) for section in d[1:])
        for d in directions
    ]

    lines = [HEADER, "vertices", "("]
    lines += ["    ({:.15g} {:.15g} {:.15g})".format(*c) for c in corners]
    lines += [");", "", "blocks", "("]
    lines += ["    hex (0 1 2 3 4 5 6 7) ({} {} {})".format(*cells)]
    lines += ["    simpleGrading", "    ("]
    lines += [f"        ({g})" for g in grading]
    lines += ["    )", ");", "", "boundary", "("]
    for name, sides in patches.items():
        kind = (
            "empty" if name == "frontAndBack" else
            "wall" if "wall" in name else "patch"
        )
        faces = " ".join(
            "({} {} {} {})".format(*SIDES[side]) for side in sides.split()
        )
        lines += [f"    {name} {{ type {kind}; faces ({faces}); }}"]
    lines += [");", ""]

    file = case.path / "system" / "blockMeshDict"
    file.write_text("\n".join(lines))
    return math.prod(cells)
