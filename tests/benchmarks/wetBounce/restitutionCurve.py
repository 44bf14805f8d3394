# SPDX-License-Identifier: GPL-3.0-or-later
"""Restitution against the Stokes number of the impact, with that of
experiments."""

MEAN, NEAR = "e/e_dry", "speed at a gap of 0.05 D instead"


def collect(rows):
    """St, e/e_dry by the mean speed, the same by the speed next to the wall, by
    what is not the default."""
    series, stokes = {}, None
    for row in rows:
        quantity, value = row["quantity"], float(row["value"])
        if quantity == "St":
            stokes = value
            continue
        label = row["settings"].partition(", ")[2] or "defaults"
        label += f", D/h {row['D_over_h']:g}"
        points = series.setdefault(label, {MEAN: [], NEAR: []})
        if quantity in points:
            points[quantity].append((stokes, value))
        elif quantity == "e/e_dry: none":
            points[MEAN].append((stokes, 0))
    return series


def draw(rows, file):
    """Write the figure."""
    import matplotlib
    matplotlib.use("Agg")
    import numpy as np
    from matplotlib import pyplot

    figure, panel = pyplot.subplots(figsize=(8, 4.5))
    St = np.geomspace(5, 1000, 200)
    panel.semilogx(St, np.exp(-35/St), "k-", label="exp(-35/St)")
    panel.fill_between(
        St, 0.85*np.exp(-35/St), 1.15*np.exp(-35/St), color="0.9",
        label="15 % from it",
    )
    for i, (label, points) in enumerate(collect(rows).items()):
        if not points[MEAN]:
            continue
        several = len(points[MEAN]) > 1
        panel.plot(
            *zip(*points[MEAN]), "o:" if several else "s", color=f"C{i}",
            label=label, lw=1,
        )
        if several and points[NEAR]:
            panel.plot(*zip(*points[NEAR]), "o", color=f"C{i}", mfc="none")
    panel.set_xlabel("Stokes number of the impact")
    panel.set_ylabel("restitution over that of a dry impact")
    panel.set_ylim(-0.03, 1.05)
    panel.set_title("open: by the speed at a gap of D/20", fontsize=9)
    panel.grid(alpha=0.3)
    panel.legend(fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))
    figure.savefig(file, dpi=120, bbox_inches="tight")
