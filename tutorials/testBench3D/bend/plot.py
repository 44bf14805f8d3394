# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the run: plots/{flow,sections,pressure}.png"""

import math
import pathlib
import sys

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(here.parent/"common"))

import benchPlots as bp
import numpy as np
from benchPlots import gp, plt
from friction import benchValues, periodicFriction
from losses import ito
from pieces import bend

bench, values = bp.parameters(here), benchValues(here)
tube = bench["bend"]
D, U, rho = (values[name] for name in ("diameter", "meanVelocity", "rho"))
Re = U*D/values["nu"]
sampled = bend(bench)[1]


def stations(where):
    """Distances [m] from the beginning of the straight part, pressures [Pa]."""
    s = sampled["distances"][where]
    return s, rho*np.array([bp.last(here, f"{where}{i}")
                            for i in range(len(s))])


def lossCoefficient(before, after, f):
    """From the pressures at the two ends of the bend, extrapolated along the
    slope of developed flow from where the bend is not felt: two diameters and
    more before it, ten and more behind it."""
    dynamic = 0.5*rho*U**2
    slope = f/D*dynamic
    s, p = before
    far = s <= max(tube["lengthBefore"] - 2*D, s[0])
    start = (p - slope*(tube["lengthBefore"] - s))[far].mean()
    s, p = after
    far = s >= min(10*D, s[-1])
    end = (p + slope*s)[far].mean()
    return (start - end)/dynamic, start, end, slope


def pressure(before, after, start, end, slope):
    figure, ax = plt.subplots(figsize=(7, 3.6))
    length = tube["radius"]*math.radians(tube["angle"])
    x0, x1 = -tube["lengthBefore"], tube["lengthAfter"]
    ax.plot((before[0] + x0)/D, before[1], "o", label="before")
    ax.plot((after[0] + length)/D, after[1], "o", label="behind")
    ax.plot([x0/D, 0], [start - slope*x0, start], "k--", linewidth=1,
            label="developed flow")
    ax.plot([length/D, (length + x1)/D], [end, end - slope*x1], "k--",
            linewidth=1)
    ax.axvspan(0, length/D, color="0.9")
    ax.set(xlabel="distance from the beginning of the bend [diameters]",
           ylabel="pressure [Pa]", title="Mean pressure, the bend in grey")
    ax.legend()
    gp.save(figure, here/"plots/pressure.png")


def flow():
    figure, ax = plt.subplots(figsize=(8, 3.4))
    plane = bp.Plane(here, "along")
    image = bp.drawPlane(ax, [corners[:, [0, 2]] for corners in plane.polygons],
                         np.linalg.norm(plane.fields["U"], axis=1), (0, 1.5*U))
    ax.set(xlabel="x [m]", ylabel="z [m]",
           title="Speed in the plane of the bend")
    figure.colorbar(image, ax=ax, label="[m/s]", shrink=0.8)
    gp.save(figure, here/"plots/flow.png")


def sections():
    """Velocity in sections; the outer side of the bend is on the left."""
    planes = [p for p in sampled["planes"] if p[0] != "along"]
    names = ["one diameter before", "middle of the bend", "its end",
             "2 diameters behind", "10 diameters behind"]
    figure, axes = plt.subplots(1, len(planes), figsize=(11, 2.9), sharey=True)
    for ax, (name, point, normal, _), title in zip(axes, planes, names):
        plane = bp.Plane(here, name)
        velocity, inwards = plane.fields["U"], np.cross((0, 1, 0), normal)
        across = 1000*np.column_stack([inwards, (0, 1, 0)])      # in mm
        image = bp.drawPlane(
            ax, [(corners - point) @ across for corners in plane.polygons],
            velocity @ normal, (0, 1.4*U))
        ax.quiver(*((plane.centres - point) @ across).T,
                  velocity @ inwards, velocity[:, 1],
                  scale=4*U, width=0.006, color="w")
        ax.set(title=title, xlabel="inwards [mm]")
        ax.title.set_fontsize(9)
    axes[0].set_ylabel("y [mm]")
    figure.colorbar(image, ax=axes, label="axial velocity [m/s]", shrink=0.8)
    gp.save(figure, here/"plots/sections.png")


before, after = stations("before"), stations("after")
_, f, _ = periodicFriction(here.parent/"inflow.bend")
zeta, *lines = lossCoefficient(before, after, f)

pressure(before, after, *lines)
flow()
sections()
reference = ito(Re, 2*tube["radius"]/D, tube["angle"])
text = f"Re {Re:.0f}: loss coefficient {zeta:.3f}"
if reference:
    text += f", Ito (1960) {reference:.3f} ({zeta/reference - 1:+.0%})"
print(text)
print(f"Run time {bp.seconds(here):.0f} s")
