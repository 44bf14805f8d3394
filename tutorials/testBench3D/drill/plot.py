# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws what is read off the drill, plots/*.png, prints it, and writes
postProcessing/drill/0/drill.dat, a table of one row, for studies."""

import pathlib
import sys

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(here.parent/"common"))

import numpy as np
from benchPlots import gp, plt
from drillPressure import loading, means, parts, pressures
from drillPressurePlot import draw as drawPressure
from drillPressurePlot import table as pressureTable
from drillStatistics import Drill
from grainfoam.study import analysis

PLANES = {"afterBend": "behind the bend", "underHead": "under the head"}


def shares(run, file):
    found, numbers = run.shares(), run.outlets()
    counts = found["counts"]
    share, even = counts/counts.sum(), 1/len(counts)
    outlets = run.bench["head"]["outlets"]
    figure, ax = plt.subplots(figsize=(7.5, 3.8))
    ax.bar(numbers, 100*share, color="C1",
           yerr=100*np.abs(found["interval"].T - share), capsize=3)
    band = 1.96*np.sqrt(even*(1 - even)/counts.sum())
    ax.axhspan(100*(even - band), 100*(even + band), color="0.85", zorder=0,
               label="95 % of single outlets if by chance")
    ax.axhline(100*even, color="k", linestyle=":", linewidth=1)
    value, low, high = found["variation"]
    ax.set(xlabel="outlet (1: the outer side of the bend)",
           ylabel="share of the grains [%]",
           xticks=range(1, outlets + 1), xlim=(0.4, outlets + 0.6),
           title=f"{counts.sum()} grains, CV {value:.1%} ({low:.1%} to "
                 f"{high:.1%}), by chance {found['chance'][0]:.1%}")
    for number in set(range(1, outlets + 1)) - set(numbers):
        ax.text(number, 0.5, "closed", rotation=90, ha="center", va="bottom")
    ax.grid(axis="x", visible=False)
    ax.set_ylim(top=1.2*ax.get_ylim()[1])
    ax.legend(loc="upper right")
    gp.save(figure, file)


def section(run, file):
    """Where grains pass the feed pipe: places, radii, diameters, angles."""
    R = run.bench["feedPipe"]["diameter"]/2
    figure, axes = plt.subplots(2, 4, figsize=(13, 6.4))
    for row, name in zip(axes, PLANES):
        plane = run.planes[name]
        r, angle = plane["radius"]/R, np.radians(plane["angle"])
        x, y = r*np.cos(angle), r*np.sin(angle)
        image = row[0].scatter(x[:4000], y[:4000], 3, plane["axial"][:4000])
        figure.colorbar(image, ax=row[0], label="speed [m/s]")
        row[0].add_patch(plt.Circle((0, 0), 1, fill=False))
        row[0].set(aspect="equal", xlabel="x/R, + is outside", ylabel="y/R",
                   title=f"{PLANES[name]}, {len(r)} grains")
        edges = np.sqrt(np.linspace(0, 1, 11))
        density(row[1], r, edges, "r/R, rings of one area")
        for values, label in ((x, "x"), (y, "y")):
            diametral(row[2], values, label)
        density(row[3], np.degrees(angle) % 360, np.linspace(0, 360, 17),
                "angle [degrees]")
        row[3].set_xticks(range(0, 361, 90))
        row[2].legend()
    gp.save(figure, file)


def density(ax, values, edges, label):
    """Grains per class over the mean, with the error of counting."""
    counts, _ = np.histogram(values, edges)
    mean = counts.mean()
    ax.stairs(counts/mean, edges)
    ax.errorbar(0.5*(edges[1:] + edges[:-1]), counts/mean,
                1.96*np.sqrt(counts)/mean, fmt="none", ecolor="C0", capsize=2)
    ax.axhline(1, color="0.5", linewidth=0.8)
    ax.set(xlabel=label, ylabel="grains over the mean", ylim=(0, None))


def diametral(ax, values, label):
    """Grains in strips across the section, over those of an even section."""
    edges = np.linspace(-1, 1, 13)
    counts, _ = np.histogram(values, edges)
    area = np.diff(edges*np.sqrt(1 - edges**2) + np.arcsin(edges))/np.pi
    even = counts.sum()*area
    ax.errorbar(0.5*(edges[1:] + edges[:-1]), counts/even,
                1.96*np.sqrt(counts)/even, marker="o", capsize=2, label=label)
    ax.axhline(1, color="0.5", linewidth=0.8)
    ax.set(xlabel="place over R", ylabel="grains per area over the mean",
           ylim=(0, None))


def speeds(run, file):
    """Mean speed against radius, with its 95 % interval."""
    figure, ax = plt.subplots(figsize=(6, 3.8))
    R = {name: run.bench["feedPipe"]["diameter"]/2 for name in PLANES}
    tubes = [run.planes[n] for n in run.planes if n.startswith("outlet")]
    planes = {**{name: run.planes[name] for name in PLANES}, "outlet tubes": {
        c: np.concatenate([t[c] for t in tubes]) for c in ("radius", "axial")}}
    R["outlet tubes"] = run.bench["outletTubes"]["diameter"]/2
    for name, plane in planes.items():
        r, speed = plane["radius"]/R[name], plane["axial"]
        edges = np.linspace(0, 1, 9)
        part = np.digitize(r, edges) - 1
        rows = [(edges[i:i + 2].mean(), speed[part == i].mean(),
                 1.96*speed[part == i].std()/np.sqrt((part == i).sum()))
                for i in range(8) if (part == i).sum() > 2]
        ax.errorbar(*np.array(rows).T, marker="o", capsize=3,
                    label=PLANES.get(name, name))
    ax.set(xlabel="radius over R", ylabel="axial speed [m/s]", ylim=(0, None))
    ax.legend()
    gp.save(figure, file)


def spacing(run, file):
    figure, (left, right) = plt.subplots(1, 2, figsize=(10.5, 3.8))
    gaps, edges = run.intervals(), np.arange(0, 5.01, 0.25)
    counts, _ = np.histogram(gaps, edges)
    left.bar(edges[:-1] + 0.125, counts/len(gaps), 0.23,
             yerr=1.96*np.sqrt(counts)/len(gaps), capsize=2)
    t = np.linspace(0, 5)
    left.plot(t, 0.25*np.exp(-t), "k--", label="by chance, exp(-t)")
    left.set(xlabel="interval over the mean of the outlet",
             ylabel="share of the intervals",
             title=f"all outlets: CV {gaps.std(ddof=1):.0%}")
    left.legend()
    rows, numbers = run.spacing(), np.array(run.outlets())
    for k, (column, label) in enumerate(((1, "doubles, up to 0.5"),
                                         (2, "misses, above 1.5"))):
        p, number = np.nan_to_num(rows[:, column]), np.maximum(rows[:, 3], 1)
        ends = [analysis.share_interval(a*n, n) for a, n in zip(p, number)]
        right.bar(numbers + 0.4*k - 0.2, 100*p, 0.38, label=label, capsize=2,
                  yerr=100*np.abs(np.array(ends).T - p))
    for value in (1 - np.exp(-0.5), np.exp(-1.5)):
        right.axhline(100*value, color="k", linestyle="--", linewidth=1)
    right.set(xlabel="outlet", ylabel="share of the intervals [%]",
              title="dashed: by chance", xticks=numbers)
    right.set_ylim(top=1.3*right.get_ylim()[1])
    right.legend(ncol=2)
    gp.save(figure, file)


def residence(run, file):
    times = run.residence()
    figure, ax = plt.subplots(figsize=(6, 3.6))
    ax.hist(times, np.linspace(0, np.quantile(times, 0.99), 50))
    for q in (0.1, 0.5, 0.9):
        ax.axvline(np.quantile(times, q), color="k", linestyle="--",
                   linewidth=1)
    ax.set(xlabel="time from the roller to the end of a tube [s]",
           ylabel="grains", title="dashed: 10, 50, 90 %")
    gp.save(figure, file)


def report(run, stations, losses):
    """{name: value} for the table of a study, and what is printed; stations:
    their pressures, losses: [Part]."""
    found, rows = run.shares(), run.spacing()
    counts, gaps = found["counts"], run.intervals()
    times = run.residence()
    q, p = run.flowRate(), [state[0] for state in means(run, stations)["fan"]]
    tubes = np.concatenate([run.planes[n]["axial"] for n in run.planes
                            if n.startswith("outlet")])
    area = np.pi/4*run.bench["feedPipe"]["diameter"]**2
    values = {
        "grains": counts.sum(), "cv": found["variation"][0],
        "cvLow": found["variation"][1], "cvHigh": found["variation"][2],
        "cvChance": found["chance"][0],
        "cvChanceHigh": found["chance"][2], "cvFirst": found["halves"][0],
        "cvSecond": found["halves"][1], "least": counts.min()/counts.sum(),
        "most": counts.max()/counts.sum(),
        "spacingCv": gaps.std(ddof=1),
        "doubles": np.mean(gaps <= 0.5), "misses": np.mean(gaps > 1.5),
        "spacingCvLeast": np.nanmin(rows[:, 0]),
        "spacingCvMost": np.nanmax(rows[:, 0]),
        "residence10": np.quantile(times, 0.1),
        "residence50": np.median(times),
        "residence90": np.quantile(times, 0.9), "speed": tubes.mean(),
        "airAlone": q[0]/area, "air": q[1]/area, "pressureAlone": p[0],
        "pressure": p[1], "loading": loading(run),
        "impactEnergy": run.impacts()}
    for part in losses:
        name = "".join(word.title() for word in part.name.split())
        values[f"lossAlone{name}"] = part.alone[0]
        values[f"loss{name}"] = part.withSeeds[0]
    return {name: float(value) for name, value in values.items()}


def main():
    run, plots = Drill(here), here/"plots"
    stations = pressures(run)
    losses = parts(run, stations)
    drawPressure(run, stations, losses, plots/"pressure.png")
    print(*pressureTable(losses), sep="\n")
    if not run.planes:
        return
    number = run.blocks().sum()
    if number < 20:
        sys.exit(f"{number} seeds have left after the filling, too few to draw:"
                 " is the air fast enough for them?")
    for name, draw in (("shares", shares), ("section", section),
                       ("speed", speeds), ("spacing", spacing),
                       ("residence", residence)):
        draw(run, plots/f"{name}.png")
    values = report(run, stations, losses)
    table = here/"postProcessing/drill/0/drill.dat"
    table.parent.mkdir(parents=True, exist_ok=True)
    table.write_text("\t".join(["# time[s]", *values]) + "\n" + "\t".join(
        f"{value:.8g}" for value in (run.end, *values.values())) + "\n")
    print("\n".join(f"{name:<18}{value:.5g}" for name, value in values.items()))


if __name__ == "__main__":
    main()
