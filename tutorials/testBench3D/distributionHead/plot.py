# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the runs: plots/{shares,flow}.png"""

import pathlib
import sys

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(here.parent/"common"))

import benchPlots as bp
from shares import drawPlanes, drawShares, report


def name(case):
    blocked = bp.parameters(case)["head"]["blocked"]
    return f"outlet {blocked} blocked" if blocked else "all outlets open"


other = here.parent/"distributionHead.blocked"
cases = [here, *([other] if other.exists() and other != here else [])]
cases = {name(case): case for case in cases}

drawShares(cases, here/"plots/shares.png")
drawPlanes(cases, here/"plots/flow.png", reach=0.22)
for title, case in cases.items():
    print(report(title, case))
