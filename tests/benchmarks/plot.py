# SPDX-License-Identifier: GPL-3.0-or-later
"""Error against run time: a panel for each quantity, a colour for each solver,
a marker for each of its settings."""

import itertools
import math

OURS = "immersedFluid"
COLOURS = ("tab:orange", "tab:green", "tab:red", "tab:purple", "tab:brown")
MARKERS = "osD^v<>pP*Xh"
LINES = ("-", "--", ":", "-.")
PANEL = 4.2, 3.4    # inches


def collect(rows):
    """Points (run time, error) by quantity and by (solver, settings)."""
    panels = {}
    for row in rows:
        if row["error_percent"] and row["cpu_s"]:
            key = row["solver"], row["settings"]
            point = row["cpu_s"], abs(row["error_percent"])
            lines = panels.setdefault(row["quantity"], {})
            lines.setdefault(key, []).append(point)
    return panels


def styles(keys):
    """Keywords of plot by (solver, settings)."""
    peers = dict.fromkeys(solver for solver, _ in keys if solver != OURS)
    colours = dict(zip(peers, itertools.cycle(COLOURS)), **{OURS: "tab:blue"})
    names = list(dict.fromkeys(settings for _, settings in keys))
    found = {}
    for solver, settings in keys:
        i = names.index(settings)
        found[solver, settings] = {
            "color": colours[solver],
            "marker": MARKERS[i % len(MARKERS)],
            "linestyle": LINES[i % len(LINES)],
            "markersize": 5,
            "label": f"{solver}: {settings}",
        }
    return found


def number_ticks(axis):
    """Labels 0.2, 0.5, 1, 2 rather than powers of ten only."""
    from matplotlib.ticker import LogLocator

    axis.set_major_formatter("{x:g}")
    axis.set_minor_locator(LogLocator(subs=(2, 5)))
    axis.set_minor_formatter("{x:g}")
    axis.set_tick_params(which="both", labelsize=8)


def plot(rows, title, file):
    """Write the figure; nothing if there is no error to show."""
    panels = collect(rows)
    if not panels:
        return

    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    keys = dict.fromkeys(itertools.chain.from_iterable(panels.values()))
    looks = styles(keys)
    across = min(len(panels), 3)
    down = math.ceil(len(panels)/across)
    legend = 0.19*math.ceil(len(keys)/across) + 0.2
    height = PANEL[1]*down + legend
    figure, axes = pyplot.subplots(
        down, across, squeeze=False, figsize=(PANEL[0]*across, height),
    )
    for panel in axes.flat[len(panels):]:
        panel.set_visible(False)

    handles = {}
    for panel, (quantity, lines) in zip(axes.flat, panels.items()):
        for key, points in lines.items():
            handles[key], = panel.loglog(*zip(*sorted(points)), **looks[key])
        panel.set_xlabel("run time [s]")
        panel.set_ylabel("|error| [%]")
        panel.set_title(quantity, fontsize=10)
        number_ticks(panel.xaxis)
        number_ticks(panel.yaxis)
        panel.grid(True, which="major", alpha=0.3)
    figure.suptitle(title)
    figure.legend(
        handles=[handles[key] for key in keys], fontsize=8,
        loc="lower center", ncols=across,
    )
    figure.tight_layout(rect=(0, legend/height, 1, 1))
    figure.savefig(file, dpi=130)
    pyplot.close(figure)
