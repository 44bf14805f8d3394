# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the run: plots/{pressure,profile,flow}.png"""

import pathlib
import sys

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(here.parent/"common"))

import benchPlots as bp
import numpy as np
from benchPlots import gp, plt
from friction import benchValues, blasius, report
from pieces import measuringTube

bench, values = bp.parameters(here), benchValues(here)
D, U, rho = (values[name] for name in ("diameter", "meanVelocity", "rho"))
Re = U*D/values["nu"]


def frictionFactor(z, p):
    """From the pressures over density at the stations."""
    return -np.polyfit(z, p, 1)[0]*2*D/U**2


def pressure(z, p):
    figure, ax = plt.subplots(figsize=(7, 3.4))
    start = rho*p[0]
    ax.plot(z, rho*p, "o", label="mean over sections")
    ax.plot(z, start - blasius(Re)*(z - z[0])/D*0.5*rho*U**2, "k--",
            linewidth=1, label="slope of Blasius")
    ax.set(xlabel="z [m]", ylabel="pressure [Pa]",
           title=f"Pressure along the tube, Re = {Re:.0f}")
    ax.legend()
    gp.save(figure, here/"plots/pressure.png")


def profile():
    """Axial velocity against radius at the sensor planes."""
    figure, ax = plt.subplots(figsize=(7, 4))
    planes = bench["measuringTube"]["sensorPlanes"]
    for i, z in enumerate(planes, 1):
        plane = bp.Plane(here, f"sensor{i}")
        r = np.hypot(plane.centres[:, 0], plane.centres[:, 1])
        # Where planes agree each is seen in a ring of the one before
        ax.plot(2*r/D, plane.fields["U"][:, 2], "o", fillstyle="none",
                markersize=3*(len(planes) - i) + 2, markeredgewidth=0.8,
                label=f"sensor plane {i}, z = {z:g} m")
    r = np.linspace(0, 1, 200)
    n = 6.6
    ax.plot(r, U*(n + 1)*(2*n + 1)/(2*n*n)*(1 - r)**(1/n), "k--", linewidth=1,
            label="power law 1/6.6 (Nikuradse, Re 2.3e4)")
    ax.set(xlabel="radius / radius of the tube", ylabel="axial velocity [m/s]",
           ylim=(0, None))
    ax.legend()
    gp.save(figure, here/"plots/profile.png")


def flow():
    figure, ax = plt.subplots(figsize=(7, 2.4))
    plane = bp.Plane(here, "along")
    # The tube lies on its side
    image = bp.drawPlane(ax, [corners[:, [2, 0]] for corners in plane.polygons],
                         plane.fields["U"][:, 2], (0, 1.3*U))
    ax.set_aspect("auto")
    for z in bench["measuringTube"]["sensorPlanes"]:
        ax.axvline(z, color="r", linewidth=1)
    ax.set(xlabel="z [m]", ylabel="x [m]", ylim=(-0.6*D, 0.6*D),
           title="Axial velocity in the plane y = 0; red: sensor planes")
    figure.colorbar(image, ax=ax, label="[m/s]")
    gp.save(figure, here/"plots/flow.png")


z = measuringTube(bench)[1]["distances"]["pressure"]
p = np.array([bp.last(here, f"pressure{i}") for i in range(len(z))])

pressure(z, p)
profile()
flow()
print(report(Re, frictionFactor(z, p), values["Ks"]/D))
print(f"Pressure drop {rho*(p[0] - p[-1])/(z[-1] - z[0]):.1f} Pa/m, run time "
      f"{bp.seconds(here):.0f} s")
