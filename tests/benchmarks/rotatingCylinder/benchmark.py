# SPDX-License-Identifier: GPL-3.0-or-later
"""Forces on a cylinder that is held in a stream and turns, and on held spheres."""

import math

import numpy as np

import boxMesh
import stream
from bodyCase import BodyCase
from boxMesh import graded
from measure import DEPTH, Run, set_direct, set_viscosity
from peers.boxOGrid import BoxCase
from periods import mean_and_amplitude, whole_periods

# Re, alpha: C_D, C_L, amplitude of C_D, of C_L, St
REFERENCES = {
    (100, 1): (1.10, -2.49, 0.10, 0.36, 0.165),
    (100, 0): (1.34, 0, 0.009, 0.325, 0.165),
    (200, 0): (1.34, 0, None, 0.69, 0.197),
}
NAMES = "C_D", "C_L", "C_D amplitude", "C_L amplitude", "St"
COURANT, END, MEASURED = 0.2, 70, 32
HALF = 0.75     # of the square that the O-grid fills

# Re of a sphere: C_D, C_L, end
SPHERES = {100: (1.087, 0, 30), 250: (0.70, 0.062, 80)}

U, P = stream.velocity(1), stream.P
EMPTY = "frontAndBack { type empty; }\n"
PATCHES = {"inlet": "x-", "outlet": "x+", "sides": "y- y+"}
PEER_U = """
    cylinder
    {{
        type    rotatingWallVelocity;
        origin  (0 0 0);
        axis    (0 0 1);
        omega   {:.12g};
    }}
"""
PEER_P = "cylinder { type zeroGradient; }\n"
# A cross flow behind the body
START = """FoamFile
{
    version     2.0;
    format      ascii;
    class       dictionary;
    object      setExprFieldsDict;
}

expressions
(
    U
    {
        field       U;
        dimensions  [0 1 -1 0 0 0 0];
        expression
        #{
            vector(1, 0.5*exp(-sqr(pos().x() - 2) - sqr(pos().y())), 0)
        #};
    }
);
"""


def directions(h):
    """Mesh along and across the stream; the square is in both cores."""
    margin = h*round(0.5/h)
    along = -HALF - margin, HALF + h*round(2.25/h)
    across = -HALF - margin, HALF + margin
    return graded(-20, 40, along, h, 1.1), graded(-20, 20, across, h, 1.1)


def start(case, h):
    """The stream and its disturbance, and the time step."""
    (case.path / "system/setExprFieldsDict").write_text(START)
    case.run("setExprFields")
    case.controls(endTime=f"{END}", deltaT=f"{COURANT*h:.6g}")


def figures(result, Re, alpha, time, drag, lift):
    """Rows of one run from its history per unit depth and density."""
    # At even times: steps may have been repeated with half their length
    even = np.linspace(time[-1] - MEASURED, time[-1], 4000)
    drag, lift = (2*np.interp(even, time, f) for f in (drag, lift))
    whole, period = whole_periods(even, lift)
    C_D, C_D_amplitude = mean_and_amplitude(drag[whole])
    C_L, C_L_amplitude = mean_and_amplitude(lift[whole])
    values = C_D, C_L, C_D_amplitude, C_L_amplitude, period and 1/period
    for name, value, reference in zip(
        NAMES, values, REFERENCES[Re, alpha], strict=True
    ):
        if value is None:
            continue
        # Of a mean lift of zero: in % of the drag
        error = 100*value/C_D if reference == 0 else None
        yield result.row(name, value, reference, error)


def name_of(Re, alpha):
    return f"Re {Re} alpha {alpha}"


def body_fitted(folder, Re, alpha, cells):
    """Rows of pimpleFoam on a mesh fitted to the cylinder."""
    h, name = 1/cells, name_of(Re, alpha)
    case = BoxCase(
        folder, f"fitted {name} D{cells}".replace(" ", "_"),
        *directions(h), HALF, h,
    )
    case.conditions(U + EMPTY + PEER_U.format(2*alpha), P + EMPTY + PEER_P)
    case.replace("constant/transportProperties", "1e-3;", f"{1/Re:.12g};")
    start(case, h)
    result = case.solve(name)
    if result:
        yield from figures(result, Re, alpha, *case.history())


