# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocity, spin and lift of a free disc in a tube, in a comoving window."""

import itertools

from bodyCase import BodyCase
from boxMesh import graded
from measure import DEPTH, Run, around, set_viscosity
from peers import freefem

RADIUS = 0.065

# Half width of the part with cells of one size; a shorter one, or cells that grow
# faster beyond, make the lift several per cent larger
CORE = 6.4*RADIUS

# Re: height, V_x, spin, lift over density, end time
REFERENCES = {
    2: (-0.3, 1.36128741, -0.44864746, -1.019145e-3, 4),
    10: (-0.3, 1.36093794, -0.44782215, -9.298236e-4, 8),
    40: (-0.43042, 1.215293, -0.628914, 0, 12),
}
OFFSETS = ((0, 0), (0.3, 0.4))
RATIOS = (0.5, 2, 1000)


def solve(folder, Re, cells, offset, ratio, settings):
    """The case after its run, and the run."""
    y, *_, end = REFERENCES[Re]
    if ratio > 100:
        end = 30    # its velocity relaxes in 4 s
    h = 2*RADIUS/cells
    name = settings.replace(" ", "_").replace("(", "").replace(")", "")
    case = BodyCase("tube", folder, f"{name}_D{cells}")
    n = case.mesh(
        graded(-3, 3, around(0, CORE, h, offset[0]), h, 1.04),
        graded(-1, 1, around(y, CORE, h, offset[1]), h, 1.04),
    )
    set_viscosity(case, 1/Re)
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius {RADIUS}; }}
            densityRatio {ratio};
            position    (0 {y} 0);
            velocity    ambient;
            constraints {{ translate (1 0 0); }}
        }}
    """, "window { type comoving; direction (1 0 0); }")
    case.controls(endTime=f"{end}", deltaT=f"{0.16/cells}")
    return case, Run(case, settings, cells, n, may_fail=True)


def peers(quick):
    """Rows of other methods: body-fitted and penalised finite elements."""
    for Re in (2, 40):
        y, speed, spin, lift, _ = REFERENCES[Re]
        cases = [
            (freefem.FITTED, "freeDisc.edp",
             (20, 40) if quick else (20, 40, 80)),
        ]
        if Re == 2:
            cases += [(freefem.PENALISED, "freeDiscPenalised.edp",
                       (8, 16) if quick else (8, 16, 32))]
        for solver, script, edges in cases:
            for result, numbers in freefem.results(
                solver, script, (Re, y), f"Re {Re}", edges
            ):
                yield result.row("V_x", numbers["V_x"], speed)
                yield result.row("spin", numbers["spin"], spin)
                yield result.row("lift", numbers["lift"], lift)


def meshes(Re, quick):
    """D/h and offset; the fine ones are not symmetric about the disc."""
    yield from itertools.product((8,), OFFSETS)
    if Re == 2:
        yield 16, OFFSETS[1]
    if not quick:
        if Re == 2:
            yield 16, OFFSETS[0]
            yield 32, OFFSETS[1]
        if Re == 40:
            yield 16, OFFSETS[1]


def rows(folder, quick):
    yield from peers(quick)
    for Re, (_, speed, spin, lift, _) in REFERENCES.items():
        for cells, offset in meshes(Re, quick):
            settings = f"Re {Re} offset {offset[0]} {offset[1]}"
            case, run = solve(folder, Re, cells, offset, 2, settings)
            if run.failed:
                yield run.diverged()
                continue
            motion = case.table("motion")
            yield run.row("V_x", motion["velocity_x"][-1], speed)
            yield run.row("spin", motion["angularVelocity_z"][-1], spin)
            force = case.table("forces")["fluidForce_y"][-1]/DEPTH
            yield run.row("lift", force, lift)

    for ratio in RATIOS[:1] if quick else RATIOS:
        case, run = solve(
            folder, 2, 8, OFFSETS[0], ratio, f"Re 2 density ratio {ratio}"
        )
        if run.failed:
            yield run.diverged()
            continue
        speed = case.table("motion")["velocity_x"][-1]
        yield run.row("V_x", speed, REFERENCES[2][1])
