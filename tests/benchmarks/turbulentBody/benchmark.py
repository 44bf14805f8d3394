# SPDX-License-Identifier: GPL-3.0-or-later
"""Turbulence models at immersed walls: channel and cylinder."""

import dfgChannel
import turbulence
import turbulentChannel
from dfgChannel import DIAMETER
from measure import DEPTH, Result, Run
from peers.bodyFitted import FittedCase

RE_TAU = 395
# Velocity in the middle over friction velocity: 200 cells, the first at y+ 0.1
CHANNEL = {"kOmegaSST": 19.55, "SpalartAllmaras": 19.97}
# On the mesh of 100 cells with the first at y+ 0.2, which that is to check
FINE = {"grading": 35, "dt": 0.005, "steps": 8000}
# pimpleFoam, fitted, 24 cells on a quarter: mean drag, rms of the lift
DRAG, LIFT = 3.518, 2.366
END = 6
NONE = "turbulentWalls { type none; }"
WALE = """simulationType LES;
LES { LESModel WALE; turbulence on; printCoeffs off; delta cubeRootVol;
      cubeRootVolCoeffs { deltaCoeff 1; } }
"""


def channel(folder, cells, offset=None, walls="wall functions", before="",
            model="kOmegaSST", reference=None, **settings):
    """Velocity in the middle of a channel; offset: of an immersed wall."""
    text = walls if offset is None else f"immersed, offset {offset}"
    if before:
        text += ", not seen"
    if "grading" in settings:
        text += ", graded"
    name = f"{model}_{text.replace(' ', '_').replace(',', '')}_{cells}"
    _, U, _, log = turbulentChannel.solve(
        name, folder, RE_TAU, cells, offset, walls, before, model=model,
        **settings
    )
    result = Result(
        f"channel, {model}, y+ {RE_TAU/cells:.0f} per cell, {text}",
        cells, U.size, log.count("\nTime = "), cpu(log),
        solver=None if offset is not None else "immersedFluid, fitted",
    )
    return result.row("U_c+", U[-1], reference or CHANNEL[model])


def other_models(folder, quick):
    """Rows for models with other variables than k and omega."""
    for cells in (20,) if quick else (40, 20, 11):
        # Has no layer below wall functions: beside the same mesh with a wall
        _, U, _, _ = turbulentChannel.solve(
            f"wall_{cells}", folder, RE_TAU, cells, model="kEpsilon"
        )
        for offset in (0.2, 0.7):
            yield channel(
                folder, cells, offset, model="kEpsilon", reference=U[-1]
            )
            yield channel(folder, cells, offset, model="SpalartAllmaras")
        yield channel(
            folder, cells, walls="wall functions of U", model="SpalartAllmaras"
        )


def cpu(log):
    return float(log.rsplit("ExecutionTime = ", 1)[1].split()[0])


def street(result, t, drag, lift):
    """Rows of mean drag and of lift, in the last third of a run."""
    part = t > 2*t[-1]/3
    known = "kOmegaSST" in result.settings
    yield result.row(
        "C_D, mean", 2*drag[part].mean()/DIAMETER, DRAG if known else None
    )
    yield result.row(
        "C_L, rms", 2*lift[part].std()/DIAMETER, LIFT if known else None
    )


def fitted(folder, n):
    case = FittedCase(folder, f"fitted{n}", n)
    turbulence.set_model(case, "cylinder")
    case.transient(1, 0.002, END)
    result = case.solve("pimpleFoam", "cylinder, kOmegaSST")
    if result:
        t, drag, lift, _ = case.history()
        yield from street(result, t, drag, lift)


def cylinder(folder, settings, cells, before=""):
    """Rows of our solver; settings: the model, and how it sees the body."""
    name = f"{settings.replace(',', '').replace(' ', '_')}_D{cells}"
    case, n = dfgChannel.make(folder, name, cells, 1)
    turbulence.set_model(case)
    if settings.startswith("WALE"):
        case.replace(
            "constant/turbulenceProperties", turbulence.MODEL, WALE
        )
    elif settings.startswith("laminar"):
        case.replace(
            "constant/turbulenceProperties", turbulence.MODEL,
            "simulationType laminar;\n",
        )
    case.replace(
        "system/fvSchemes", "    default             none;\n",
        "    default             none;\n"
        "    div((nuEff*dev2(T(grad(U))))) Gauss linear;\n",
    )
    case.bodies("""
        cylinder
        {
            shape       { type disc; radius 0.05; }
            position    (0.2 0.2 0);
            motion      { type fixed; }
        }
    """, before)
    case.controls(endTime=END, deltaT=f"{0.06/cells:.6g}")
    run = Run(case, f"cylinder, {settings}", cells, n, may_fail=True)
    if run.failed:
        yield run.diverged()
        return
    forces = case.table("forces")
    yield from street(
        run, forces["time"], forces["fluidForce_x"]/DEPTH,
        forces["fluidForce_y"]/DEPTH,
    )


def rows(folder, quick):
    for cells in (40, 20, 11):
        if not quick:
            yield channel(folder, cells)
        for offset in (0.2, 0.7):
            yield channel(folder, cells, offset)
    yield channel(folder, 20, 0.2, before=NONE)
    yield from other_models(folder, quick)
    if not quick:
        for model in CHANNEL:
            yield channel(folder, 100, walls="low Re", model=model, **FINE)
        yield channel(folder, 79, walls="low Re")
        yield channel(folder, 79, 0.2)
        yield channel(folder, 79, 0.7)
        for n in (16, 24):
            yield from fitted(folder, n)
    for cells in (10,) if quick else (10, 20):
        yield from cylinder(folder, "kOmegaSST", cells)
    if not quick:
        yield from cylinder(folder, "kOmegaSST, not seen", 10, NONE)
        yield from cylinder(folder, "WALE", 10)
        yield from cylinder(folder, "WALE, not seen", 10, NONE)
        yield from cylinder(folder, "laminar", 10)
