# SPDX-License-Identifier: GPL-3.0-or-later
"""Force and torque on a square in a channel, along and across the mesh."""

from bodyCase import BodyCase
from boxMesh import graded
from dfgChannel import DIAMETER, HEIGHT, LENGTH
from measure import DEPTH, Run, around
from peers import freefem
from peers.installed import installed

SPEED, X, Y = 0.2, 0.2, 0.2

# Re, angle: force along and across, torque, per unit depth and density
REFERENCES = {
    (1, 0): (0.167217026, 0.00352306198, -9.41003806e-05),
    (1, 22.5): (0.169052362, 0.00307739211, -1.264986927e-04),
    (20, 0): (0.0138809243, 0.000172341, -1.3154177e-06),
    (20, 22.5): (0.0156682190, -0.00135629611, -3.78394315e-05),
}
# In cells: edges anywhere, on faces, through centres of cells
OFFSETS = ((0.3, 0.4), (0, 0), (0.5, 0.5))


def viscosity(Re):
    return SPEED*DIAMETER/Re


def figures(result, Re, angle, loads):
    """Rows of one run. Coefficients of the mean speed and the side."""
    scale = 2/(SPEED**2*DIAMETER)
    scales = {"C_D": scale, "C_L": scale, "C_M": scale/DIAMETER}
    for (name, factor), load, reference in zip(
        scales.items(), loads, REFERENCES[Re, angle], strict=True
    ):
        yield result.row(name, factor*load, factor*reference)


def square(folder, Re, angle, cells, offset, model="exponential"):
    """The run, and its loads per unit depth and density."""
    h = DIAMETER/cells
    settings = f"Re {Re}, {angle} deg, at {offset[0]} {offset[1]}"
    if model != "exponential":
        settings = f"{model}, {angle} deg"
    case = BodyCase(
        "cylinder", folder, f"{model}_Re{Re}_{angle}_{offset}_D{cells}"
        .replace(" ", "").replace("(", "").replace(")", "")
    )
    case.replace(
        "constant/transportProperties", "1e-3;", f"{viscosity(Re):.12g};"
    )
    n = case.mesh(
        graded(0, LENGTH, around(X + DIAMETER, 2*DIAMETER, h, offset[0]), h,
               1.05),
        graded(0, HEIGHT, around(Y, DIAMETER, h, offset[1]), h, 1.05),
    )
    case.bodies(f"""
        square
        {{
            shape {{ type box; size ({DIAMETER} {DIAMETER} 1); }}
            position    ({X} {Y} 0);
            orientation {{ type axisAngle; axis (0 0 1); angle {angle}; }}
            motion      {{ type fixed; }}
        }}
    """, f"steady {{}}\nresistance {{ type {model}; }}")
    case.controls(endTime="200", deltaT="0.04")
    run = Run(case, settings, cells, n, may_fail=True)
    if run.failed:
        return run, None
    forces = case.table("forces")
    names = "fluidForce_x", "fluidForce_y", "fluidTorque_z"
    return run, [forces[name][-1]/DEPTH for name in names]


def squares(quick):
    """Arguments of the runs: Re, angle, D/h, offset, model."""
    for Re, angle in REFERENCES:
        for cells in (8, 16) if quick else (8, 16, 32):
            yield Re, angle, cells, OFFSETS[0]
    for offset in OFFSETS[1:]:
        for cells in (8,) if quick else (8, 16):
            yield 20, 0, cells, offset
    for angle in (0, 22.5):
        for cells in (8, 16) if quick else (8, 16, 32):
            yield 20, angle, cells, OFFSETS[0], "distanceWeighted"


def finite_elements():
    """Rows of coarse finite elements by the method of the reference."""
    if not installed("FreeFem++", freefem.FITTED):
        return
    for Re, angle in REFERENCES:
        numbers = freefem.solve("heldSquare.edp", angle, viscosity(Re), 4)
        result = freefem.Result(
            f"Re {Re}, {angle} deg", None, int(numbers["cells"]),
            cpu=numbers["cpu"], solver=freefem.FITTED,
        )
        yield from figures(
            result, Re, angle,
            [numbers[name] for name in ("drag", "lift", "torque")],
        )


def rows(folder, quick):
    for arguments in squares(quick):
        run, loads = square(folder, *arguments)
        if run.failed:
            yield run.diverged()
        else:
            yield from figures(run, *arguments[:2], loads)
    if not quick:
        yield from finite_elements()
