# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of a benchmark as a table on screen, a .csv and a plot."""

import csv
import importlib.util

from plot import plot

COLUMNS = (
    "case", "solver", "settings", "D_over_h", "cells", "steps", "cpu_s",
    "quantity", "value", "reference", "error_percent",
)
WIDTHS = {
    "solver": 20,
    "settings": 34, "D_over_h": 8, "cells": 8, "steps": 6, "cpu_s": 8,
    "quantity": 18, "value": 14, "reference": 14, "error_percent": 14,
}


def text(value):
    """A number in short, nothing for None."""
    if value is None:
        return ""
    return f"{value:.8g}" if isinstance(value, float) else str(value)


class Report:
    """Collects the rows of one benchmark. Its folder is made at once, so that
    one that cannot be made costs no run."""

    def __init__(self, name, folder):
        folder.mkdir(parents=True, exist_ok=True)
        self.name = name
        self.folder = folder
        self.rows = []

    def diverged(self):
        """Has any run diverged?"""
        return any(row["quantity"] == "diverged at step" for row in self.rows)

    @staticmethod
    def load(folder):
        """The module benchmark.py of a folder."""
        spec = importlib.util.spec_from_file_location(
            folder.name, folder / "benchmark.py"
        )
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return module

    def add(self, row):
        """Take a row, a dictionary, and print it."""
        if not self.rows:
            print("  ".join(f"{n:>{w}}" for n, w in WIDTHS.items()))
        row = {"case": self.name, "solver": "immersedFluid", **row}
        self.rows.append(row)
        shown = dict(row)
        if row["error_percent"] is not None:
            shown["error_percent"] = f"{row['error_percent']:.4f}"
        print("  ".join(
            f"{text(shown[n]):>{w}}" for n, w in WIDTHS.items()
        ), flush=True)

    def write(self, draw=None):
        """Write results/NAME.csv and .png; draw(rows, file): for a figure
        other than that of error against run time."""
        with open(self.folder / f"{self.name}.csv", "w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(COLUMNS)
            for row in self.rows:
                writer.writerow([text(row[name]) for name in COLUMNS])
        file = self.folder / f"{self.name}.png"
        if draw:
            draw(self.rows, file)
        else:
            plot(self.rows, self.name, file)
