# SPDX-License-Identifier: GPL-3.0-or-later
"""Peers in OpenFOAM: its own solvers on a mesh fitted to the cylinder."""

import math
import re
from pathlib import Path

from bodyCase import BodyCase
from foamCase import FoamCase
from measure import DEPTH, Result
from peers import oGrid
from peers.installed import installed

CASE = Path(__file__).parent / "cylinder"


class FittedCase(FoamCase):
    """The DFG cylinder with n cells on a quarter of its circumference."""

    replace = BodyCase.replace
    controls = BodyCase.controls

    def __init__(self, folder, name, n):
        super().__init__(CASE, folder, name)
        self.D_over_h = round(4*n/math.pi, 1)
        self.cells = oGrid.write(self, n)
        self.run("blockMesh")

    def transient(self, mean_speed, dt, end):
        """From steady at mean speed 0.2 to a run in time."""
        self.replace("0/U", "1.2*pos", f"{6*mean_speed:.12g}*pos")
        self.replace("system/fvSchemes", "steadyState", "backward")
        self.controls(deltaT=f"{dt:.8g}", endTime=f"{end:.8g}")

    def solve(self, solver, settings):
        """The result of running a solver; nothing if it is not installed."""
        if not installed(solver, solver):
            return None
        log = self.run(solver)
        times = re.findall(r"ExecutionTime = (\S+) s", log)
        return Result(
            settings, self.D_over_h, self.cells, steps=len(times),
            cpu=float(times[-1]), solver=solver,
        )

    def history(self):
        """t, drag and lift per unit depth, pressure difference."""
        forces = self.read_dat("postProcessing/forces/0/force.dat")
        p = self.read_dat("postProcessing/pressure/0/p")
        return (
            forces[:, 0], forces[:, 1]/DEPTH, forces[:, 2]/DEPTH,
            p[:, 1] - p[:, 2],
        )
