# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction factor of turbulent flow in a round tube."""

import re

from benchCase import BenchCase, periodicFriction
from friction import blasius, colebrook
from measure import Result

NU, DIAMETER = 1.81e-5/1.2, 0.035
# By resolution
CELLS_ACROSS = {1: 8, 2: 14, 3: 20}
LES_CELLS_ACROSS = 16
ROUGHNESS = 0.02


def solve(case, settings, cells_across, part=0.0):
    """Run a periodic tube: its result, Re and friction factor."""
    log = case.run("foamRun")
    times = re.findall(r"ExecutionTime = (\S+) s", log)
    result = Result(settings, cells_across, case.cells, len(times),
                    float(times[-1]))
    Re, f, _ = periodicFriction(case.path, part)
    return result, Re, f


def velocity(Re):
    return f"air.tubeVelocity={Re*NU/DIAMETER:.10g}"


def rans(folder, quick):
    """Smooth and rough tubes with wall functions."""
    for Re, roughness in ((1e4, 0), (2e4, 0), (2e4, ROUGHNESS)):
        for resolution in (1, 2) if quick else (1, 2, 3):
            name = f"Re{Re:.0f}_Ks{roughness}_{resolution}"
            case = BenchCase("periodicTube", folder, [
                velocity(Re), f"mesh.resolution={resolution}",
                f"walls.roughness={roughness*DIAMETER:.10g}",
            ], name)
            wall = f"Ks/D {roughness}" if roughness else "smooth"
            result, Re_run, f = solve(
                case, f"kOmegaSST, Re {Re:.0e}, {wall}",
                CELLS_ACROSS[resolution])
            if not roughness:
                yield result.row("f, Blasius", f, blasius(Re_run))
            yield result.row("f, Colebrook", f, colebrook(Re_run, roughness))


def les(folder):
    """The mean of the second half of a run from waves."""
    case = BenchCase("periodicTubeLES", folder)
    case.run("setExprFields")
    result, Re, f = solve(case, "WALE, Re 1e+04, smooth", LES_CELLS_ACROSS, part=0.5)
    yield result.row("f, Blasius", f, blasius(Re))


def rows(folder, quick):
    yield from rans(folder, quick)
    if not quick:
        yield from les(folder)
