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


def centres(draw):
    """Centres (n, 2) of the grains."""
    text = (here/f"states/kindfree_draw{draw}/constant/grainPositions"
            ).read_text()
    return np.array(re.findall(r"\((\S+) (\S+) 0\)", text), dtype=float)


def read(kind):
    """Columns of the table: draw, Q, change, and mean |y| of the grains."""
    table = results.read_table(here/"postProcessing/study.csv")
    chosen = table["kind"] == kind
    columns = {name: table[name][chosen] for name in ("draw", "Q", "change")}
    columns["draw"] = columns["draw"].astype(int)
    columns["height"] = np.array(
        [np.mean(np.abs(centres(draw)[:, 1])) for draw in columns["draw"]])
    return columns


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
