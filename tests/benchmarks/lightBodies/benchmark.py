# SPDX-License-Identifier: GPL-3.0-or-later
"""Does the coupling converge for every density ratio, and at what cost?"""

from bodyCase import BodyCase
from boxMesh import uniform
from measure import Run, set_profile, set_viscosity

RATIOS = (0.01, 0.1, 0.5, 1, 2, 1000, 10000)
RADIUS, CELLS, COURANT, STEPS = 0.25, 8, 0.5, 20


def solve(folder, dimensions, ratio):
    """A body released with speed 1 in fluid at rest."""
    h = 2*RADIUS/CELLS
    name = f"{dimensions}D_{ratio}"
    if dimensions == 2:
        case = BodyCase("tube", folder, name)
        set_profile(case, "1.5*(1 - sqr(pos().y()))", "0")
        cells = case.mesh(uniform(-1, 1, 32), uniform(-1, 1, 32))
        set_viscosity(case, 0.1)
        shape = "disc"
    else:
        case = BodyCase("box", folder, name)
        cells = case.mesh(
            uniform(-1, 1, 32), *2*[uniform(-0.75, 0.75, 24)]
        )
        (case.path / "constant/g").unlink()
        shape = "sphere"
    case.bodies(f"""
        body
        {{
            shape       {{ type {shape}; radius {RADIUS}; }}
            densityRatio {ratio};
            position    (-0.6 -0.18 0);
            velocity    (1 0.3 0);
            angularVelocity (0 0 1);
        }}
    """)
    dt = COURANT*h/1.04
    case.controls(endTime=f"{STEPS*dt:.8g}", deltaT=f"{dt:.8g}")
    return Run(
        case, f"{dimensions}D density ratio {ratio}", CELLS, cells,
        may_fail=True,
    )


def rows(folder, quick):
    for dimensions in (2, 3):
        for ratio in RATIOS:
            run = solve(folder, dimensions, ratio)
            yield run.row("converged steps", run.converged, STEPS)
            iterations = sum(run.outers)/max(len(run.outers), 1)
            yield run.row("outer iterations", iterations)
            if run.failed:
                yield run.diverged()
