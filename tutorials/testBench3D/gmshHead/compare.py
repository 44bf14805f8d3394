# SPDX-License-Identifier: GPL-3.0-or-later
"""Air and grains on the mesh of gmsh beside those on the hexahedral one: a
table, plots/{shares,flow}.png"""

import pathlib
import re
import sys

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(here.parent/"common"))

import benchPlots as bp
import numpy as np
from benchPlots import gp, plt
from shares import drawPlanes, shares, variation

# Time after which the air is looked at, over that of the run
PART = 0.4
MESHES = {"gmsh": "tetrahedra and prisms", "hexahedra": "hexahedra"}


def case(mesh):
    return here.parent/f"gmshHead.{mesh}"


def grains(mesh):
    """Number of grains that have left by each outlet."""
    bench = bp.parameters(case(mesh))
    count = np.zeros(bench["head"]["outlets"])
    for event in gp.readPassage(here.parent/f"gmshHead.{mesh}.grains"):
        number = re.fullmatch(r"outlet(\d+)", event["where"] or "")
        if event["what"] != "enters" and number:
            count[int(number[1]) - 1] += 1
    return count


def figures(mesh):
    """{what: (value, format)} of the runs on a mesh."""
    air = case(mesh)
    density = bp.parameters(air)["air"]["density"]
    share, total = shares(air, PART)
    check = (air/"log.checkMesh").read_text()
    angle = re.search(r"non-orthogonality Max: (\S+) average: (\S+)", check)
    left = grains(mesh)
    return {
        "cells": (int(re.search(r"cells: +(\d+)", check)[1]), "d"),
        "non-orthogonality, largest [degrees]": (float(angle[1]), ".1f"),
        "the same, mean [degrees]": (float(angle[2]), ".1f"),
        "volume [l]": (1000*float(re.search(
            r"Total volume = (\S+)\. ", check)[1]), ".4f"),
        "flow rate of the outlets [l/s]": (1000*total, ".3f"),
        "pressure in the feed pipe over the outlets [Pa]": (
            density*bp.mean(air, "feedPipe", PART), ".2f"),
        "least share of the air [%]": (100*share[share > 0].min(), ".2f"),
        "largest share of the air [%]": (100*share.max(), ".2f"),
        "variation of the air's shares [%]": (100*variation(share), ".2f"),
        "grains that have left": (int(left.sum()), "d"),
        "variation of their shares [%]": (
            100*variation(left) if (left > 0).sum() > 1 else np.nan, ".1f"),
        "run time, air [s]": (bp.seconds(air), ".0f"),
        "run time, grains [s]": (bp.seconds(
            here.parent/f"gmshHead.{mesh}.grains"), ".0f"),
    }


def printTable():
    gmsh, hexahedra = (figures(mesh) for mesh in MESHES)
    print(f"{'':50}{'gmsh':>12}{'hexahedra':>12}{'difference':>12}")
    for what, (value, form) in gmsh.items():
        other, _ = hexahedra[what]
        # Of what is per cent already, and of angles, the difference itself
        plain = what.endswith("[%]") or "non-orth" in what or "mean" in what
        change = f"{value - other:+.2f}" if plain else \
            f"{100*(value/other - 1):+.1f} %" if other else ""
        print(f"{what:50}{value:>12{form}}{other:>12{form}}{change:>12}")

    one, other = (shares(case(mesh), PART)[0] for mesh in MESHES)
    print(f"largest difference of an outlet's share of the air: "
          f"{100*np.abs(one - other).max():.2f} % of all")
    n, m = (grains(mesh) for mesh in MESHES)
    if n.sum() and m.sum():
        p = (n + m)/(n + m).sum()
        chance = np.sqrt(p*(1 - p)*(1/n.sum() + 1/m.sum()))
        change = np.abs(n/n.sum() - m/m.sum())
        worst = np.argmax(change)
        print(f"the same of the grains: {100*change.max():.1f} %, of outlet "
              f"{worst + 1}; by chance {100*chance[worst]:.1f} % (one standard "
              "deviation)")


def drawShares(file):
    figure, axes = plt.subplots(2, 1, sharex=True, figsize=(8, 6))
    for i, (mesh, title) in enumerate(MESHES.items()):
        share, _ = shares(case(mesh), PART)
        outlets = np.arange(1, len(share) + 1) + 0.4*i - 0.2
        axes[0].bar(outlets, 100*share, 0.4, label=title)
        left = grains(mesh)
        if left.sum():
            p = left/left.sum()
            axes[1].bar(
                outlets, 100*p, 0.4, label=f"{left.sum():.0f} grains",
                yerr=100*np.sqrt(p*(1 - p)/left.sum()), capsize=2)
    axes[0].set(ylabel="share of the air [%]")
    axes[1].set(ylabel="share of the grains [%]", xlabel="outlet",
                xticks=np.arange(1, len(share) + 1))
    for ax in axes:
        ax.grid(axis="x", visible=False)
        ax.set_ylim(top=1.25*ax.get_ylim()[1])
        ax.legend(loc="upper right", ncol=2)
    gp.save(figure, file)


drawShares(here/"plots/shares.png")
drawPlanes({title: case(mesh) for mesh, title in MESHES.items()},
           here/"plots/flow.png", reach=0.22)
printTable()
