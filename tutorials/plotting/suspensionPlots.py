# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws what the function objects suspensionStress, bodyAverages and closureFit
write.

    suspensionPlots.py CASE [STRESS [AVERAGES [CLOSURE]]]
                                            # CASE/plots/suspension*.png

or, from a script, drawAll(case), or any of the functions below. STRESS,
AVERAGES and CLOSURE are their names in system/controlDict, by default those of
their types.
Needs numpy and matplotlib.
"""

import pathlib
import sys

import numpy as np

import grainPlots as gp
from grainPlots import plt, tables

PARTS = ("fluid", "particle", "inertia", "contact", "film", "Reynolds")


def read(case, functionObject, table):
    return tables.run_columns(case, functionObject, table)


def viscosity(case, file, functionObject="suspensionStress"):
    """Viscosity over time, its mean so far, and twice the error of the mean."""
    rows = read(case, functionObject, "suspensionStress")
    means = read(case, functionObject, "suspensionStressMeans")
    figure, ax = plt.subplots(figsize=(6.5, 4))
    ax.plot(rows["time"], rows["viscosity"], color="0.6", linewidth=1,
            label="at each time")
    mean, error = means["viscosity"], means["errorOf_viscosity"]
    ax.plot(means["time"], mean, color="C0", label="mean so far")
    ax.fill_between(means["time"], mean - 2*error, mean + 2*error, color="C0",
                    alpha=0.25, linewidth=0, label="two standard errors")
    ax.set(xlabel="time [s]", ylabel="viscosity [m$^2$/s]")
    ax.legend()
    gp.save(figure, file)


def parts(case, file, functionObject="suspensionStress"):
    """Parts of the shear stress xy over time; those that are zero are left
    out."""
    rows = read(case, functionObject, "suspensionStress")
    figure, ax = plt.subplots(figsize=(6.5, 4))
    for i, part in enumerate(PARTS):
        if np.any(rows[f"{part}_xy"]):
            ax.plot(rows["time"], rows[f"{part}_xy"], color=f"C{i}", label=part)
    ax.set(xlabel="time [s]", ylabel="stress xy over density [m$^2$/s$^2$]")
    ax.legend()
    gp.save(figure, file)


def contacts(case, file, functionObject="suspensionStress"):
    """Contacts, and bodies of the largest cluster, over time."""
    rows = read(case, functionObject, "suspensionStress")
    figure, ax = plt.subplots(figsize=(6.5, 4))
    for name, label in (("contacts", "contacts"),
                        ("largestCluster", "bodies of the largest cluster")):
        ax.plot(rows["time"], rows[name], drawstyle="steps-post", label=label)
    ax.set(xlabel="time [s]", ylabel="number")
    ax.set_ylim(bottom=0)
    ax.legend()
    gp.save(figure, file)


def profiles(case, file, functionObject="bodyAverages"):
    """Volume fraction and velocities of fluid and bodies in the layers, at the
    last time."""
    rows = read(case, functionObject, "bodyAverages")
    last = rows["time"] == rows["time"].max()
    rows = {name: values[last] for name, values in rows.items()}
    flow = max("xyz", key=lambda i: np.abs(rows[f"UFluid_{i}"]).max())
    figure, (left, right) = plt.subplots(1, 2, sharey=True, figsize=(8, 4))
    left.plot(rows["bodyFraction"], rows["position"])
    left.set(xlabel="volume fraction of the bodies", ylabel="position [m]")
    left.set_xlim(left=0)
    for name, label in (("UFluid", "fluid"), ("UBodies", "bodies")):
        right.plot(rows[f"{name}_{flow}"], rows["position"], label=label)
    right.set(xlabel=f"velocity {flow} [m/s]")
    right.legend()
    gp.save(figure, file)


def closure(case, file, functionObject="closureFit"):
    """Of the whole mesh: coefficients over time, with two standard errors; the
    force that is fitted, its two parts and their sum."""
    rows = read(case, functionObject, "closureFit")
    rows = {name: values[rows["layer"] == 0] for name, values in rows.items()}
    time, phi = rows["time"], rows["bodyFraction"]
    figure, axes = plt.subplots(3, 1, sharex=True, figsize=(6.5, 7))
    for ax, name, label in zip(
        axes, ("drag", "addedMass"), ("drag [1/s]", "added mass")
    ):
        error = rows[f"errorOf_{name}"]
        # The first few samples tell nothing
        value = np.where(np.isnan(error), np.nan, rows[name])
        ax.plot(time, value)
        ax.fill_between(time, value - 2*error, value + 2*error, alpha=0.25,
                        linewidth=0)
        ax.set(ylabel=label)
    flow = max(
        "xyz", key=lambda i: np.nanmax(np.abs(rows[f"interaction_{i}"])))
    drag = rows["drag"][-1]*rows[f"slip_{flow}"]
    inertia = rows["addedMass"][-1]*phi*rows[f"slipAcceleration_{flow}"]
    ax = axes[2]
    ax.plot(time, rows[f"interaction_{flow}"], color="0.5", linewidth=3,
            label="force")
    ax.plot(time, drag + inertia, color="k", linewidth=1, linestyle="--",
            label="fit")
    ax.plot(time, drag, label="drag")
    ax.plot(time, inertia, label="added mass")
    ax.set(xlabel="time [s]", ylabel=f"force {flow} [m/s$^2$]")
    ax.legend(loc="upper left", bbox_to_anchor=(1, 1))
    gp.save(figure, file)


def drawAll(case, stress="suspensionStress", averages="bodyAverages",
            fit="closureFit"):
    """All pictures that there are tables for."""
    plots = pathlib.Path(case)/"plots"
    results = pathlib.Path(case)/"postProcessing"
    if (results/stress).is_dir():
        viscosity(case, plots/"suspensionViscosity.png", stress)
        parts(case, plots/"suspensionParts.png", stress)
        contacts(case, plots/"suspensionContacts.png", stress)
    if (results/averages).is_dir():
        profiles(case, plots/"suspensionProfiles.png", averages)
    if (results/fit).is_dir():
        closure(case, plots/"suspensionClosure.png", fit)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3, 4, 5) or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    drawAll(*sys.argv[1:])
