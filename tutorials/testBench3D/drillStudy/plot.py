# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the coefficient of variation of the outlets' shares, with its 95 %
interval, for each change of a parameter: plots/sweep.png; prints a table."""

import csv
import pathlib
import sys

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(here.parent/"common"))

import numpy as np
from benchPlots import gp, plt

LABELS = {"fanPressure": "fan {:g} Pa", "rate": "{:g} grains/s per outlet",
          "bendRadius": "bend of {:g} m", "wallRoughness": "roughness {:g} deg",
          "restitution": "restitution {:g}", "headHeight": "head {:g} m high",
          "blocked": "outlet {:g} closed"}
COLUMNS = ("grains", "cv", "cvLow", "cvHigh", "cvChance", "spacingCv", "doubles",
           "misses", "speed", "air", "pressure", "residence50", "impactEnergy")


def states():
    """[(label, {column: value})] of those that are done; the first is the one
    that others differ from."""
    with open(here/"postProcessing/study.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    first, found = rows[0], []
    for row in rows:
        changed = [text.format(float(row[name]))
                   for name, text in LABELS.items() if row[name] != first[name]]
        if row["cv"]:
            found.append((", ".join(changed) or "nothing changed", {
                name: float(row[name]) for name in COLUMNS}))
    return found


def main():
    found = states()
    figure, ax = plt.subplots(figsize=(7.5, 0.5*len(found) + 1.6))
    y = np.arange(len(found))[::-1]
    cv, low, high, chance = (
        100*np.array([row[name] for _, row in found])
        for name in ("cv", "cvLow", "cvHigh", "cvChance"))
    ax.errorbar(cv, y, xerr=np.abs([low - cv, high - cv]), fmt="o", capsize=4,
                label="run, with 95 %")
    ax.plot(chance, y, "k|", markersize=12, label="by chance")
    ax.set(yticks=y, yticklabels=[label for label, _ in found], xlim=(0, None),
           xlabel="coefficient of variation of the outlets' shares [%]")
    ax.legend()
    ax.margins(y=0.15)
    gp.save(figure, here/"plots/sweep.png")
    print("".ljust(26), *(name[:9].rjust(9) for name in COLUMNS))
    for label, row in found:
        print(label.ljust(26), *(f"{row[n]:9.3g}" for n in COLUMNS))


if __name__ == "__main__":
    main()