def immersed(folder, Re, alpha, cells):
    """Rows of our solver."""
    h, name = 1/cells, name_of(Re, alpha)
    case = BodyCase("tube", folder, f"{name} D{cells}".replace(" ", "_"))
    case.conditions(U + EMPTY, P + EMPTY)
    n = boxMesh.write(case, *directions(h), patches=PATCHES)
    case.run("blockMesh")
    set_viscosity(case, 1/Re)
    set_direct(case)
    case.bodies(f"""
        cylinder
        {{
            shape       {{ type disc; radius 0.5; }}
            position    (0 0 0);
            motion
            {{
                type            prescribed;
                velocity        (0 0 0);
                angularVelocity (0 0 {2*alpha});
            }}
        }}
    """)
    start(case, h)
    run = Run(case, name, cells, n, may_fail=True)
    if run.failed:
        yield run.diverged()
        return
    forces = case.table("forces")
    yield from figures(run, Re, alpha, forces["time"], *(
        forces[f"fluidForce_{c}"]/DEPTH for c in "xy"
    ))
    yield run.row("outers, mean", np.mean(run.outers))


def sphere(folder, Re, cells):
    """Rows of a held sphere, of which z > 0 is computed."""
    h = 1/cells
    C_D, C_L, end = SPHERES[Re]
    case = BodyCase("tube", folder, f"sphere_Re{Re}_D{cells}")
    case.conditions(U, P)
    core = h*round(1/h)
    n = boxMesh.write(
        case, graded(-8, 16, (-core, 2*core), h, 1.1),
        graded(-8, 8, (-core, core), h, 1.1), graded(0, 8, (0, core), h, 1.1),
        {"inlet": "x-", "outlet": "x+", "sides": "y- y+ z+", "middle": "z-"},
    )
    case.set_symmetry("middle")
    case.run("blockMesh")
    set_viscosity(case, 1/Re)
    set_direct(case)
    case.bodies("""
        sphere
        {
            shape       { type sphere; radius 0.5; }
            position    (0 0 0);
            motion      { type fixed; }
        }
    """)
    start(case, h)
    case.controls(endTime=f"{end}", deltaT=f"{0.5*h:.6g}")
    run = Run(case, f"sphere Re {Re}", cells, n, may_fail=True)
    if run.failed:
        yield run.diverged()
        return
    # Half of the sphere is in the mesh
    drag, lift = (
        2*8/math.pi*case.table("forces")[f"fluidForce_{c}"] for c in "xy"
    )
    last = slice(int(0.9*len(drag)), None)
    yield run.row("C_D", drag[-1], C_D)
    # Up or down, by the disturbance at the start
    lift_error = 100*abs(lift[-1])/C_D if C_L == 0 else None
    yield run.row("C_L", abs(lift[-1]), C_L, lift_error)
    yield run.row("last change, %", 100*np.ptp(drag[last])/C_D)
    yield run.row("last change of C_L", np.ptp(lift[last]))


def compared(ours, fitted):
    """Rows: our error over that of the fitted mesh, both against the reference."""
    errors = {row["quantity"]: row["error_percent"] for row in fitted}
    for row in ours:
        name, error = row["quantity"], row["error_percent"]
        # A mean lift of zero is met by either
        if name not in ("C_D", "C_L", "C_L amplitude") or not row["reference"]:
            continue
        if errors.get(name):
            yield {
                **row, "quantity": f"{name} / fitted", "reference": None,
                "value": abs(error/errors[name]), "error_percent": None,
            }


def rows(folder, quick):
    for Re, alpha in REFERENCES:
        if quick and Re == 200:
            continue
        for cells in (10,) if quick else (10, 16, 20):
            fitted = list(body_fitted(folder, Re, alpha, cells))
            yield from fitted
            ours = list(immersed(folder, Re, alpha, cells))
            yield from ours
            yield from compared(ours, fitted)
        if not quick:
            yield from body_fitted(folder, Re, alpha, 32)
    for Re in () if quick else SPHERES:
        yield from sphere(folder, Re, 10)
