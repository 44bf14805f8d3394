# SPDX-License-Identifier: GPL-3.0-or-later
"""The flow rates of all draws, and those that are drawn; as a program: writes
the study of these, with fields, to postProcessing/extremesDict."""

import pathlib
import re

import numpy as np

from grainfoam.study import results  # source etc/bashrc of grainFoam

here = pathlib.Path(__file__).resolve().parent

KINDS = ("free", "held")
EXTREMES = 3

STUDY = """// Written by flowRates.py: the highest and the lowest flow rates
parameters
{{
    kind    {{ values ({kinds}); }}
    draw    {{ values ({draws}); }}
}}

combine     zip;

folder      extremes;
copy        (system constant);
link        (constant/polyMesh 0);
commands    ("$STUDY/setUp" foamRun);
"""


RADIUS = 0.065

# What may decide the flow rate
MEASURES = {
    "height": "mean |y| of the grains [m]",
    "square": "mean y² of the grains [m²]",
    "crowd": "most grains in one section",
    "lane": "widest lane [m]",
    "chain": "least chain, sum of gap^2.5",
}


def centres(draw):
    """Centres (n, 2) of the grains, which free and held ones share."""
    file = next(here.glob(f"states/kind*_draw{draw}/constant/grainPositions"))
    return np.array(
        re.findall(r"\((\S+) (\S+) 0\)", file.read_text()), dtype=float)


def gaps(places):
    """Gaps between grains and, last two rows, to the lower and upper wall."""
    n = len(places)
    gap = np.full((n + 2, n + 2), 2.0)
    gap[:n, :n] = np.hypot(*np.moveaxis(
        places[:, None] - places[None], 2, 0)) - 2*RADIUS
    for wall, side in (n, -1), (n + 1, 1):
        gap[wall, :n] = gap[:n, wall] = 1 - side*places[:, 1] - RADIUS
    return gap


def across(lengths, combine):
    """Least length of a chain of gaps from wall to wall; combine: np.add, or
    np.maximum for the largest gap of a chain (Floyd 1962)."""
    found = lengths.copy()
    for k in range(len(found)):
        found = np.minimum(
            found, combine(found[:, k, None], found[None, k, :]))
    return found[-2, -1]


def measure(places):
    """MEASURES of a placing. The widest lane is as wide as the largest gap of
    the chain across the tube in which that is least; a gap g lets through in
    proportion to g^2.5 for the same pressure."""
    gap = gaps(places)
    x, y = places.T
    return (
        np.abs(y).mean(), np.mean(y**2),
        max(np.sum(np.abs(x - at) < RADIUS) for at in np.linspace(-3, 3, 601)),
        across(gap, np.maximum), across(np.maximum(gap, 0)**2.5, np.add),
    )


def read(kind):
    """Columns of the table: draw, Q, change, and the MEASURES."""
    table = results.read_table(here/"postProcessing/study.csv")
    chosen = table["kind"] == kind
    columns = {name: table[name][chosen] for name in ("draw", "Q", "change")}
    columns["draw"] = columns["draw"].astype(int)
    measures = np.array([measure(centres(i)) for i in columns["draw"]])
    return {**columns, **dict(zip(MEASURES, measures.T))}


def extremes(table):
    """Draws of the highest flow rates, best first, and of the lowest, worst
    last."""
    order = table["draw"][np.argsort(-table["Q"])]
    return [*order[:EXTREMES], *order[-EXTREMES:]]


def main():
    pairs = [(kind, str(draw)) for kind in KINDS
             for draw in extremes(read(kind))]
    kinds, draws = (" ".join(words) for words in zip(*pairs))
    (here/"postProcessing/extremesDict").write_text(
        STUDY.format(kinds=kinds, draws=draws))


if __name__ == "__main__":
    main()
