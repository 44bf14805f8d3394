# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong entries of the averages of fluid and bodies, see wrongEntries."""


def averages(name, entries):
    """Text with a function object, and what it has to come before."""
    return (
        f"functions\n{{ averages {{ type {name};"
        f" libs (immersedBodyFunctionObjects); {entries} }}"
    )


# What is wrong: (file, text of the case, text instead, parts of the message)
AVERAGES = {
    what: (
        "system/controlDict", "functions\n{", averages(name, entries),
        [*message, "system/controlDict"],
    )
    for what, (name, entries, message) in {
        "keyword of the stress": (
            "suspensionStress", "shearrate 1;",
            ["'shearrate' in 'averages'", "nearest valid one is 'shearRate'"],
        ),
        "no direction of the flow": (
            "suspensionStress", "flow (0 0 0);",
            ["'flow' in 'averages' must not be zero"],
        ),
        "a gradient along the flow": (
            "suspensionStress", "gradient (2 0.1 0);",
            ["'flow' and 'gradient' in 'averages' must be normal"],
        ),
        "keyword of the averages": (
            "bodyAverages", "layer 10;",
            ["'layer' in 'averages'", "nearest valid one is 'layers'"],
        ),
        "layers of no thickness": (
            "bodyAverages", "layers 0.5;",
            ["'layers' not less than 1"],
        ),
        "a kernel": (
            "bodyAverages", "kernel { type Gausian; }",
            ["'type Gausian' in 'kernel'", "'Gaussian'"],
        ),
        "keyword of a kernel": (
            "bodyAverages", "kernel { width 2; }",
            ["'width' in 'kernel'", "radius"],
        ),
        "keyword of the closure": (
            "closureFit", "layer 10;",
            ["'layer' in 'averages'", "nearest valid one is 'layers'"],
        ),
        "less than no layers": (
            "closureFit", "layers -1;",
            ["'layers' not less than 0"],
        ),
        "no direction of the slip": (
            "closureFit", "flow (0 0 0);",
            ["'flow' in 'averages' must not be zero"],
        ),
        "time steps left out": (
            "closureFit", "executeInterval 2;",
            ["'executeInterval' in 'averages' must be 'timeStep' and 1"],
        ),
    }.items()
}
