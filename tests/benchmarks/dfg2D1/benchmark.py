# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag, lift and pressure difference of a cylinder in a channel, steady."""

import dfgChannel
from dfgChannel import DIAMETER
from measure import DEPTH, Run
from peers import freefem
from peers.bodyFitted import FittedCase

C_D, C_L, DP = 5.57953523384, 0.010618948146, 0.11752016697
SPEED = 0.2


def figures(result, drag, lift, dp):
    """Rows of one run from its forces per unit depth and density."""
    scale = 2/(SPEED**2*DIAMETER)
    yield result.row("C_D", scale*drag, C_D)
    yield result.row("C_L", scale*lift, C_L)
    yield result.row("dp", dp, DP)


def finite_elements(quick):
    """Rows of body-fitted and of penalised finite elements."""
    for solver, fitted, edges in (
        (freefem.FITTED, 1, (20, 40, 80) if quick else (20, 40, 80, 160)),
        (freefem.PENALISED, 0, (10, 20) if quick else (10, 20, 40)),
    ):
        for result, numbers in freefem.results(
            solver, "heldCylinder.edp", (fitted,), "steady", edges
        ):
            yield from figures(result, *(
                numbers[name] for name in ("drag", "lift", "dp")
            ))


def body_fitted(folder, quick):
    """Rows of simpleFoam on a mesh fitted to the cylinder."""
    for n in (12, 24, 48) if quick else (12, 24, 48, 64):
        case = FittedCase(folder, f"fitted{n}", n)
        result = case.solve("simpleFoam", "steady")
        if result:
            yield from figures(result, *(x[-1] for x in case.history()[1:]))


def rows(folder, quick):
    yield from finite_elements(quick)
    yield from body_fitted(folder, quick)
    for cells in (10, 20) if quick else (10, 20, 40):
        case, n = dfgChannel.make(folder, f"D{cells}", cells)
        dt = 2*DIAMETER/cells
        case.controls(endTime="8", deltaT=f"{dt:.6g}")
        run = Run(case, "steady", cells, n)

        forces = case.table("forces")
        p = case.read_dat("postProcessing/pressure/0/p")[-1]
        yield from figures(
            run, forces["fluidForce_x"][-1]/DEPTH,
            forces["fluidForce_y"][-1]/DEPTH, p[1] - p[2],
        )
