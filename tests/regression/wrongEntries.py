# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong entries of the case tube, and what the message about them says."""

from wrongAverages import AVERAGES
from wrongMotions import MOTIONS
from wrongSettings import SETTINGS
from wrongText import BODY, FILE
from wrongTraffic import TRAFFIC

# What is wrong: (file, text of the case, text instead, parts of the message)
WRONG = {
    # Keywords
    "no header": (
        FILE, "FoamFile", "Header", ["There is no header", "FoamFile", FILE],
    ),
    "keyword that is required": (
        FILE, "bodies\n",
        "contact { type softSphere; law Hertz; youngModulus 1e7;"
        " poissonRatio 0.3; }\nbodies\n",
        [
            "'contact' has no entry 'youngsModulus'",
            "nearest there is 'youngModulus'", FILE,
        ],
    ),
    "keyword": (
        FILE, "rho  ", "roh  ",
        ["'roh'", "nearest valid one is 'rho'", "Valid keywords", FILE],
    ),
    "keyword of a body": (
        FILE, "density ", "desnity ",
        ["'desnity'", "'density'", "'disc'", "constraints", FILE],
    ),
    "keyword of a shape": (
        FILE, "radius", "raduis 0.25; radius",
        ["'raduis'", "nearest valid one is 'radius'", FILE],
    ),
    "keyword of the coupling": (
        FILE, "bodies\n", "coupling { tolerence 1e-4; }\nbodies\n",
        ["'tolerence'", "nearest valid one is 'tolerance'",
         "nOuterCorrectors", "'coupling'", FILE],
    ),
    "keyword of the resistance": (
        FILE, "bodies\n", "resistance { steepnes 1; }\nbodies\n",
        ["'steepnes'", "nearest valid one is 'steepness'", "'resistance'",
         FILE],
    ),
    "keyword of the constraints": (
        FILE, BODY, BODY + " constraints { translation (1 0 0); }",
        ["'translation'", "nearest valid one is 'translate'", "rotate", FILE],
    ),

    # Types
    "type of shape": (
        FILE, "type disc", "type disk",
        ["'type disk'", "nearest valid one is 'disc'", "sphere", FILE],
    ),
    "no type of shape": (FILE, "type disc;", "", ["'type'", FILE]),
    "type of resistance": (
        FILE, "bodies\n", "resistance { type exponent; }\nbodies\n",
        ["'type exponent'", "nearest valid one is 'exponential'",
         "distanceWeighted", FILE],
    ),
    "type of contact": (
        FILE, "bodies\n", "contact { type softSpheres; }\nbodies\n",
        ["'type softSpheres'", "none", "contact", FILE],
    ),
    "type of lubrication": (
        FILE, "bodies\n", "lubrication { type leading; }\nbodies\n",
        ["'type leading'", "leadingOrder", "lubrication", FILE],
    ),
    "lubrication without contact": (
        FILE, "bodies\n",
        "lubrication { type leadingOrder; nu 1; }\nbodies\n",
        ["'lubrication'", "leadingOrder", "needs 'contact'"],
    ),
    "sphere in 2D": (
        FILE, "type disc", "type sphere",
        ["'type sphere'", "use 'disc'", FILE],
    ),

    # Values
    "negative radius": (
        FILE, "radius 0.25", "radius -0.25",
        ["'radius -0.25'", "greater than 0", FILE],
    ),
    "no radius": (FILE, "radius 0.25;", "", ["'radius'", FILE]),
    "negative rho": (
        FILE, "rho             1", "rho -1",
        ["'rho -1'", "greater than 0", FILE],
    ),
    "density without rho": (
        FILE, "rho             1;", "",
        ["'density'", "set 'rho'", "densityRatio", FILE],
    ),
    "no density": (
        FILE, "density     2;", "",
        ["'disc'", "one of 'density' and 'densityRatio'", FILE],
    ),
    "steepness": (
        FILE, "bodies\n", "resistance { steepness 2; }\nbodies\n",
        ["'steepness'", "'auto' or a number from 1 to 1.2", FILE],
    ),
    "zero iterations": (
        FILE, "bodies\n", "coupling { nOuterCorrectors 0; }\nbodies\n",
        ["'nOuterCorrectors 0'", "greater than 0", FILE],
    ),
    "more iterations at least than at most": (
        FILE, "bodies\n",
        "coupling { nOuterCorrectors 3; minOuterCorrectors 5; }\nbodies\n",
        ["'minOuterCorrectors 5' in 'coupling'", "'nOuterCorrectors', 3",
         FILE],
    ),
    "velocity": (
        FILE, "velocity    ambient", "velocity (1 0 0.1)",
        ["'velocity'", "'disc'", "out of the plane", FILE],
    ),

    # Orientation
    "orientation out of the plane": (
        FILE, BODY,
        BODY + " orientation { type axisAngle; axis (0 1 0); angle 20; }",
        ["'orientation' in 'disc'", "out of the plane", "(0 0 1)", FILE],
    ),
    "type of orientation": (
        FILE, BODY, BODY + " orientation { type axisangle; }",
        ["'type axisangle'", "nearest valid one is 'axisAngle'", FILE],
    ),
    "keyword of orientation": (
        FILE, BODY,
        BODY + " orientation { type axisAngle; axes (0 0 1); angle 20; }",
        ["'axes'", "nearest valid one is 'axis'", "'orientation'", FILE],
    ),
    "orientation in one word": (
        FILE, BODY, BODY + " orientation turned;",
        ["'orientation' in 'disc'", "'random'", "axisAngle", FILE],
    ),
    "random orientation without a seed": (
        FILE, BODY, BODY + " orientation random;", ["seed", FILE],
    ),

    # Places
    "no position": (
        FILE, BODY, "",
        ["'disc'", "exactly one of", "positionsFile", FILE],
    ),
    "position outside": (
        FILE, BODY, "position (5 0 0);",
        ["'position (5 0 0)'", "'disc'", "outside the mesh", "(3 1 0.05)",
         FILE],
    ),
    "overlap": (
        FILE, BODY, "positions ((-0.5 0 0) (-0.1 0 0));",
        ["overlap", "disc1 and disc2", FILE],
    ),
    "overlap with a wall": (
        FILE, BODY, "position (0 0.8 0);",
        ["overlap", "disc and a wall", FILE],
    ),
    "file of positions": (
        FILE, BODY, 'positionsFile "constant/grains";',
        ["'positionsFile'", "constant/grains", FILE],
    ),

    # Other dictionaries
    "steady state": (
        "system/fvSchemes", "backward", "steadyState",
        ["ddt(U)", "steadyState", "Euler", "backward", "system/fvSchemes"],
    ),
    "Crank-Nicolson": (
        "system/fvSchemes", "backward", "CrankNicolson 0.9",
        ["ddt(U)", "CrankNicolson", "Euler", "backward", "system/fvSchemes"],
    ),
    "solver": (
        "system/controlDict", "immersedFluid", "immersedfluid",
        ["immersedfluid", "immersedFluid", "incompressibleFluid",
         "system/controlDict"],
    ),

    **AVERAGES,
    **MOTIONS,
    **SETTINGS,
    **TRAFFIC,
}
