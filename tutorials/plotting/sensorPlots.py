# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws what the function object opticalSensor writes.

    sensorPlots.py CASE [FUNCTION_OBJECT]     # writes CASE/plots/sensor*.png

or, from a script, drawAll(case), or any of the functions below. FUNCTION_OBJECT
is its name in system/controlDict, by default sensor. Needs numpy and
matplotlib.
"""

import pathlib
import sys

import numpy as np

import grainPlots as gp
from grainPlots import plt, tables


def folderOf(case, functionObject):
    return pathlib.Path(case)/"postProcessing"/functionObject


def readPassages(case, functionObject="sensor"):
    """All passages of a run: {column: values}."""
    return tables.run_columns(case, functionObject, "passages")


def readStatistics(case, table, functionObject="sensor", time=None):
    """summary, radii, intervals or outlets, of the last time or another one."""
    files = folderOf(case, functionObject).glob(f"*/{table}.dat")
    byTime = {float(f.parent.name): f for f in files}
    return tables.read_columns(byTime[max(byTime) if time is None else float(time)])


def planeNames(case, functionObject="sensor"):
    return list(readStatistics(case, "summary", functionObject)["name"])


def onePlane(table, plane):
    """Rows of the plane of a number."""
    rows = table["plane"] == plane
    return {name: values[rows] for name, values in table.items()}


def axesOf(n, width=4.2, height=3.6):
    """A row of pictures, one per plane, at most four beside each other."""
    columns = min(n, 4)
    rows = -(-n//columns)
    figure, axes = plt.subplots(rows, columns, squeeze=False, sharey=True,
                                figsize=(width*columns, height*rows))
    for ax in axes.flat[n:]:
        ax.axis("off")
    return figure, list(axes.flat[:n])


def speedAgainstRadius(case, file, functionObject="sensor", unit=1, label="m"):
    """A point per grain, and the mean in each part of the radius; unit: length
    of the axis in m."""
    names = planeNames(case, functionObject)
    passages = readPassages(case, functionObject)
    radii = readStatistics(case, "radii", functionObject)
    figure, axes = axesOf(len(names))

    for plane, (ax, name) in enumerate(zip(axes, names)):
        grains, parts = onePlane(passages, plane), onePlane(radii, plane)
        ax.plot(grains["radius"]/unit, grains["axial"], ".", color="0.6",
                markersize=4, label="grains")
        # One grain is no mean: the line is broken there
        several = parts["grains"] > 1
        middle = (parts["inner"] + parts["outer"])/2/unit
        mean, deviation = (np.where(several, parts[c], np.nan)
                           for c in ("meanSpeed", "deviation"))
        ax.errorbar(middle, mean, deviation, fmt="o-", capsize=3,
                    label="mean of two and more, standard deviation")
        ax.set(xlabel=f"radius [{label}]", title=name)
        ax.set_xlim(left=0)
    axes[0].set_ylabel("axial velocity [m/s]")
    axes[0].set_ylim(bottom=min(0, axes[0].get_ylim()[0]))
    legendAbove(figure, axes[0])
    gp.save(figure, file)


def legendAbove(figure, ax):
    """Where it covers nothing: above all pictures."""
    handles, labels = ax.get_legend_handles_labels()
    columns = min(len(labels), 3)
    rows = -(-len(labels)//columns)
    height = figure.get_figheight()
    figure.set_figheight(height + 0.22*rows + 0.1)
    share = height/figure.get_figheight()
    figure.get_layout_engine().set(rect=(0, 0, 1, share))
    figure.legend(handles, labels, loc="upper center", ncol=columns)


def countingError(parts):
    """Standard deviation of a Poisson distribution, of densityOverMean; none
    where there is no grain."""
    n = parts["grains"]
    return parts["densityOverMean"]/np.sqrt(np.where(n > 0, n, np.nan))


def radialDensity(case, file, functionObject="sensor", unit=1, label="m"):
    """Grains per area of the section, over the mean."""
    names = planeNames(case, functionObject)
    radii = readStatistics(case, "radii", functionObject)
    figure, ax = plt.subplots(figsize=(6.5, 4))

    for plane, name in enumerate(names):
        parts = onePlane(radii, plane)
        if not parts["outer"].size:
            continue
        edges = np.append(parts["inner"], parts["outer"][-1])/unit
        grains = parts["grains"].sum()
        ax.stairs(parts["densityOverMean"], edges, baseline=None, linewidth=1.6,
                  color=f"C{plane}", label=f"{name}: {grains:.0f} grains")
        # Beside each other in each part of the radius
        x = edges[:-1] + np.diff(edges)*(plane + 1)/(len(names) + 1)
        ax.errorbar(x, parts["densityOverMean"], countingError(parts),
                    fmt="none", ecolor=f"C{plane}", capsize=2, elinewidth=1)
    ax.axhline(1, color="0.5", linewidth=0.8)
    ax.set(xlabel=f"radius [{label}]", ylabel="grains per area, over the mean",
           title="bars: counting error, the square root of the number",
           xlim=(0, None), ylim=(0, None))
    ax.title.set_size(9)
    legendAbove(figure, ax)
    gp.save(figure, file)


def spacing(case, file, functionObject="sensor"):
    """How many intervals between signals there are of each length, with
    multiples and misses."""
    names = planeNames(case, functionObject)
    intervals = readStatistics(case, "intervals", functionObject)
    summary = readStatistics(case, "summary", functionObject)
    figure, axes = axesOf(len(names))

    for plane, (ax, name) in enumerate(zip(axes, names)):
        parts = onePlane(intervals, plane)
        if not parts["from"].size:
            continue
        width = parts["to"][1] - parts["from"][1]
        middle = parts["from"] + width/2
        middle[0] = 0
        share = parts["number"]/max(parts["number"].sum(), 1)
        ax.axvspan(-width, 0.5, color="C3", alpha=0.08)
        ax.axvspan(1.5, middle[-1] + width, color="C1", alpha=0.1)
        ax.bar(middle, share, 0.9*width)
        cv = summary["variationOfInterval"][plane]
        ax.set(xlabel="interval over the nominal one",
               xlim=(-width, middle[-1] + width),
               title=f"{name}: CV {100*cv:.0f} %")
        for x, text in ((0.25, "multiples"), (2.2, "misses")):
            ax.text(x, 0.97, text, transform=ax.get_xaxis_transform(),
                    ha="center", va="top", fontsize=8, color="0.4")
    axes[0].set_ylabel("share of the intervals")
    gp.save(figure, file)


def multiplesAndMisses(case, file, functionObject="sensor"):
    """Per second, by plane."""
    summary = readStatistics(case, "summary", functionObject)
    figure, ax = plt.subplots(figsize=(6.5, 3.8))
    x = np.arange(len(summary["name"]))
    series = (
        ("multipleRate", "multiples: up to half the nominal interval", "C3"),
        ("missRate", "misses: above one and a half", "C1"),
        ("doubleRate", "doubles: several grains in one signal", "C0"),
    )

    for k, (column, label, colour) in enumerate(series):
        ax.bar(x + 0.27*(k - 1), np.nan_to_num(summary[column]), 0.25,
               color=colour, label=label)
    ax.set(xticks=x, xticklabels=summary["name"], ylabel="per second [1/s]")
    ax.grid(axis="x", visible=False)
    ax.margins(y=0.35)
    ax.legend(loc="upper left")
    gp.save(figure, file)


def outletShares(case, file, functionObject="sensor"):
    """Share of each outlet, with the even share and the coefficient of
    variation."""
    outlets = readStatistics(case, "outlets", functionObject)
    n = len(outlets["name"])
    cv = outlets["grains"].std(ddof=1)/outlets["grains"].mean()
    figure, ax = plt.subplots(figsize=(max(4.5, 0.5*n + 2), 3.8))
    ax.bar(range(n), 100*outlets["share"])
    ax.axhline(100/n, color="k", linewidth=1, linestyle="--", label="even")
    ax.set(xticks=range(n), ylabel="share of the grains [%]",
           title=f"{outlets['grains'].sum():.0f} grains, CV {100*cv:.1f} %")
    ax.set_xticklabels(outlets["name"], rotation=90 if n > 6 else 0)
    ax.grid(axis="x", visible=False)
    ax.legend()
    gp.save(figure, file)


def drawAll(case, functionObject="sensor", **length):
    """All pictures that there are tables for; length: unit and label."""
    plots = pathlib.Path(case)/"plots"

    if not len(readPassages(case, functionObject).get("time", [])):
        print("No grain has passed a plane yet")
        return

    if len(readStatistics(case, "radii", functionObject)["plane"]):
        speedAgainstRadius(case, plots/f"{functionObject}Speed.png",
                           functionObject, **length)
        radialDensity(case, plots/f"{functionObject}Density.png",
                      functionObject, **length)
    if len(readStatistics(case, "intervals", functionObject)["plane"]):
        spacing(case, plots/f"{functionObject}Spacing.png", functionObject)
        multiplesAndMisses(case, plots/f"{functionObject}Misses.png",
                           functionObject)
    if any(folderOf(case, functionObject).glob("*/outlets.dat")):
        outletShares(case, plots/f"{functionObject}Outlets.png",
                     functionObject)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3) or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    drawAll(*sys.argv[1:])
