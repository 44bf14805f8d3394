# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the shares of the outlets, of grains beside air: plots/shares.png; and
says where the grains are that have not left."""

import pathlib
import sys

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(here.parent/"common"))

import benchPlots as bp
import numpy as np
import sensorPlots
from benchPlots import gp, plt
from shares import shares as airShares

# Slower than that it lies still [m/s]
REST = 0.05


def title(case):
    blocked = bp.parameters(case)["head"]["blocked"]
    return f"outlet {blocked} blocked" if blocked else "all outlets open"


def airOf(case):
    """The case of distributionHead that the air is from."""
    return case.parent/case.name.replace("headGrains", "distributionHead")


def numbers(case):
    """Number of grains through each outlet; 0 for the one that is blocked."""
    table = sensorPlots.readStatistics(case, "outlets")
    count = np.zeros(bp.parameters(case)["head"]["outlets"])
    for name, grains in zip(table["name"], table["grains"]):
        count[int(name.removeprefix("outlet")) - 1] = grains
    return count


def uncertainty(count):
    """Standard deviation of the shares, of grains that choose at random."""
    p = count/count.sum()
    return np.sqrt(p*(1 - p)/count.sum())


def variation(values):
    """Coefficient of variation over the open outlets."""
    open_ = values[values > 0]
    return open_.std(ddof=1)/open_.mean()


def remaining(case):
    """Grains that are in the mesh at the last time of the table of their motion:
    {place: (number, number at rest)}."""
    bench = bp.parameters(case)
    head = bench["head"]
    left = {event["name"]: event["time"] for event in gp.readPassage(case)
            if event["what"] != "enters"}
    motion = gp.readMotion(case)
    end = max(body["time"][-1] for body in motion.values() if len(body["time"]))
    places = {}
    for name, body in motion.items():
        if not len(body["time"]) or body["time"][-1] < end \
                or left.get(name, np.inf) <= end:
            continue
        x, y, z = (body[f"position_{k}"][-1] for k in "xyz")
        speed = np.linalg.norm([body[f"velocity_{k}"][-1] for k in "xyz"])
        number = round(np.arctan2(y, x)/(2*np.pi)*head["outlets"]) \
            % head["outlets"] + 1
        if np.hypot(x, y) < head["diameter"]/2:
            place = "feed pipe" if z < 0 else "head"
        else:
            place = "the blocked tube" if number == head["blocked"] \
                else "open tubes"
        all_, still = places.get(place, (0, 0))
        places[place] = (all_ + 1, still + (speed < REST))
    return places


def report(case):
    count, air = numbers(case), airShares(airOf(case))[0]
    events = gp.readPassage(case)
    entered = sum(event["what"] == "enters" for event in events)
    back = sum(event["where"] == "fanInlet" for event in events)
    N, n = count.sum(), (count > 0).sum()
    lines = [
        f"{title(case)}: {entered} grains entered, {N:.0f} have left by {n} "
        f"outlets, shares {count[count > 0].min()/N:.4f} to "
        f"{count.max()/N:.4f} +- {uncertainty(count).max():.4f}",
        f"  coefficient of variation {variation(count):.2%} (by chance alone "
        f"{np.sqrt(n/N):.2%}); of the air {variation(air):.2%}; "
        f"run time {bp.seconds(case):.0f} s"]
    if back:
        lines.append(f"  {back} fell back through the feed pipe")
    for place, (all_, still) in sorted(remaining(case).items()):
        lines.append(f"  in {place} at the end: {all_}, of which {still} lie "
                     "still")
    return "\n".join(lines)


def draw(cases, file):
    figure, axes = plt.subplots(len(cases), 1, squeeze=False, sharex=True,
                                figsize=(8, 3.2*len(cases)))
    for ax, case in zip(axes[:, 0], cases):
        count, air = numbers(case), airShares(airOf(case))[0]
        outlets = np.arange(1, len(count) + 1)
        ax.bar(outlets - 0.2, 100*air, 0.4, color="C7",
               label=f"air: CV {variation(air):.1%}")
        ax.bar(outlets + 0.2, 100*count/count.sum(), 0.4, color="C1",
               yerr=100*uncertainty(count), capsize=2,
               label=f"{count.sum():.0f} grains: CV {variation(count):.1%}")
        ax.axhline(100/(count > 0).sum(), color="k", linestyle=":", linewidth=1)
        ax.set(ylabel="share [%]", xticks=outlets, title=title(case))
        ax.grid(axis="x", visible=False)
        ax.set_ylim(top=1.2*ax.get_ylim()[1])
        ax.legend(loc="upper right", ncol=2)
    axes[-1, 0].set_xlabel("outlet")
    gp.save(figure, file)


other = here.parent/"headGrains.blocked"
cases = [here, *([other] if other.exists() and other != here else [])]
draw(cases, here/"plots/shares.png")
for case in cases:
    print(report(case))
