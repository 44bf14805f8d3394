# SPDX-License-Identifier: GPL-3.0-or-later
"""Flow shares of the outlets of a case with the distribution head."""

import benchPlots as bp
import numpy as np
from benchPlots import gp, plt


def shares(case, part=0.4):
    """Share of each outlet, 0 for the one that is blocked, and mean flow rate
    [m3/s]; over the last part of the run."""
    head = bp.parameters(case)["head"]
    rates = np.array([
        0 if number == head["blocked"]
        else bp.mean(case, f"outlet{number}", part)
        for number in range(1, head["outlets"] + 1)])
    return rates/rates.sum(), rates.sum()


def variation(share):
    """Coefficient of variation over the open outlets, standard deviation of the
    sample over mean."""
    open_ = share[share > 0]
    return open_.std(ddof=1)/open_.mean()


def report(name, case):
    """One line for the user."""
    share, total = shares(case)
    open_ = share[share > 0]
    return (f"{name}: {len(open_)} outlets, shares {open_.min():.4f} to "
            f"{open_.max():.4f}, coefficient of variation "
            f"{variation(share):.2%}, {1000*total:.1f} l/s, run time "
            f"{bp.seconds(case):.0f} s")


def drawShares(cases, file):
    """Bars of the shares; cases: {name: folder}."""
    figure, ax = plt.subplots(figsize=(8, 3.6))
    width = 0.8/len(cases)
    for i, (name, case) in enumerate(cases.items()):
        share, _ = shares(case)
        places = np.arange(1, len(share) + 1) + (i + 0.5)*width - 0.4
        ax.bar(places, 100*share, width,
               label=f"{name}: CV {variation(share):.2%}")
        ax.axhline(100*share[share > 0].mean(), color=f"C{i}", linestyle=":",
                   linewidth=1)
    ax.set(xlabel="outlet", ylabel="share of the air [%]",
           xticks=np.arange(1, len(share) + 1),
           title="Dotted: an equal share of what is open")
    ax.legend(loc="lower right", frameon=True)
    gp.save(figure, file)


def drawPlanes(cases, file, reach):
    """Speed in the two planes through the outlets; reach: half the width of the
    picture [m]."""
    figure, axes = plt.subplots(2, len(cases), figsize=(4.4*len(cases), 7),
                                squeeze=False)
    for column, (title, case) in zip(axes.T, cases.items()):
        limit = (0, 1.5*bp.parameters(case)["air"]["feedVelocity"])
        for ax, name, seen in zip(
                column, ("horizontal", "vertical"), ([0, 1], [0, 2])):
            plane = bp.Plane(case, name)
            image = bp.drawPlane(
                ax, [corners[:, seen] for corners in plane.polygons],
                np.linalg.norm(plane.fields["U"], axis=1), limit)
            ax.set(xlim=(-reach, reach), xlabel="x [m]",
                   ylabel="xyz"[seen[1]] + " [m]")
        column[0].set(ylim=(-reach, reach), title=title)
        column[1].set(ylim=(-0.25, 0.1))
    gp.colourBar(figure, image, axes, "speed [m/s]")
    gp.save(figure, file)
