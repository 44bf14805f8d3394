# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of a study's table: curves with their zeros, arrows over two
parameters, histograms with intervals."""

import numpy as np

from . import analysis
from .dictionary import Dictionary

COMMON = {"type", "where", "xLabel", "yLabel", "title"}


def column(content, table, key):
    """The column that an entry names."""
    name = content.get(key)
    if name not in table:
        raise content.error(f"'{key} {name}': the table has {' '.join(table)}")
    return table[name]


def curve(content, table, axes):
    """y against x, a line for each value of `group`; with `zeros yes` the zeros
    and whether they are stable."""
    content.check({"x", "y", "group", "zeros", "logX", *COMMON})
    x, y = column(content, table, "x"), column(content, table, "y")
    groups = column(content, table, "group") if "group" in content else \
        np.zeros(len(x))
    lines = []
    for value in dict.fromkeys(groups):
        rows = groups == value
        order = np.argsort(x[rows])
        label = f"{content.get('group')} = {value:g}" \
            if "group" in content and not isinstance(value, str) else value
        axes.plot(x[rows][order], y[rows][order], "o-", markersize=3,
                  label=label if "group" in content else None)
        if content.get("zeros", "no") == "yes":
            for zero in analysis.zeros(x[rows], y[rows]):
                fill = "k" if zero.stability == "stable" else "w"
                axes.plot(zero.x, 0, "ko", markerfacecolor=fill, zorder=3)
                lines.append(
                    (f"{content.get('group')} {value}: "
                     if "group" in content else "")
                    + f"{content.get('y')} is zero at {content.get('x')} ="
                    f" {zero.x:.6g}, slope {zero.slope:.4g}, {zero.stability}")
    if "group" in content:
        axes.legend()
    if content.get("zeros", "no") == "yes":
        axes.axhline(0, color="0.6", linewidth=0.8)
    if content.get("logX", "no") == "yes":
        axes.set_xscale("log")
    axes.set(xlabel=content.get("x"), ylabel=content.get("y"))
    return lines


def quiver(content, table, axes):
    """Arrows (u, v) over x and y, all of one length, coloured by magnitude."""
    content.check({"x", "y", "u", "v", *COMMON})
    x, y, u, v = (column(content, table, key) for key in "xyuv")
    size = np.hypot(u, v)
    scale = np.where(size > 0, size, 1)
    arrows = axes.quiver(x, y, u/scale, v/scale, size, pivot="mid", width=0.003)
    axes.figure.colorbar(
        arrows, ax=axes, label=f"|({content.get('u')}, {content.get('v')})|")
    axes.set(xlabel=content.get("x"), ylabel=content.get("y"))
    return []


def histogram(content, table, axes):
    """How often a column has which value, with 95 % intervals of the bars and
    of the mean."""
    content.check({"column", "bins", *COMMON})
    values = column(content, table, "column")
    counts, edges = np.histogram(
        values, bins=content.whole("bins", max(8, len(values)//20), 1))
    middles, width = 0.5*(edges[1:] + edges[:-1]), np.diff(edges)
    ends = np.array([analysis.share_interval(n, len(values)) for n in counts])
    shares = counts/len(values)
    axes.bar(middles, shares, 0.95*width, yerr=np.abs(ends.T - shares),
             error_kw={"elinewidth": 0.8, "ecolor": "0.3"})
    mean, low, high = analysis.mean_interval(values)
    axes.axvline(mean, color="k", linewidth=1)
    axes.axvspan(low, high, color="k", alpha=0.2, linewidth=0)
    axes.set(xlabel=content.get("column"), ylabel="share of the states")
    return [f"{content.get('column')}: mean {mean:.6g}, 95 % of means between"
            f" {low:.6g} and {high:.6g}; standard deviation"
            f" {np.std(values, ddof=1):.4g}, {len(values)} states"]


def chosen(content, table):
    """The rows of the table in which columns have the values of `where`."""
    if "where" not in content:
        return table
    wanted = content.get("where")
    if not isinstance(wanted, Dictionary):
        raise content.error("'where' has to be a dictionary of columns")
    rows = np.full(len(next(iter(table.values()))), True)
    for name, value in wanted.entries.items():
        if name not in table:
            raise wanted.error(f"'{name}': the table has {' '.join(table)}")
        rows &= table[name] == value
    return {name: values[rows] for name, values in table.items()}


TYPES = {"curve": curve, "quiver": quiver, "histogram": histogram}


def check(study):
    """Refuse wrong types."""
    for content in study.dictionaries("plots").values():
        content.choice("type", TYPES)


def draw(study, table, folder):
    """Draw all entries of `plots` to folder; returns lines for the log."""
    # Takes a second to load
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    lines = []
    for name, content in study.dictionaries("plots").items():
        rows = chosen(content, table)
        if not len(next(iter(rows.values()))):
            lines.append(f"Plot '{name}': no state is as 'where' says")
            continue
        figure, axes = plt.subplots(figsize=(6, 4.2))
        lines += TYPES[content.get("type")](content, rows, axes)
        for key, setter in (("xLabel", axes.set_xlabel),
                            ("yLabel", axes.set_ylabel),
                            ("title", axes.set_title)):
            if key in content:
                setter(content.get(key))
        figure.tight_layout()
        folder.mkdir(exist_ok=True)
        figure.savefig(folder/f"{name}.png", dpi=120)
        plt.close(figure)
        lines.append(f"Drew {folder/name}.png")
    return lines
