# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes between the plates y = -1 and y = 1, with the patches of the case tube."""

import re
import shutil

from boxMesh import graded, uniform
from shearedMesh import shear

H = 1/12
LENGTH = 5

GEO = """
h = {h};
Point(1) = {{0, -1, -0.05, h}};
Point(2) = {{{length}, -1, -0.05, h}};
Point(3) = {{{length}, 1, -0.05, h}};
Point(4) = {{0, 1, -0.05, h}};
Line(1) = {{1, 2}};
Line(2) = {{2, 3}};
Line(3) = {{3, 4}};
Line(4) = {{4, 1}};
Curve Loop(1) = {{1, 2, 3, 4}};
Plane Surface(1) = {{1}};
{recombine}
sides[] = Extrude {{0, 0, 0.1}} {{ Surface{{1}}; Layers{{1}}; Recombine; }};
Physical Surface("frontAndBack") = {{1, sides[0]}};
Physical Surface("walls") = {{sides[2], sides[4]}};
Physical Surface("outlet") = {{sides[3]}};
Physical Surface("inlet") = {{sides[5]}};
Physical Volume("tube") = {{sides[1]}};
"""


def box(case, degrees=0):
    n = case.mesh(uniform(0, LENGTH, round(LENGTH/H)), uniform(-1, 1, round(2/H)))
    if degrees:
        shear(case, degrees)
    return n


def stretched(case):
    return case.mesh(
        graded(0, LENGTH, (0.2, 4.4), H, 1.15), graded(-1, 1, (-0.5, 0.5), H/2)
    )


def unstructured(case, recombine):
    """Triangles, or quads, of gmsh; one layer of prisms."""
    (case.path/"tube.geo").write_text(GEO.format(
        h=H*(1 if recombine else 1.3), length=LENGTH,
        recombine="Recombine Surface{1};" if recombine else "",
    ))
    case.run("gmsh", "-3", "-format", "msh2", "tube.geo")
    case.run("gmshToFoam", "tube.msh")
    file = case.path/"constant/polyMesh/boundary"
    text = file.read_text()
    for patch, kind in (("walls", "wall"), ("frontAndBack", "empty")):
        text = re.sub(rf"({patch}\s*{{\s*type\s+)patch", rf"\g<1>{kind}", text)
    file.write_text(text)
    case.run("setExprFields")
    check = case.run("checkMesh")
    return int(re.search(r"cells:\s+(\d+)", check)[1])


def meshes(quick):
    """Functions that mesh a case and return its number of cells, by name."""
    angles = (34,) if quick else (10, 20, 34, 45, 60)
    found = {"equal": box, "graded": stretched}
    if quick:
        found.pop("equal")
    for angle in angles:
        found[f"sheared {angle}"] = lambda case, a=angle: box(case, a)
    if shutil.which("gmsh"):
        found["triangles"] = lambda case: unstructured(case, False)
        if not quick:
            found["quads"] = lambda case: unstructured(case, True)
    else:
        print("gmsh is not installed: no triangles and no quads")
    return found
