# SPDX-License-Identifier: GPL-3.0-or-later
"""A box of equal cells that repeats itself in all directions, shifted and
moving across its top and bottom (Lees & Edwards)."""

import re

import numpy as np

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform
from foamCase import tables

N = 24
TIGHT = "coupling { tolerance 1e-11; nOuterCorrectors 60; }"
NAMES = "velocity_x", "velocity_y", "angularVelocity_z"
FIELD = "internalField   nonuniform List<vector>\n{n}\n(\n{rows}\n);\n"
STRESS = """
    stress
    {
        type            suspensionStress;
        libs            (immersedBodyFunctionObjects);
        writeControl    timeStep;
        writePrecision  15;
    }
"""
BOUNDARY = """boundaryField
{{
    "left|right|back|front" {{ type cyclic; }}
    "bottom|top" {{ type {kind}; }}
    "frontAndBack.*" {{ type empty; }}
}}
"""


def pair(case, one, other, kind="cyclic", entries=""):
    """Make two patches one another's continuation."""
    for a, b, more in ((one, other, entries), (other, one, "")):
        case.replace(
            "system/blockMeshDict", f"    {a} {{ type patch;",
            f"    {a} {{ type {kind}; neighbourPatch {b}; {more}",
        )


def centres(cells, sides):
    """Cell centres in the order of blockMesh; cells and sides: (x, y[, z])."""
    axes = [
        (np.arange(n) + 0.5)*side/n for n, side in zip(cells, sides)
    ]
    if len(axes) == 2:
        axes.append(np.zeros(1))
    z, y, x = np.meshgrid(*axes[::-1], indexing="ij")
    return np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)


def set_velocity(case, velocity):
    """Initial velocity of all cells, an array (cells, 3)."""
    path = case.path / "0/U"
    head, tail = path.read_text().split("internalField", 1)
    tail = tail.split("boundaryField", 1)[1]
    rows = "\n".join("({:.17g} {:.17g} {:.17g})".format(*u) for u in velocity)
    field = FIELD.format(n=len(velocity), rows=rows)
    path.write_text(f"{head}{field}boundaryField{tail}")


def set_stress(case):
    """Have the mean stress of the box in all time steps."""
    case.replace("system/controlDict", "functions\n{", "functions\n{" + STRESS)


def stress(case):
    """Columns of suspensionStress by their names without units."""
    return tables.run_columns(case.path, "stress", "suspensionStress")


def sliding_box(
    folder, name, cells, sides=(1, 1), shear="shearRate 1;", direct=True,
    sliding=True, shift=0,
):
    """A box with corners at 0 and `sides`, of cells = (nx, ny[, nz]) cells, at
    rest but for the shear about its middle: `shear` is the speed of the top.
    Not sliding: the same between plain cyclic patches."""
    case = BodyCase("tube", folder, name)
    boxMesh.write(
        case, *(uniform(0, side, n) for side, n in zip(sides, cells)),
        patches={
            "left": "x-", "right": "x+", "bottom": "y-", "top": "y+",
            **({"back": "z-", "front": "z+"} if len(cells) == 3 else {}),
        },
    )
    pair(case, "left", "right")
    if len(cells) == 3:
        pair(case, "back", "front")
    if sliding:
        entries = f"direction (1 0 0); {shear} shift {shift:.17g};"
        pair(case, "top", "bottom", "LeesEdwards", entries)
        case.controls(libs='("libgrainLeesEdwards.so")')
    else:
        pair(case, "top", "bottom")
    boundary = BOUNDARY.format(kind="LeesEdwards" if sliding else "cyclic")
    for field in ("U", "p"):
        path = case.path / "0" / field
        head = path.read_text().split("boundaryField", 1)[0]
        path.write_text(head + boundary)
    if direct:
        case.replace(
            "system/fvSolution", "GAMG;\n        smoother        GaussSeidel",
            "fastPoisson",
        )
    case.run("blockMesh")
    return case


def eddies(cells, shear, size=0.3):
    """Shear about the middle, and four eddies, of a box of side 1."""
    x, y, _ = 2*np.pi*centres(cells, (1,)*len(cells)).T
    u = np.zeros((len(x), 3))
    u[:, 0] = size*np.sin(x)*np.cos(y) + shear*(y/(2*np.pi) - 0.5)
    u[:, 1] = -size*np.cos(x)*np.sin(y)
    return u


def tight(case):
    """Solve to rounding."""
    path = case.path / "system/fvSolution"
    text = re.sub(r"tolerance +1e-\d+;", "tolerance 1e-14;", path.read_text())
    path.write_text(re.sub(r"relTol +[\d.e-]+;", "relTol 0;", text))


def prepare(folder, name, nu=0.05, end=0.1, dt=0.01, velocity=None, **box):
    cells = box.pop("cells", (N, N))
    case = sliding_box(folder, name, cells, **box)
    set_velocity(case, eddies(cells, 1) if velocity is None else velocity)
    tight(case)
    case.replace("constant/transportProperties", "0.5;", f"{nu:.12g};")
    case.controls(
        endTime=end, deltaT=dt, writeFormat="ascii", writePrecision=16,
        writeControl="timeStep", writeInterval=round(end/dt),
    )
    return case


def disc(x, y, speed=0, ratio=2, more=""):
    return f"""
        disc
        {{
            shape       {{ type disc; radius 0.2; }}
            densityRatio {ratio};
            position    ({x:.15g} {y:.15g} 0);
            velocity    ({speed:.15g} 0 0);
            {more}
        }}
    """
