# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes between the plates y = -1 and y = 1, with the patches of the case tube."""

import re
import shutil

import boxMesh
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

SNAPPY = """FoamFile { version 2.0; format ascii; class dictionary; object d; }
castellatedMesh true; snap false; addLayers false;
geometry
{
    middle { type searchableBox; min (0.4 -0.6 -1); max (2.5 0.8 1); }
}
castellatedMeshControls
{
    maxLocalCells 1000000; maxGlobalCells 1000000; minRefinementCells 0;
    maxLoadUnbalance 0.1; nCellsBetweenLevels 2; features ();
    refinementSurfaces {} resolveFeatureAngle 30;
    refinementRegions { middle { mode inside; levels ((1 1)); } }
    locationInMesh (0.013 0.011 0.012); allowFreeStandingZoneFaces false;
}
snapControls { nSmoothPatch 0; tolerance 1; nSolveIter 0; nRelaxIter 0; }
addLayersControls
{
    relativeSizes true; layers {} expansionRatio 1; finalLayerThickness 1;
    minThickness 1; nGrow 0; featureAngle 60; nRelaxIter 1;
    nSmoothSurfaceNormals 1; nSmoothNormals 1; nSmoothThickness 1;
    maxFaceThicknessRatio 1; maxThicknessToMedialRatio 1;
    minMedialAxisAngle 90; nBufferCellsNoExtrude 0; nLayerIter 1;
}
meshQualityControls
{
    maxNonOrtho 75; maxBoundarySkewness 20; maxInternalSkewness 4;
    maxConcave 80; minVol 1e-13; minTetQuality -1e30; minArea -1;
    minTwist 0.02; minDeterminant 0.001; minFaceWeight 0.02;
    minVolRatio 0.01; minTriangleTwist -1; nSmoothScale 4;
    errorReduction 0.75;
}
mergeTolerance 1e-6;
"""
EXTRUDE = """FoamFile {{ version 2.0; format ascii; class dictionary; object d; }}
constructFrom patch;
sourceCase "{case}";
sourcePatches (frontAndBack1);
exposedPatchName frontAndBack2;
flipNormals false;
extrudeModel linearNormal;
nLayers 1;
expansionRatio 1;
linearNormalCoeffs {{ thickness 0.1; }}
mergeFaces false;
mergeTol 0;
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
    return finished(case, {"walls": "wall", "frontAndBack": "empty"})


def refined(case):
    """Of snappyHexMesh: cells twice as large, halved about the body, where
    faces between large and small cells lie askew; its front, extruded."""
    h = 2*H
    boxMesh.write(
        case, uniform(0, LENGTH, round(LENGTH/h)), uniform(-1, 1, round(2/h)),
        uniform(0, h, 1),
        {"inlet": "x-", "outlet": "x+", "walls": "y- y+",
         "frontAndBack1": "z-", "frontAndBack2": "z+"},
    )
    case.run("blockMesh")
    system = case.path/"system"
    (system/"snappyHexMeshDict").write_text(SNAPPY)
    (system/"extrudeMeshDict").write_text(EXTRUDE.format(case=case.path))
    case.run("snappyHexMesh", "-overwrite")
    case.run("extrudeMesh")
    for field in "U", "p":
        case.replace(f"0/{field}", "frontAndBack ", '"frontAndBack.*" ')
    return finished(case, {"frontAndBack1": "empty", "frontAndBack2": "empty"})


def finished(case, kinds):
    """Set the types of patches, and the initial velocity; returns the number of
    cells."""
    file = case.path/"constant/polyMesh/boundary"
    text = file.read_text()
    for patch, kind in kinds.items():
        text = re.sub(rf"({patch}\s*{{\s*type\s+)patch", rf"\g<1>{kind}", text)
    file.write_text(text)
    case.run("setExprFields")
    return int(re.search(r"cells:\s+(\d+)", case.run("checkMesh"))[1])


def meshes(quick):
    """Functions that mesh a case and return its number of cells, by name."""
    angles = (34,) if quick else (10, 20, 34, 45, 60)
    found = {"equal": box, "graded": stretched}
    if quick:
        found.pop("equal")
    for angle in angles:
        found[f"sheared {angle}"] = lambda case, a=angle: box(case, a)
    if not quick:
        found["snappy"] = refined
    if shutil.which("gmsh"):
        found["triangles"] = lambda case: unstructured(case, False)
        if not quick:
            found["quads"] = lambda case: unstructured(case, True)
    else:
        print("gmsh is not installed: no triangles and no quads")
    return found
