# SPDX-License-Identifier: GPL-3.0-or-later
"""On which meshes, with which schemes and time steps, is pimpleFoam stable, and
immersedFluid with a body?"""

import itertools
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from bodyCase import BodyCase
from foamCase import FoamError
from measure import Result, set_viscosity
from meshes import H, meshes

STEPS, FASTEST = 100, 1.5
DISC = """
    disc
    {{
        shape       {{ type disc; radius 0.25; }}
        position    (0.9 0.2 0);
        {entries}
    }}
"""
BODIES = {
    "fixed": "motion { type fixed; }",
    "free": "densityRatio 2; velocity ambient;",
}
DDT = ("Euler", "backward")
LAPLACIAN = ("corrected", "limited 0.5")
STRESS = "none;\n    div((nuEff*dev2(T(grad(U))))) Gauss linear;"


def combinations(quick):
    return itertools.product(
        DDT[1:] if quick else DDT, LAPLACIAN, (0,) if quick else (0, 1),
        (0.05, 0.5),
    )


def prepare(mesh, folder, name, ddt, laplacian, n, courant):
    case = BodyCase(mesh, folder, name)
    case.replace("system/fvSchemes", "default backward", f"default {ddt}")
    case.replace("system/fvSchemes", "linear corrected", f"linear {laplacian}")
    case.replace("system/fvSchemes", "default corrected", f"default {laplacian}")
    case.replace("system/fvSchemes", "none;", STRESS)
    case.replace(
        "system/fvSolution", "PIMPLE\n{",
        f"PIMPLE\n{{\n    nCorrectors 2;\n    nNonOrthogonalCorrectors {n};",
    )
    set_viscosity(case, 0.05)
    dt = courant*H/FASTEST
    case.controls(
        deltaT=f"{dt:.10g}", endTime=f"{STEPS*dt:.10g}", writeFormat="ascii",
        writeControl="timeStep", writeInterval=STEPS,
    )
    return case


class Attempt(Result):
    """A run of a solver, stable or not."""

    def __init__(self, case, app, settings, cells, solver):
        super().__init__(settings, round(0.5/H, 1), cells, solver=solver)
        try:
            case.run(app)
            failed = False
        except FoamError:
            failed = True
        log = (case.path/f"log.{app}").read_text()
        times = re.findall(r"ExecutionTime = (\S+) s", log)
        self.cpu = float(times[-1]) if times else 0.0
        self.steps = len(times)
        self.stable = not failed and self.largest(case) < 3*FASTEST

    def largest(self, case):
        """Largest speed in the last time."""
        return max((case.field("U")**2).sum(axis=1))**0.5


def without_bodies(mesh, folder, choice, settings, cells):
    case = prepare(mesh, folder, "pimpleFoam", *choice)
    functions = case.path/"system/controlDict"
    functions.write_text(functions.read_text().split("functions")[0])
    peer = Attempt(case, "pimpleFoam", settings, cells, "pimpleFoam")
    exact = FASTEST
    row = peer.row("U", peer.largest(case), exact) if peer.stable else \
        peer.row("stable", 0)
    return peer.stable, row


def with_body(mesh, folder, choice, settings, cells, kind, stable):
    """A row, and whether it is stable where pimpleFoam is."""
    case = prepare(mesh, folder, kind, *choice)
    case.bodies(DISC.format(entries=BODIES[kind]))
    run = Attempt(case, "foamRun", f"{settings} {kind}", cells, None)
    if not run.stable:
        return False, run.diverged() if stable else run.row("stable", 0)
    if kind == "fixed":
        return True, run.row("largest U", run.largest(case))
    return True, run.row("free speed", case.table("motion")["velocity_x"][-1])


def rows(folder, quick):
    count = {"pimpleFoam": 0, "fixed": 0, "free": 0}
    total = 0
    for name, make in meshes(quick).items():
        place = folder/name.replace(" ", "_")
        mesh = BodyCase("tube", place)
        cells = make(mesh)
        for choice in combinations(quick):
            ddt, laplacian, n, courant = choice
            settings = f"{name} {ddt[:4]} {laplacian[:7]} n{n} Co{courant}"
            run = place/settings.replace(" ", "_")
            stable, row = without_bodies(mesh, run, choice, settings, cells)
            yield row
            count["pimpleFoam"] += stable
            for kind in BODIES:
                good, row = with_body(
                    mesh, run, choice, settings, cells, kind, stable
                )
                yield row
                count[kind] += good
            total += 1
    for solver, n in count.items():
        yield {**Result(f"of {total}", 0, 0, solver=solver).row("stable in all", n)}
