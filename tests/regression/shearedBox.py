# SPDX-License-Identifier: GPL-3.0-or-later
"""A box between two walls, y = -H/2 and y = H/2, that move against each other
along x; cyclic along x and, in 3D, along z.

    case = sheared_box(tmp_path, "box", length=4, cells=64)
    case.bodies(DISC)
    case.solve()
    row = last_row(case, "suspensionStress")
"""

import math
import re

import numpy as np

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform
from foamCase import tables

NU = 0.5

U = """
    "left|right|back|front" {{ type cyclic; }}
    bottom  {{ type fixedValue; value uniform ({low:.15g} 0 0); }}
    top     {{ type fixedValue; value uniform ({high:.15g} 0 0); }}
    frontAndBack {{ type empty; }}
"""
P = """
    "left|right|back|front" { type cyclic; }
    "bottom|top" { type zeroGradient; }
    frontAndBack { type empty; }
"""
STRESS = """
    suspensionStress
    {
        type            suspensionStress;
        libs            (immersedBodyFunctionObjects);
        writeControl    timeStep;
        writePrecision  15;
        %s
    }
"""


def sheared_box(folder, name, length, cells, height=None, dims=2, rate=1,
                entries="", stokes=True):
    """Cells of size length/cells. The box is as high, and in 3D as wide, as it
    is long, unless height is given."""
    case = BodyCase("tube", folder, name)
    height = height or length
    x = uniform(-length/2, length/2, cells)
    y = uniform(-height/2, height/2, round(cells*height/length))
    patches = {"left": "x-", "right": "x+", "bottom": "y-", "top": "y+"}
    pairs = [("left", "right")]
    if dims == 3:
        patches.update(back="z-", front="z+")
        pairs.append(("back", "front"))
    boxMesh.write(case, x, y, x if dims == 3 else None, patches)

    for pair in pairs:
        case.set_cyclic(*pair)
    for wall in ("bottom", "top"):
        case.replace("system/blockMeshDict", f"{wall} {{ type patch",
                     f"{wall} {{ type wall")
    case.run("blockMesh")
    case.conditions(U.format(low=-rate*height/2, high=rate*height/2), P)
    start_linear(case, rate)
    case.replace("system/controlDict", "functions\n{",
                 "functions\n{" + STRESS % entries)
    if stokes:
        case.replace("system/fvSchemes", "Gauss linear;\n}",
                     "none;\n}")
    case.controls(writeFormat="ascii", writePrecision="15")
    return case


def start_linear(case, rate):
    """Start with the flow without bodies."""
    n, y = centres(case)
    values = "\n".join(f"({rate*value + 0:.15g} 0 0)" for value in y)
    path = case.path/"0/U"
    path.write_text(path.read_text().replace(
        "uniform (0 0 0);",
        f"nonuniform List<vector> {n}\n(\n{values}\n);", 1))


def centres(case):
    """Number of cells, and y of their centres, for one block."""
    text = (case.path/"system/blockMeshDict").read_text()
    nx, ny, nz = map(int, re.search(
        r"hex \(.*?\) \((\d+) (\d+) (\d+)\)", text).groups())
    low, high = (float(v) for v in re.findall(
        r"^    \(\S+ (\S+) \S+\)", text, re.M)[1:3])
    y = low + (np.arange(ny) + 0.5)*(high - low)/ny
    return nx*ny*nz, np.tile(np.repeat(y, nx), nz)


def tighten(case):
    """Solve as far as rounding allows, nearly."""
    for old, new in (("1e-8;", "1e-11;"), ("0.01;", "0;"),
                     ("1e-9;", "1e-12;"), ("1e-3;", "0;")):
        case.replace("system/fvSolution", old, new)


def last_row(case, table, file=None):
    """The last row of a table: {column: value}."""
    columns = tables.run_columns(case.path, table, file or table)
    return {name: values[-1] for name, values in columns.items()}


def wall_stress(case):
    """Mean shear stress over density on the two walls [m2/s2], by differences
    between wall and cells beside it."""
    U = case.field("U")
    text = (case.path/"0/U").read_text()
    n, y = centres(case)
    low, high = (float(v) for v in re.findall(
        r"value uniform \((\S+) 0 0\)", text))
    h = np.diff(np.unique(np.round(y, 12)))[0]
    top, bottom = y > y.max() - 1e-9, y < y.min() + 1e-9
    return np.mean([
        NU*(high - U[top, 0].mean())/(h/2), NU*(U[bottom, 0].mean() - low)/(h/2)
    ])


def volume_fraction(radius, length, height, dims=2):
    return math.pi*radius**2/(length*height) if dims == 2 \
        else 4/3*math.pi*radius**3/(length*height*length)
