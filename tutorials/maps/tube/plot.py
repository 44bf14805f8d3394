# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws lateral velocities between rough walls and errors by length and mesh:
plots/{rough,mesh,traction}.png; prints the figures of the README."""

import os
import pathlib
import sys

import numpy as np

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
root = os.environ.get("GRAINFOAM_DIR", here/"../../..")
sys.path[:0] = [f"{root}/tutorials/plotting", str(here)]

import grainPlots as gp  # source etc/bashrc of grainFoam
from grainfoam import tables
from grainfoam.study import analysis, results
from grainPlots import plt

# Body-fitted finite elements: at y = -0.3 without slip, Re to 0
REFERENCE = {"speed": 1.361306, "spin": -0.448684, "lateral": -1.6066e-4,
             "resistance": 6.357214, "turning": 0.0533790}

# By the force per area on the left end, and height: lateral velocity over
# F^2/nu, body-fitted finite elements at F = 0.5, nu = 0.5
LATERAL_BY_FORCE = np.array((
    (-0.1, -3.00312e-7), (-0.2, -5.02922e-7), (-0.3, -5.29091e-7),
    (-0.4, -3.34531e-7), (-0.5, 7.49544e-8), (-0.6, 6.30963e-7),
    (-0.7, 1.185442e-6), (-0.8, 1.462136e-6),
))
FORCES = 0.5, 1, 2, 4


def curves():
    """Heights, lateral velocity over Re and speed of each state of `rough`,
    by (a, K), in the order of the study."""
    table = results.read_table(here/"postProcessing/rough.csv")
    found = {}
    for name, a, K in zip(table["state"], table["a"], table["K"]):
        columns = tables.run_columns(here/"rough"/str(name), "stokesModes")
        found[a, K] = tuple(
            columns[key][:-1] for key in ("py0", "V1_y0", "V_x0"))
    return found


def rough(found):
    """Friction and shear rate of the walls: curves, zeros."""
    figure, axes = plt.subplots(1, 2, figsize=(10, 3.8), layout="constrained")
    for (a, K), (y, lateral, _) in found.items():
        zeros = [z for z in analysis.zeros(y, lateral) if z.slope < 0]
        print(f"a {a:g} K {K:g}: lateral velocity over Re at y -0.3 "
              f"{np.interp(-0.3, y, lateral):.4e}; stable at "
              + ", ".join(f"{z.x:.4f} slope {z.slope:.4e}" for z in zeros))
        ax = axes[0] if K == 0 else axes[1]
        label = f"a = {a:g}" if K == 0 else f"a = 1, K = {K:g}"
        line, = ax.plot(y, lateral, label=label)
        ax.plot([z.x for z in zeros], [0 for _ in zeros], "o",
                color=line.get_color(), markersize=5)
        if (a, K) == (1, 0):
            axes[1].plot(y, lateral, "k--", label="a = 1, K = 0")
    for ax in axes:
        ax.axhline(0, color="0.6", linewidth=0.8)
        ax.set(xlabel="height y [m]", ylabel="lateral velocity over Re [m/s]")
        ax.ticklabel_format(axis="y", scilimits=(0, 0))
        ax.legend(fontsize=8)
    gp.save(figure, here/"plots/rough.png")


def mesh():
    """Error by the half length of the tube, and by the size of cells beside
    the run time."""
    table = results.read_table(here/"postProcessing/mesh.csv")
    errors = {name: 100*np.abs(table[name]/value - 1)
              for name, value in REFERENCE.items()}
    for i, name in enumerate(table["state"]):
        print(f"{name}: {table['runTime'][i]:.1f} s, error in % "
              + ", ".join(f"{key} {100*(table[key][i]/value - 1):.3f}"
                          for key, value in REFERENCE.items()))
    figure, axes = plt.subplots(1, 2, figsize=(10, 3.8), layout="constrained")
    long = table["halfLength"] == 3
    order = np.argsort(table["across"][long])
    for name, error in errors.items():
        same = table["across"] == 124
        axes[0].semilogy(table["halfLength"][same], error[same], "o-",
                         label=name)
        axes[1].loglog(0.065*table["across"][long][order],
                       error[long][order], "o-", label=name)
    axes[0].set(xlabel="half length [m], 8 cells per diameter",
                ylabel="error [%]")
    axes[1].set(xlabel="cells per diameter, half length 3", ylabel="error [%]",
                xticks=(4, 8, 12, 16), xticklabels=(4, 8, 12, 16))
    axes[1].minorticks_off()
    axes[1].legend(fontsize=8)
    gp.save(figure, here/"plots/mesh.png")


def traction():
    """Lateral velocity between ends under traction, by height and force."""
    table = results.read_table(here/"postProcessing/traction.csv")
    order = np.argsort(table["y"])
    y, lateral = table["y"][order], table["lateral"][order]
    zeros = [z for z in analysis.zeros(y, lateral) if z.slope < 0]
    print("ends under traction: stable at "
          + ", ".join(f"{z.x:.4f} slope {z.slope:.4e} F^2/nu" for z in zeros))
    for at, expected in LATERAL_BY_FORCE:
        value = lateral[np.isclose(y, at)][0]
        print(f"    y {at:g}: {value:.4e} F^2/nu, "
              f"{100*(value/expected - 1):.2f} %")

    figure, axes = plt.subplots(1, 2, figsize=(10, 3.8), layout="constrained")
    for F in FORCES:
        axes[0].plot(y, lateral*F**2, ".-", label=f"F = {F:g} / s")
    axes[1].plot(y, lateral, ".-", label="here, all F")
    axes[1].plot(*LATERAL_BY_FORCE.T, "kx", label="finite elements, F = 0.5")
    axes[0].set(ylabel="lateral velocity times nu [m³/s²]")
    axes[1].set(ylabel="lateral velocity times nu over F² [m³]")
    for ax in axes:
        ax.axhline(0, color="0.6", linewidth=0.8)
        ax.plot([z.x for z in zeros], [0 for _ in zeros], "ko", markersize=5)
        ax.set(xlabel="height y [m]")
        ax.ticklabel_format(axis="y", scilimits=(0, 0))
        ax.legend(fontsize=8)
    gp.save(figure, here/"plots/traction.png")


def main():
    rough(curves())
    mesh()
    traction()


main()
