# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the pressure of the drill along the way and part by part, and tells
it."""

import numpy as np
from benchPlots import gp, plt
from drillLosses import distances
from drillPressure import means
from drillStations import ALL, PARTS, legs

STATES = ("air alone", "with seeds")


def publishedWay(ax, parts, at):
    """Total pressure of the air alone by published losses: what is lost from a
    station on."""
    x = [at[first] for name, first, _ in PARTS if name != ALL]
    lost = np.cumsum([part.published for part in parts[-2::-1]], axis=0)[::-1]
    ax.fill_between(x, *lost.T, color="0.6", alpha=0.6, linewidth=0,
                    label="total, published losses")


def alongTheWay(ax, run, found, parts):
    """Static and total pressure against the distance."""
    at, values = distances(run), means(run, found)
    x = np.array([at[name] for name in values])
    for state, colour in zip(range(len(values["fan"])), ("C0", "C1")):
        for kind, style in enumerate(("o--", "o-")):
            ax.plot(x, [v[state][kind] for v in values.values()], style,
                    color=colour, markersize=4,
                    markerfacecolor="w" if kind == 0 else colour,
                    label=f"{('static', 'total')[kind]}, {STATES[state]}")
    publishedWay(ax, parts, at)
    start, end = legs(run.bench)["bend"]
    tubes = run.bench["outletTubes"]
    wall = at["ends"] - tubes["shortLength"] - tubes["diameter"]
    for name, ends in (("bend", (start, end)),
                       ("head", (legs(run.bench)["riser"][1], wall))):
        ax.axvspan(*ends, color="0.92", zorder=0)
        ax.text(0.5*sum(ends), 0.02, name, ha="center", va="bottom",
                transform=ax.get_xaxis_transform())
    ax.set(xlabel="distance from the fan along the way [m]",
           ylabel="pressure [Pa]",
           title="Mean pressure, weighted with the flow")
    ax.set_ylim(top=1.4*ax.get_ylim()[1])
    ax.legend(ncol=2, loc="upper right", fontsize=8)


def beside(ax, parts, series, ranges, unit):
    """Bars of each part with their intervals, beside published ranges."""
    x, width = np.arange(len(parts)), 0.8/(len(series) + 1)
    for k, (label, colour, values) in enumerate(series):
        mean, half = np.array(values).T
        ax.bar(x + (k - 0.5*len(series))*width, mean, 0.92*width, yerr=half,
               capsize=2, color=colour, label=label)
    low, high = np.array(ranges).T
    ax.bar(x + 0.5*len(series)*width, np.maximum(high - low, 1e-3*high.max()),
           0.92*width, bottom=low, color="0.6", edgecolor="0.2",
           label="published, least to greatest")
    ax.axhline(0, color="k", linewidth=0.8)
    ax.set_xticks(x, [part.name.replace(" ", "\n") for part in parts])
    ax.set(ylabel=unit)
    ax.grid(axis="x", visible=False)
    ax.legend(fontsize=8)


def draw(run, found, parts, file):
    figure, axes = plt.subplots(1, 3, figsize=(15, 4.2),
                                gridspec_kw={"width_ratios": (1.25, 1, 1)})
    alongTheWay(axes[0], run, found, parts)
    parts = [part for part in parts if part.name != ALL]
    beside(axes[1], parts, [
        (label, colour, values) for label, colour, values in (
            (STATES[0], "C0", [part.alone for part in parts]),
            (STATES[1], "C1", [part.withSeeds for part in parts]))
        if all(values)],
        [part.published for part in parts], "loss of total pressure [Pa]")
    axes[1].set_title("Losses; published ones for the air alone")
    if all(part.publishedAdded for part in parts):
        beside(axes[2], parts, [("here", "C1", [part.added for part in parts])],
               [part.publishedAdded for part in parts], "added loss [Pa]")
        axes[2].set_title("What seeds add at the same flow of air")
    else:
        axes[2].axis("off")
    gp.save(figure, file)


def table(parts):
    """Lines for the user."""
    lines = [f"{'losses [Pa]':<12}{'air alone':>16}{'published':>16}"
             f"{'with seeds':>16}{'seeds add':>16}{'published':>16}"]
    for part in parts:
        alone, seeds, added = (
            "{:.2f} +- {:.2f}".format(*value) if value else "-"
            for value in (part.alone, part.withSeeds, part.added))
        ranges = ["{:.1f} to {:.1f}".format(*ends) if ends else "-"
                  for ends in (part.published, part.publishedAdded)]
        lines.append(f"{part.name:<12}{alone:>16}{ranges[0]:>16}{seeds:>16}"
                     f"{added:>16}{ranges[1]:>16}")
    return lines
