# SPDX-License-Identifier: GPL-3.0-or-later
"""Steps of one rank beside stock pimpleFoam's, with their parts."""

from pathlib import Path

FILE = Path(__file__).resolve().parent.parent/"results/cost.png"
PARTS = ("momentum", "pressure", "bodies", "other")
COLOURS = ("tab:blue", "tab:green", "tab:red", "lightgrey")
LINE = 0.21                 # inches per run


def label(run):
    """What a run was, without the mesh and its number of ranks."""
    settings = ", ".join(run.settings.split(", ")[1:])
    return f"{run.solver['solver']}, {settings}"


def draw(shown):
    """Write the figure; shown: runs, each with that of pimpleFoam."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    shown = [pair for pair in shown if "ranks" not in pair[0].settings]
    lines, names, at = [], [], 0
    meshes = {}
    for run, stock in shown:
        mesh = run.settings.split(", ")[0]
        if mesh not in meshes:
            at += 1.5
            meshes[mesh] = at
        names.append(label(run))
        lines.append((at, run, stock))
        at += 1

    figure, panel = pyplot.subplots(figsize=(9, LINE*at + 1))
    for y, run, stock in lines:
        if run is stock:
            panel.barh(y, 1, color="dimgrey")
            continue
        left = 0
        parts = (*run.parts, run.step - sum(run.parts))
        for part, colour in zip(parts, COLOURS):
            panel.barh(y, part/stock.step, left=left, color=colour)
            left += part/stock.step
    for name, colour in zip(PARTS, COLOURS):
        panel.barh([0], [0], color=colour, label=name)
    for mesh, y in meshes.items():
        panel.text(0, y - 0.7, mesh, fontsize=8, weight="bold")
    for goal in (1/3, 0.1):
        panel.axvline(goal, color="black", linestyle=":", linewidth=1)
    panel.set_yticks([y for y, _, _ in lines], names, fontsize=7)
    panel.set_ylim(at, 0)
    panel.set_xlabel("time per step over that of pimpleFoam, one core")
    panel.legend(fontsize=8)
    figure.tight_layout()
    FILE.parent.mkdir(exist_ok=True)
    figure.savefig(FILE, dpi=130)
    pyplot.close(figure)
