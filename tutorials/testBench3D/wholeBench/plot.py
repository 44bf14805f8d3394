# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the run: plots/{shares,flow}.png"""

import math
import pathlib
import sys

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(here.parent/"common"))

import benchPlots as bp
from friction import benchValues, blasius
from shares import drawPlanes, drawShares, report, shares

bench, values = bp.parameters(here), benchValues(here)
tubes, blocked = bench["outletTubes"], bench["head"]["blocked"]
title = f"outlet {blocked} blocked" if blocked else "all outlets open"


def pressures():
    """Mean pressure in the feed pipe, and the friction of straight tubes with
    the mean flow of the open ones, by Blasius [Pa]."""
    share, total = shares(here)
    D, rho = tubes["diameter"], values["rho"]
    U = total/(share > 0).sum()/(0.25*math.pi*D**2)
    friction = blasius(U*D/values["nu"])*tubes["length"]/D*0.5*rho*U**2
    return rho*bp.mean(here, "feedPipe", 0.4), friction, U, U*D/values["nu"]


cases = {title: here}
drawShares(cases, here/"plots/shares.png")
drawPlanes(cases, here/"plots/flow.png", reach=0.5)
print(report(title, here))
print("Pressure in the feed pipe {:.0f} Pa, friction of the tubes by Blasius "
      "{:.0f} Pa; mean velocity in the tubes {:.2f} m/s, Re {:.0f}".format(
          *pressures()))
