# SPDX-License-Identifier: GPL-3.0-or-later
"""Time of a step against the number of grains, from the rows of a benchmark."""

import re

from plot import number_ticks

LOOKS = {1: ("o", "-"), 2: ("s", "--")}
COLOURS = ("tab:blue", "tab:orange", "tab:green", "tab:red")


def collect(rows, parts):
    """Points (number of grains, ms) by (part, ranks); settings of a row are
    "N grains" or "N grains, R ranks"."""
    lines = {}
    for row in rows:
        match = re.match(
            r"(\d+) grains(?:, (\d+) ranks?)?$", str(row["settings"])
        )
        if match and row["quantity"] in parts and row["value"]:
            number, ranks = int(match[1]), int(match[2] or 1)
            line = lines.setdefault((row["quantity"], ranks), [])
            line.append((number, float(row["value"])))
    return lines


def plot_grains(rows, parts, title, file):
    """Write the figure; parts: labels by quantity. Nothing if there are no
    rows of these."""
    lines = collect(rows, parts)
    if not lines:
        return

    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(7.2, 4.2))
    colours = dict(zip(parts, COLOURS))
    several = len({ranks for _, ranks in lines}) > 1
    for (part, ranks), points in lines.items():
        marker, style = LOOKS.get(ranks, ("^", ":"))
        on = several*f", {ranks} rank{'s'*(ranks > 1)}"
        seen = sorted(point for point in points if point[0])
        if seen:
            axes.loglog(
                *zip(*seen), marker=marker, linestyle=style, markersize=5,
                color=colours[part], label=parts[part] + on,
            )
        for number, time in points:
            if number == 0 and part == next(iter(parts)):
                axes.axhline(
                    time, linewidth=0.9, linestyle=style, color="0.4",
                    label="no grains" + on,
                )
    axes.set_xlabel("grains")
    axes.set_ylabel("time of a step [ms]")
    axes.set_title(title, fontsize=10)
    axes.grid(True, which="major", alpha=0.3)
    axes.xaxis.set_major_formatter("{x:g}")
    number_ticks(axes.yaxis)
    axes.legend(fontsize=8, loc="upper left", bbox_to_anchor=(1.01, 1))
    figure.tight_layout()
    figure.savefig(file, dpi=130)
    pyplot.close(figure)
