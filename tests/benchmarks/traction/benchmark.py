# SPDX-License-Identifier: GPL-3.0-or-later
"""Speed of a free disc and flow rate in a tube driven by traction."""

from endCase import EndCase
from measure import Run, around

RADIUS = 0.065
FORCE = 0.5

# Kind of end, height: V_x, Q
REFERENCES = {
    ("traction", 0): (0.04303785, 0.05750549),
    ("traction", -0.3): (0.03911625, 0.05746895),
    ("pressure", 0): (0.04157850, 0.05555517),
}
TANGENTIAL = {"traction": "free", "pressure": "zero"}

# Kind of end, height, D/h, size of the cells in the corners
QUICK = (
    ("traction", 0, 8, 0.04), ("traction", 0, 8, 0.02),
    ("traction", -0.3, 8, 0.02), ("pressure", 0, 8, 0.02),
)
FULL = (
    *QUICK, ("traction", 0, 8, 0.01), ("traction", 0, 8, 0.005),
    ("traction", 0, 16, 0.01), ("traction", -0.3, 16, 0.01),
    ("pressure", 0, 16, 0.01),
)


def solve(folder, ends, y, cells, corner):
    """The case after its run, and the run."""
    h = 2*RADIUS/cells
    case = EndCase(
        folder, f"{ends}_y{y}_D{cells}_c{corner}", h,
        (around(0, 4*RADIUS, h), around(y, 4*RADIUS, h)), corner, FORCE,
        tangential=TANGENTIAL[ends],
    )
    case.bodies(f"""
        disc
        {{
            shape       {{ type disc; radius {RADIUS}; }}
            densityRatio 2;
            position    (0 {y} 0);
            velocity    ambient;
            constraints {{ translate (1 0 0); }}
        }}
    """, "window { type comoving; direction (1 0 0); }")
    case.controls(endTime="6", deltaT=f"{0.16/cells}", writeInterval="6")
    run = Run(
        case, f"{ends} y {y} corner {corner}", cells, case.cells,
        may_fail=True,
    )
    return case, run


def rows(folder, quick):
    for ends, y, cells, corner in QUICK if quick else FULL:
        case, run = solve(folder, ends, y, cells, corner)
        if run.failed:
            yield run.diverged()
            continue
        speed, rate = REFERENCES[ends, y]
        table = case.table("motion")["velocity_x"]
        yield run.row("V_x/F", table[-1]/FORCE, speed/FORCE)
        yield run.row("Q/F", case.flow_rate(table[-1])/FORCE, rate/FORCE)
        early = table[int(0.9*len(table))]
        yield run.row("last change, %", 100*abs(table[-1]/early - 1))
