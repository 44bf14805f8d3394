# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases of the cost benchmark: vortices in a closed box or tube of fluid.

Lengths are in cells and speeds in that of the vortices, so that a time step of
0.5 is a Courant number of 0.5 where the cells have the size 1."""

import math

import boxMesh
import roundTube
from bodyCase import CASES, BodyCase
from boxMesh import uniform
from measure import set_orthogonal, set_smoother

WALLS = '"(inlet|outlet|walls)" { type %s; } frontAndBack { type empty; }'
# Cell Reynolds number 5: that of grains of eight cells is 40
VISCOSITY = 0.2


class Box:
    """nx x ny cells, or nx x ny x nz; `ratio`: that of the cells at the walls
    to those in the middle, which have the size 1."""

    # Between grains, over their diameter
    gap = 0.375

    def __init__(self, *cells, ratio=1):
        self.cells = math.prod(cells)
        growth = ratio**(1/(cells[0]//2 - 1))
        sides = cells
        if ratio > 1:
            sides = [
                2*(growth**(n//2) - 1)/(growth - 1) for n in cells
            ]
        self.low = [0]*len(cells)
        self.high = sides
        self.directions = [
            [0, (side/2, n//2, 1/ratio), (side/2, n//2, ratio)]
            if ratio > 1 else uniform(0, side, n)
            for side, n in zip(sides, cells, strict=True)
        ]

    @staticmethod
    def margin(diameter):
        """Of the centres of grains from its sides."""
        return diameter + 6

    def write(self, case):
        """Make the blockMeshDict."""
        sides = "x- x+ y- y+" + " z- z+"*(len(self.low) == 3)
        boxMesh.write(case, *self.directions, patches={"walls": sides})


class Tube:
    """Round tube of the length and radius in cells, closed at both ends."""

    # Where its cells are narrow grains come further than in a box
    gap = 0.8

    def __init__(self, length, radius):
        square = 2*round(0.62*radius)
        ring = max(3, round(radius - square/2))
        self.cells = length*(square**2 + 4*square*ring)
        self.length, self.radius = length, radius
        side = radius*math.sqrt(0.5)
        self.low = [0, -side, -side]
        self.high = [length, side, side]

    @staticmethod
    def margin(diameter):
        """Of the centres of grains from the sides of the square in it."""
        return diameter/2 + 2

    def write(self, case):
        """Make the blockMeshDict."""
        roundTube.write(
            case, uniform(0, self.length/self.radius, self.length),
            1/self.radius,
        )
        case.replace(
            "system/blockMeshDict", "\nvertices",
            f"\nscale {self.radius};\n\nvertices",
        )


def bodies(mesh, number, diameter, fixed=False):
    """Entry of random grains, clear of the walls."""
    margin = mesh.margin(diameter)
    low = [x + margin for x in mesh.low] + [0]*(3 - len(mesh.low))
    high = [x - margin for x in mesh.high] + [0]*(3 - len(mesh.low))
    motion = (
        "motion { type fixed; }" if fixed else
        "densityRatio 3; velocity ambient;"
    )
    shape = "sphere" if len(mesh.low) == 3 else "disc"
    return f"""
    grain
    {{
        shape        {{ type {shape}; radius {diameter/2}; }}
        {motion}
        random
        {{
            number {number}; seed 1; gap {mesh.gap*diameter};
            min ({low[0]} {low[1]} {low[2]});
            max ({high[0]} {high[1]} {high[2]});
        }}
    }}"""


def flow(mesh):
    """Expression of the velocity: cells of vortices that fill the height."""
    width = (mesh.high[1] - mesh.low[1])/2
    wave = math.pi/width
    across = f"*sin({wave}*pos().z())" if len(mesh.low) == 3 else ""
    x = f"{wave}*pos().x()"
    y = f"{wave}*(pos().y() - {mesh.low[1]})"
    return f"vector(sin({x})*cos({y}), -cos({x})*sin({y}), 0){across}"


def make(folder, mesh, name):
    """The case without bodies, meshed."""
    case = BodyCase("box", folder, name)
    for field, condition in (("U", "noSlip"), ("p", "zeroGradient")):
        case.replace(
            f"0/{field}", f"walls   {{ type {condition}; }}", WALLS % condition
        )
    (case.path/"constant/g").unlink()
    mesh.write(case)
    case.run("blockMesh")

    text = (CASES/"tube/system/setExprFieldsDict").read_text()
    head = text.split("expression  #{", 1)[0]
    (case.path/"system/setExprFieldsDict").write_text(
        f"{head}expression  #{{ {flow(mesh)} #}};\n    }}\n);\n"
    )
    case.run("setExprFields")

    # No function objects: they are not what is timed
    control = case.path/"system/controlDict"
    head = control.read_text().split("\nfunctions", 1)[0]
    control.write_text(f"{head}\nfunctions\n{{}}\n")

    solution = "system/fvSolution"
    set_smoother(case)
    case.replace(solution, "pRefCell ", "nCorrectors 2;\n    pRefCell ")
    case.replace(
        "system/fvSchemes", "none;",
        "none;\n    div((nuEff*dev2(T(grad(U))))) Gauss linear;",
    )
    if isinstance(mesh, Box):
        # Nothing to correct; for all solvers alike
        set_orthogonal(case)
    case.replace("constant/transportProperties", "0.1;", f"{VISCOSITY};")
    return case
