# SPDX-License-Identifier: GPL-3.0-or-later
"""Added mass and drag of an array of spheres in an oscillating flow, fitted."""

from measure import Run
from oscillatingArray import Array, fitted

FRACTION = 0.2
# Thickness of the viscous layer over the diameter
LAYERS = (0.025, 0.05, 0.1, 0.2)
# Steps per period: a fluid that is driven past spheres needs more
STEPS = {"spheres": 80, "fluid": 320}


def figures(folder, moves, cells, layer, steps):
    """Rows of one run, and C_a in the first of them."""
    array = Array(FRACTION, cells, layer)
    case = array.case(folder, moves, steps)
    run = Run(
        case, f"{moves} move, layer {layer:g} D, {steps} steps",
        array.D_over_h, array.n**3,
    )
    row = fitted(case)
    _, drag, mass = array.potential()
    return [
        run.row("C_a", row["addedMass"]),
        run.row("C_a, thin layer", mass),
        run.row("C_a over that", row["addedMass"], mass),
        run.row("drag over that of a thin layer", row["drag"]/drag),
        run.row("standard error of C_a, %",
                100*row["errorOf_addedMass"]/row["addedMass"]),
        run.row("unexplained, %", 100*row["unexplained"]),
    ], run


def rows(folder, quick):
    potential, *_ = Array(FRACTION, 8, 1).potential()
    for cells in (8, 16) if quick else (8, 16, 32):
        found = {}
        for layer in LAYERS:
            made, run = figures(
                folder, "spheres", cells, layer, STEPS["spheres"])
            found[layer] = made[0]["value"]
            yield from made
        for thin, thick in zip(LAYERS, LAYERS[1:]):
            run.settings = f"spheres move, from layers {thin:g} and {thick:g} D"
            yield run.row(
                "C_a without viscosity", 2*found[thin] - found[thick],
                potential,
            )

    for cells in (8,) if quick else (8, 16):
        for steps in (80, 160, STEPS["fluid"]):
            yield from figures(folder, "fluid", cells, 0.1, steps)[0]
