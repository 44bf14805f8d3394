# SPDX-License-Identifier: GPL-3.0-or-later
"""What the benchmarks share: runs of the solver and rows of results."""

import re

import numpy as np

from foamCase import FoamError

LOCKED = "constraints { translate (0 0 0); rotate (0 0 0); }"
DEPTH = 0.1


def around(centre, half_width, h, offset=0.0):
    """Core of cells of size h about the centre, shifted by offset cells."""
    n = round(half_width/h)
    return centre - (n + offset)*h, centre + (n - offset)*h


def set_profile(case, old, new):
    """Change the profile of the undisturbed flow of a case of kind tube."""
    for file in ("0.orig/U", "0/U", "system/setExprFieldsDict"):
        case.replace(file, old, new)


def set_stokes(case):
    """Leave convection out."""
    case.replace(
        "system/fvSchemes", "div(phi,U)          Gauss linear",
        "div(phi,U)          none",
    )


def set_direct(case):
    """The direct solver for the pressure: the mesh is a box."""
    case.replace(
        "system/fvSolution", "GAMG;\n        smoother        GaussSeidel",
        "fastPoisson",
    )


def set_smoother(case):
    """Smoothing in place of a solver for the velocity: all components at
    once."""
    case.replace(
        "system/fvSolution", "PBiCGStab;\n        preconditioner  DILU",
        "smoothSolver;\n        smoother        symGaussSeidel",
    )


def set_over_relaxed(case):
    """After set_smoother(): fewer sweeps where the flow is viscous."""
    case.replace(
        "system/fvSolution", "symGaussSeidel;",
        "symGaussSeidel;\n        overRelaxation  yes;",
    )


def set_orthogonal(case):
    """No corrections for cells that are not orthogonal."""
    schemes = case.path/"system/fvSchemes"
    schemes.write_text(
        schemes.read_text().replace("corrected", "orthogonal")
    )


def set_box(case):
    """All that is fast where cells are orthogonal in a box."""
    set_direct(case)
    set_smoother(case)
    set_orthogonal(case)


def set_viscosity(case, nu):
    """nu of a case whose file says 0.5."""
    case.replace("constant/transportProperties", "0.5;", f"{nu:.12g};")


def number_of_cells(case):
    """From the owner file of the mesh, as blockMesh writes it."""
    with open(case.path / "constant/polyMesh/owner", "rb") as file:
        note = file.read(1000).split(b"nCells:")[1]
    return int(note.split()[0].strip(b'";'))


def driving_force(case):
    """Acceleration of flowRateForce [m/s2] at the end of each time step."""
    log = (case.path / "log.foamRun").read_text()
    steps = log.split("\nTime = ")[1:]
    found = [re.findall(r"acceleration (\S+) m/s2", step) for step in steps]
    return np.array([values[-1] for values in found if values], dtype=float)


class Result:
    """What came out of one run, by whatever solver, in rows."""

    def __init__(
        self, settings, D_over_h, cells, steps=0, cpu=0.0, solver=None
    ):
        self.settings = settings
        self.D_over_h = D_over_h
        self.cells = cells
        self.steps = steps
        self.cpu = cpu
        self.solver = {"solver": solver} if solver else {}

    def row(self, quantity, value, reference=None, error=None):
        """A row; error [%] where it is not that relative to reference."""
        if error is None and reference:
            error = 100*(value/reference - 1)
        return {
            **self.solver,
            "settings": self.settings,
            "D_over_h": self.D_over_h,
            "cells": self.cells,
            "steps": self.steps,
            "cpu_s": self.cpu,
            "quantity": quantity,
            "value": value if value is None else float(value),
            "reference": reference,
            "error_percent": error if error is None else float(error),
        }

    def diverged(self):
        """A row instead of figures: the step at which the run failed."""
        return self.row("diverged at step", self.steps + 1)


class Run(Result):
    """A run of the solver: its log in numbers. A run that may fail is asked
    for `failed` afterwards."""

    def __init__(self, case, settings, D_over_h, cells, may_fail=False):
        super().__init__(settings, D_over_h, cells)
        self.failed = False
        try:
            case.solve()
        except FoamError:
            if not may_fail:
                raise
            self.failed = True
        self.read_log(case.path)

    def read_log(self, folder):
        """Run time, time steps and outer iterations."""
        log = (folder / "log.foamRun").read_text()
        times = re.findall(r"ExecutionTime = (\S+) s", log)
        progress = re.findall(r"outer iterations (\d+)( \(not conv)?", log)
        self.cpu = float(times[-1]) if times else 0.0
        self.outers = [int(number) for number, _ in progress]
        self.steps = len(self.outers)
        self.converged = sum(not failed for _, failed in progress)


class StateRun(Run):
    """The run of a state of a study, in its folder; status: of its table."""

    def __init__(self, folder, status, settings, D_over_h):
        self.path = folder
        Result.__init__(self, settings, D_over_h, number_of_cells(self))
        self.failed = status != "finished"
        self.read_log(folder)
