# SPDX-License-Identifier: GPL-3.0-or-later
"""Terminal velocity of a sphere that settles, in a comoving window."""

import math

import boxMesh
from bodyCase import BodyCase
from boxMesh import graded
from measure import Run, around, set_viscosity

RATIO, GALILEI, WIDTH = 2.56, 49, 7.5
SCALE = math.sqrt(RATIO - 1)    # sqrt((r - 1) g D), g = D = 1
COMPUTED, MEASURED = 0.870, 0.852

# Sides of the box slip; the sphere falls along x, fluid ahead is at rest
U = """
    inlet   { type fixedValue; value uniform (0 0 0); }
    outlet  { type zeroGradient; }
    sides   { type slip; }
"""
P = """
    inlet   { type zeroGradient; }
    outlet  { type fixedValue; value uniform 0; }
    sides   { type slip; }
"""
PATCHES = {"inlet": "x+", "outlet": "x-", "sides": "y- y+ z- z+"}
GRAVITY = """FoamFile
{
    version     2.0;
    format      ascii;
    class       uniformDimensionedVectorField;
    object      g;
}

dimensions      [0 1 -2 0 0 0 0];
value           (1 0 0);
"""


def set_boundaries(case):
    """Conditions of the box in 0/U and 0/p."""
    for field, conditions in (("U", U), ("p", P)):
        path = case.path / "0" / field
        head = path.read_text().split("boundaryField", 1)[0]
        path.write_text(f"{head}boundaryField\n{{{conditions}}}\n")


def rows(folder, quick):
    for cells in (8,) if quick else (8, 10):
        h = 1/cells
        case = BodyCase("tube", folder, f"D{cells}")
        across = graded(
            -0.5*WIDTH, 0.5*WIDTH, around(0, 0.8, h), h, growth=1.2
        )
        # Cells of the wake and of what is ahead
        along = graded(-15, 5, (-2.5, 0.8), h, growth=1.15)
        n = boxMesh.write(case, along, across, across, PATCHES)
        case.run("blockMesh")
        set_boundaries(case)
        set_viscosity(case, SCALE/GALILEI)
        (case.path / "constant/g").write_text(GRAVITY)
        case.bodies(f"""
            sphere
            {{
                shape       {{ type sphere; radius 0.5; }}
                densityRatio {RATIO};
                position    (0 0 0);
                velocity    ({COMPUTED*SCALE:.6g} 0 0);
            }}
        """, "window { type comoving; direction (1 0 0); }")
        case.controls(endTime="25", deltaT=f"{0.6*h/SCALE:.6g}")
        run = Run(case, "terminal velocity", cells, n)

        motion = case.table("motion")
        speed = motion["velocity_x"][-1]/SCALE
        yield run.row("V*", speed, COMPUTED)
        yield run.row("V* (experiment)", speed, MEASURED)
        last = motion["time"] > 0.8*motion["time"][-1]
        change = motion["velocity_x"][last]/SCALE/speed - 1
        yield run.row("last change, %", 100*abs(change).max())
