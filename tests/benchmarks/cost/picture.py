# SPDX-License-Identifier: GPL-3.0-or-later
"""Steps of one rank beside stock pimpleFoam's, with their parts."""

PARTS = {
    "momentum ms": "tab:blue", "pressure ms": "tab:green",
    "bodies ms": "tab:red", "other ms": "lightgrey",
}
LINE = 0.21                 # inches per run
WIDEST = 1.6                # what is longer is cut off, and says how long


def collect(rows):
    """Quantities of the runs on one rank, by mesh and by what they were."""
    meshes = {}
    for row in rows:
        mesh, *settings = row["settings"].split(", ")
        if "2 ranks" not in settings:
            label = ", ".join([row["solver"], *settings])
            runs = meshes.setdefault(mesh, {})
            runs.setdefault(label, {})[row["quantity"]] = float(row["value"])
    return meshes


def draw(rows, file):
    """Write the figure."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    meshes = collect(rows)
    lines = sum(len(runs) + 1.5 for runs in meshes.values())
    figure, panel = pyplot.subplots(figsize=(9, LINE*lines + 1))
    y, places, names = 0, [], []
    for mesh, runs in meshes.items():
        stock = next(iter(runs.values()))["ms per step"]
        panel.text(
            0.01, y, f"{mesh}: {stock:.0f} ms", fontsize=8, weight="bold",
            va="center",
        )
        for label, run in runs.items():
            y += 1
            places.append(y)
            names.append(label)
            left = 0
            parts = {
                colour: run.get(part, 0) for part, colour in PARTS.items()
            }
            if not any(parts.values()):
                parts = {"dimgrey": run["ms per step"]}
            for colour, part in parts.items():
                panel.barh(y, part/stock, left=left, color=colour)
                left += part/stock
            if left > WIDEST:
                panel.text(
                    0.99*WIDEST, y, f"{left:.1f}", fontsize=8, va="center",
                    ha="right",
                )
        y += 1.5
    for part, colour in PARTS.items():
        panel.barh([0], [0], color=colour, label=part.removesuffix(" ms"))
    for goal in (1/3, 0.1):
        panel.axvline(goal, color="black", linestyle=":", linewidth=1)
    panel.set_yticks(places, names, fontsize=7)
    panel.set_ylim(y, -1)
    panel.set_xlim(0, WIDEST)
    panel.set_xlabel("time per step over that of pimpleFoam, one core")
    panel.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(file, dpi=130)
    pyplot.close(figure)
