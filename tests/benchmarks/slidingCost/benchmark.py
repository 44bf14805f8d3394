# SPDX-License-Identifier: GPL-3.0-or-later
"""Time of a step in a box that slides, over that between cyclic patches."""

import re

from measure import Run, set_viscosity
from slidingBox import centres, eddies, set_velocity, sliding_box

# Cells, bodies per direction and their radius over the side
BOXES = {
    "2D, 1 body": ((256, 256), 1, 0.05),
    "2D, 36 bodies": ((256, 256), 6, 0.04),
    "3D, 1 body": ((48, 48, 48), 1, 0.05),
    "3D, 27 bodies": ((48, 48, 48), 3, 0.04),
}
QUICK = ("2D, 1 body",)
NU, STEP = 0.05, 0.005
# Steps of a run, those timed, before the last, which writes; runs of each box
STEPS, TIMED, REPEATS = 30, 20, 3
# By kind of run: convergence of the outer iterations, of the velocity
KINDS = {
    "as it runs": ("", "tolerance 1e-9; relTol 1e-3;"),
    "same work": (
        "coupling { tolerance 1e-14; nOuterCorrectors 5; }",
        "tolerance 0; relTol 0; minIter 5; maxIter 5;",
    ),
}


def bodies(number, radius, dims):
    """Entry of bodies on a lattice, a little off the mesh."""
    places = centres((number,)*dims, (1,)*dims)
    if dims == 3 or number > 1:
        places = places + 0.001
    else:
        # Not in the middle of an eddy, where it would be at rest
        places = places + [-0.199, 0.101, 0]
    positions = " ".join("({:.12g} {:.12g} {:.12g})".format(*x) for x in places)
    shape = "disc" if dims == 2 else "sphere"
    return f"""
        body
        {{
            shape       {{ type {shape}; radius {radius}; }}
            densityRatio 2;
            positions   ({positions});
            velocity    (0.1 0 0);
            angularVelocity (0 0 0);
        }}
    """


def make(folder, name, box, kind, sliding):
    """The case, ready to run."""
    cells, number, radius = box
    coupling, accuracy = KINDS[kind]
    case = sliding_box(
        folder, name, cells, (1,)*len(cells), sliding=sliding
    )
    set_viscosity(case, NU)
    case.replace(
        "system/fvSolution",
        "PBiCGStab;\n        preconditioner  DILU;"
        "\n        tolerance       1e-9;\n        relTol          1e-3;",
        f"smoothSolver;\n        smoother        symGaussSeidel; {accuracy}",
    )
    set_velocity(case, eddies(cells, 1 if sliding else 0))
    case.bodies(
        bodies(number, radius, len(cells)),
        f"{coupling}\ncontact {{ type inelastic; }}",
    )
    end = STEPS*STEP
    case.controls(
        endTime=f"{end:g}", deltaT=f"{STEP:g}", writeInterval=f"{end:g}"
    )
    return case


class Timed:
    """A run: time [ms], outer iterations and sweeps per step."""

    def __init__(self, case, settings, D_over_h, cells):
        self.run = Run(case, settings, D_over_h, cells)
        log = (case.path/"log.foamRun").read_text()
        steps = [
            float(time) for time in re.findall(r"ExecutionTime = (\S+) s", log)
        ]
        self.time = 1000*(steps[-2] - steps[-2 - TIMED])/TIMED
        self.outers = sum(self.run.outers[-1 - TIMED:-1])/TIMED
        late = "".join(log.split("\nTime = ")[-1 - TIMED:-1])
        sweeps = re.findall(r"for Ux.*No Iterations (\d+)", late)
        self.sweeps = sum(map(int, sweeps))/TIMED


def fastest(folder, name, box, kind):
    """Of the plain box and of that which slides, by sliding."""
    cells, _, radius = box
    n = 1
    for count in cells:
        n *= count
    best = {}
    for repeat in range(REPEATS):
        for sliding in (False, True):
            which = "sliding" if sliding else "plain"
            case = make(
                folder, f"{name} {kind} {which} {repeat}".replace(" ", "_"),
                box, kind, sliding,
            )
            run = Timed(
                case, f"{name}, {which}, {kind}",
                round(2*radius*cells[0], 2) or None, n,
            )
            if sliding not in best or run.time < best[sliding].time:
                best[sliding] = run
    return best


def rows(folder, quick):
    for name in QUICK if quick else BOXES:
        for kind in KINDS:
            best = fastest(folder, name, BOXES[name], kind)
            for timed in best.values():
                yield timed.run.row("ms per step", timed.time)
                yield timed.run.row("outer iterations", timed.outers)
                yield timed.run.row("sweeps", timed.sweeps)
            yield best[True].run.row(
                "over plain", best[True].time/best[False].time
            )
