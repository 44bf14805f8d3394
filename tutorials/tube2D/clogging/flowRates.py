# SPDX-License-Identifier: GPL-3.0-or-later
"""flowRates.py NUMBER: flow rates of draws 1 to NUMBER, and how near the walls
their grains are, to postProcessing/flowRate.dat; the arguments of solveDraw for
those that are drawn to postProcessing/extremes."""

import pathlib
import re
import sys

import numpy as np

here = pathlib.Path(__file__).resolve().parent

KINDS = ("free", "held")
EXTREMES = 3
DEPTH = 0.1
FILE = here/"postProcessing/flowRate.dat"
COLUMNS = ("draw", "mean|y|[m]", "Q_free[m2/s]", "Q_held[m2/s]",
           "change_free", "change_held")


def centres(draw):
    """Centres (n, 2) of the grains."""
    text = (here/f"draws/{draw}/grainPositions").read_text()
    return np.array(re.findall(r"\((\S+) (\S+) 0\)", text), dtype=float)


def flowRate(draw, kind):
    """At the end, and its change in the last quarter of the time."""
    file = here/f"draws/{draw}/{kind}/postProcessing/flowRate/0" \
        / "surfaceFieldValue.dat"
    Q = np.loadtxt(file)[:, 1]/DEPTH
    return Q[-1], Q[-1]/Q[3*len(Q)//4 - 1] - 1


def read():
    """The table by column, without units."""
    names = [re.sub(r"\[.*", "", name) for name in COLUMNS]
    return dict(zip(names, np.loadtxt(FILE, ndmin=2).T))


def extremes(table, kind):
    """Draws of the highest flow rates, best first, and of the lowest, worst
    last."""
    order = table["draw"][np.argsort(-table[f"Q_{kind}"])].astype(int)
    return [*order[:EXTREMES], *order[-EXTREMES:]]


def main():
    rows = []
    for draw in range(1, int(sys.argv[1]) + 1):
        rates, changes = zip(*(flowRate(draw, kind) for kind in KINDS))
        height = np.mean(np.abs(centres(draw)[:, 1]))
        rows.append((draw, height, *rates, *changes))

    FILE.parent.mkdir(exist_ok=True)
    np.savetxt(FILE, rows, fmt=("%d", "%.4f", *2*("%.6f",), *2*("%.1e",)),
               delimiter="\t", header="\t".join(COLUMNS))

    table = read()
    lines = [f"{draw} {kind} fields\n" for kind in KINDS
             for draw in extremes(table, kind)]
    (FILE.parent/"extremes").write_text("".join(lines))


if __name__ == "__main__":
    main()
