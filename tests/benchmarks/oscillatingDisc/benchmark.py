# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag and added mass of a disc that oscillates in a fluid at rest."""

from oscillation import (
    DUETSCH, PERIODS, coefficients, damping, harmonic_drag, morison, solve,
    stokes,
)


def rows(folder, quick):
    runs = (
        ("Stokes flow", 0.2, damping, stokes(), ("damping", "added mass")),
        ("Re 100 KC 5", 5, morison, DUETSCH, ("C_D", "added mass")),
    )
    for name, KC, drag, references, quantities in runs:
        for cells in (8, 16) if quick else (8, 16, 32):
            case, run = solve(folder, KC, cells, name, drag is damping)
            if run.failed:
                yield run.diverged()
                continue
            values, rest = coefficients(case, KC, drag, PERIODS)
            before, _ = coefficients(case, KC, drag, PERIODS - 1)
            change = 100*abs(values/before - 1).max()
            if drag is morison:
                fitted, values[0] = values[0], harmonic_drag(case, KC)
            for quantity, value, reference in zip(
                quantities, values, references, strict=True
            ):
                yield run.row(quantity, value, reference)
            if drag is morison:
                yield run.row("C_D, least squares", fitted)
            yield run.row("off the fit, % rms", 100*rest)
            yield run.row("last change, %", change)
