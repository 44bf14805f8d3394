# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the run: plots/{flow,friction,profile}.png"""

import math
import pathlib
import sys

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(here.parent/"common"))

import benchPlots as bp
import numpy as np
from benchPlots import gp, plt
from friction import (
    benchValues, blasius, gradients, periodicFriction, report
)

values = benchValues(here)
D, U = values["diameter"], values["meanVelocity"]
Re, f, roughness = periodicFriction(here, part=0.5)
planes = {name: bp.Plane(here, name) for name in ("along", "section")}


def flow():
    figure, axes = plt.subplots(1, 2, figsize=(9, 2.7), width_ratios=(3.2, 1))
    for ax, name, seen in zip(axes, ("along", "section"), ([2, 0], [0, 1])):
        plane = planes[name]
        image = bp.drawPlane(
            ax, [1000*corners[:, seen] for corners in plane.polygons],
            plane.fields["U"][:, 2], (0, 1.4*U))
        ax.set(xlabel="xyz"[seen[0]] + " [mm]", ylabel="xyz"[seen[1]] + " [mm]")
    axes[0].set_title("Axial velocity at the end")
    figure.colorbar(image, ax=axes, label="[m/s]")
    gp.save(figure, here/"plots/flow.png")


def friction():
    log = (here/"log.foamRun").read_text()
    factors = 2*D*np.array(gradients(log))/U**2
    time = np.linspace(0, 0.5, len(factors))*U/D
    figure, ax = plt.subplots(figsize=(7, 3.4))
    ax.plot(time, factors, label="from the pressure gradient")
    ax.axhline(blasius(Re), color="k", linestyle="--", linewidth=1,
               label="Blasius")
    ax.set(xlabel="time [D/U]", ylabel="friction factor",
           ylim=(0, 1.5*blasius(Re)), title=f"Re = {Re:.0f}")
    ax.legend()
    gp.save(figure, here/"plots/friction.png")


def profile():
    """Mean velocity and fluctuations, in units of the wall."""
    shear = U*math.sqrt(f/8)
    figure, ax = plt.subplots(figsize=(7, 4.2))
    for name, plane in planes.items():
        y = D/2 - np.hypot(plane.centres[:, 0], plane.centres[:, 1])
        wall = y*shear/values["nu"]
        mean = plane.fields["UMean"][:, 2]/shear
        # In the order of VTK: xx yy zz ...
        rms = np.sqrt(plane.fields["UPrime2Mean"][:, 2])/shear
        ax.plot(wall, mean, "C0.", markersize=3,
                label="mean" if name == "along" else None)
        ax.plot(wall, rms, "C1.", markersize=3,
                label="axial fluctuations, rms" if name == "along" else None)
    y = np.geomspace(1, D/2*shear/values["nu"], 100)
    ax.plot(y[y < 11], y[y < 11], "k--", linewidth=1)
    ax.plot(y[y > 11], np.log(y[y > 11])/0.41 + 5.2, "k--", linewidth=1,
            label="viscous sublayer, logarithmic law")
    ax.set(xscale="log", xlabel="distance from the wall, y+",
           ylabel="velocity, u+")
    ax.legend()
    gp.save(figure, here/"plots/profile.png")


flow()
friction()
profile()
print("Mean of the second half: " + report(Re, f, roughness))
print(f"Run time {bp.seconds(here):.0f} s")
