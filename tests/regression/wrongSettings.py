# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong entries that could be followed in silence, or crash, see wrongEntries."""

from wrongText import BODY, DENSITY, FILE, sensor

# What is wrong: (file, text of the case, text instead, parts of the message)
SETTINGS = {
    "a plane out of that of the mesh": (
        "system/controlDict", "functions\n{", sensor(
            "planes { one { point (0 0 0); normal (1 0 1); } }"
        ),
        ["'normal'", "'one'", "out of the plane", "system/controlDict"],
    ),

    # Braces and semicolons
    "keyword of the bodies": (
        FILE, "bodies\n", "bodys\n",
        ["'bodys'", "nearest valid one is 'bodies'", FILE],
    ),
    **{
        f"{key} in one word": (
            FILE, "bodies\n", f"{key} exponential;\nbodies\n",
            [f"'{key}' is not a sub-dictionary", f"'{key} {{ {inside} }}'",
             FILE],
        )
        for key, inside in {
            "resistance": "type ...;", "coupling": "type ...;",
            "contact": "type ...;", "lubrication": "type ...;",
            "window": "type ...;", "sleep": "type ...;",
            "leaving": "type ...;", "turbulentWalls": "type ...;",
            "injection": "name { ... }",
        }.items()
    },
    "no semicolon": (
        FILE, "density     2;", "density     2",
        ["'density' in 'disc' goes on with 'position'", "no ';'", FILE],
    ),

    # Values that would be accepted otherwise
    "a disc within a cell": (
        FILE, "radius 0.25", "radius 0.04",
        ["'disc' has only 0.8 cells", "at least 4", FILE],
    ),
    "a disc between the cells": (
        FILE, f"radius 0.25; }}\n{DENSITY.splitlines()[1]}\n        {BODY}",
        "radius 0.02; } density 2; position (-0.5 -0.3 0);",
        ["'disc' has only", "at least 4", FILE],
    ),
    "overlap of all of a body": (
        FILE, "bodies\n",
        "contact { type softSphere; largestOverlap 2; }\nbodies\n",
        ["'largestOverlap 2' in 'contact'", "less than 1", FILE],
    ),
    **{
        f"{entry} of {model} contact": (
            FILE, "bodies\n",
            f"contact {{ type {model}; {entry} }}\nbodies\n",
            [*parts, FILE],
        )
        for model in ("inelastic", "viscous")
        for entry, parts in (
            (
                "restitution 0.5;",
                ["'restitution' in 'contact'", "maxIter largestOverlap"],
            ),
            ("tolerence 1e-9;", ["nearest valid one is 'tolerance'"]),
            ("tolerance 1;", ["'tolerance 1'", "less than 1"]),
            ("maxIter 0;", ["'maxIter 0'", "must be greater than 0"]),
            ("maxIter 1.5;", ["contact.maxIter", "expected label"]),
            ("largestOverlap 1.5;", ["'largestOverlap 1.5'", "less than 1"]),
        )
    },
    **{
        f"lubrication beside {model} contact": (
            FILE, "bodies\n", f"contact {{ type {model}; }}"
            " lubrication { type leadingOrder; nu 1; }\nbodies\n",
            ["'lubrication' of the type 'leadingOrder'", "softSphere",
             f"'contact' has the type '{model}'", "type none", FILE],
        )
        for model in ("inelastic", "viscous")
    },
    "reinjection outside": (
        FILE, "bodies\n", "leaving { outlet { type reinject;"
        " position (50 0 0); } }\nbodies\n",
        ["'position (50 0 0)' of 'type reinject'", "(3 1 0.05)", FILE],
    ),
    "reinjection beyond": (
        FILE, "bodies\n", "leaving { outlet { type reinject;"
        " shift (-50 0 0); } }\nbodies\n",
        ["'shift (-50 0 0)' of 'type reinject'", FILE],
    ),
    "an axis of no length": (
        FILE, BODY,
        BODY + " orientation { type axisAngle; axis (0 0 0); angle 20; }",
        ["'axis' in 'orientation'", "not be zero", FILE],
    ),
    "half an iteration": (
        FILE, "bodies\n", "coupling { nOuterCorrectors 1.5; }\nbodies\n",
        ["nOuterCorrectors", FILE],
    ),
    "a radius beyond all bounds": (
        FILE, "radius 0.25", "radius 1e300",
        ["Numbers overflow", "before the first time step"],
    ),

    "coefficients of a wall": (
        FILE, "bodies\n", "contact { type softSphere;"
        " walls { walls { friction 0.1; } } }\nbodies\n",
        ["'walls' in 'walls' must be the name of a material", "'pairs'", FILE],
    ),
    "material of a wall without any": (
        FILE, "bodies\n", "contact { type softSphere;"
        " walls { walls glass; } }\nbodies\n",
        ["'material glass'", "'pairs' or 'materials' of 'contact'", FILE],
    ),
    "no viscosity": (
        "constant/transportProperties", "0.5;", "0;",
        ["'nu'", "is 0 and must be greater than 0",
         "constant/transportProperties"],
    ),
    "negative viscosity": (
        "constant/transportProperties", "0.5;", "-0.1;",
        ["is -0.1 and must be greater than 0", "constant/transportProperties"],
    ),
    "settings of the last pressure correction": (
        "system/fvSolution", '"(p|pFinal)"', "p", ["pFinal", "fvSolution"],
    ),
    "relaxed momentum equation": (
        "system/fvSolution", "PIMPLE",
        'relaxationFactors { equations { "U.*" 0.7; } }\nPIMPLE',
        ["'UFinal' is 0.7 and must be 1", "system/fvSolution"],
    ),
    **{
        f"{key} {value}": (
            "system/controlDict", "deltaT          0.02;",
            f"deltaT 0.02; {key} {value};",
            [f"'{key} {value}' must be greater than 0", "system/controlDict"],
        )
        for key, value in (
            ("deltaT", 0), ("deltaT", -1), ("maxCo", 0), ("maxDeltaT", -1),
        )
    },
}
