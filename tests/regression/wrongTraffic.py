# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong entries of bodies that leave and enter, and of what watches them, see
wrongEntries."""

from wrongText import FILE, injector, sensor

# What is wrong: (file, text of the case, text instead, parts of the message)
TRAFFIC = {
    # Leaving and entering
    "patch that is a wall": (
        FILE, "bodies\n", "leaving { walls { type remove; } }\nbodies\n",
        ["'walls' in 'leaving'", "Valid keywords: default inlet outlet",
         FILE],
    ),
    "patch": (
        FILE, "bodies\n", "leaving { outlett { type remove; } }\nbodies\n",
        ["'outlett'", "nearest valid one is 'outlet'", FILE],
    ),
    "patches that no patch matches": (
        FILE, "bodies\n", 'leaving { "out_.*" { type remove; } }\nbodies\n',
        ['"out_.*"', "matches no patch", "(default inlet outlet)", FILE],
    ),
    "type of leaving": (
        FILE, "bodies\n", "leaving { outlet { type delete; } }\nbodies\n",
        ["'type delete' in 'outlet'", "stop remove hold reinject", FILE],
    ),
    "way of leaving in one word": (
        FILE, "bodies\n", "leaving { outlet remove; }\nbodies\n",
        ["'outlet' in 'leaving'", "'{ type remove; }'", FILE],
    ),
    "reinjection without a place": (
        FILE, "bodies\n", "leaving { outlet { type reinject; } }\nbodies\n",
        ["'type reinject' in 'outlet'", "'shift' and 'position'", FILE],
    ),
    "coupling of an injector in two dimensions": (
        FILE, "bodies\n",
        injector("position (0 0 0); rate 1; coupling unresolved;"),
        ["'coupling unresolved' in 'seeds'", "two dimensions", FILE],
    ),
    "injector without times": (
        FILE, "bodies\n", injector("position (0 0 0);"),
        ["'seeds'", "exactly one of 'rate', 'roller', 'times'", FILE],
    ),
    "keyword of an injector": (
        FILE, "bodies\n", injector("position (0 0 0); rate 1; ends 2;"),
        ["'ends' in 'seeds'", "nearest valid one is 'end'", FILE],
    ),
    "random injection without a seed": (
        FILE, "bodies\n",
        injector("position (0 0 0); rate 1; intervals random;"),
        ["seed", FILE],
    ),
    "injector without a place": (
        FILE, "bodies\n", injector("rate 1;"),
        ["'seeds' needs exactly one of", "positions region patch", FILE],
    ),
    "patch of an injector": (
        FILE, "bodies\n", injector("rate 1; patch { name inled; } seed 1;"),
        ["'name inled' in 'patch'", "nearest valid one is 'inlet'", FILE],
    ),
    "distribution": (
        FILE, "bodies\n", injector(
            "rate 1; position (0 0 0); seed 1; size { type unifrm; }"
        ),
        ["unifrm", "uniform", "RosinRammler", FILE],
    ),
    "sizes below zero": (
        FILE, "bodies\n", injector(
            "rate 1; position (0 0 0); seed 1; size { type uniform;"
            " uniformDistribution { minValue 0; maxValue 1; } }"
        ),
        ["'size' in 'seeds'", "greater than 0", FILE],
    ),
    "injector with the name of a body": (
        FILE, "bodies\n{\n    disc",
        injector("rate 1; position (0 0 0);") + "{\n    seeds12",
        ["'seeds'", "'seeds12'", "another name", FILE],
    ),
    "injection and a steady state": (
        FILE, "bodies\n",
        "steady {} " + injector("rate 1; position (0 0 0);"),
        ["'steady'", "remove 'injection'", FILE],
    ),

    "interval of a roller's grains": (
        FILE, "bodies\n", injector(
            "position (0 0 0); intervals random; seed 1;"
            " roller { revolutionsPerSecond 1; cells 10; }"
        ),
        ["'intervals' in 'seeds'", "nearest valid one is", FILE],
    ),
    "keyword of a roller": (
        FILE, "bodies\n", injector(
            "position (0 0 0); roller { revolutionPerSecond 1; cells 10; }"
        ),
        ["'revolutionPerSecond' in 'roller'",
         "nearest valid one is 'revolutionsPerSecond'", FILE],
    ),

    # The sensor
    "keyword of a sensor": (
        "system/controlDict", "functions\n{", sensor("plane {}"),
        ["'plane' in 'sensor'", "nearest valid one is 'planes'",
         "system/controlDict"],
    ),
    "a plane without a normal": (
        "system/controlDict", "functions\n{",
        sensor("planes { one { point (0 0 0); } }"),
        ["'normal'", "system/controlDict"],
    ),
    "a plane in one word": (
        "system/controlDict", "functions\n{", sensor("planes { one (0 0 0); }"),
        ["'one' in 'planes'", "'point' and 'normal'", "system/controlDict"],
    ),
    "a sensor that does not look at each step": (
        "system/controlDict", "functions\n{",
        sensor("executeInterval 2; planes {}"),
        ["'executeInterval' in 'sensor'", "'timeStep' and 1",
         "system/controlDict"],
    ),
    "outlets that are no planes": (
        "system/controlDict", "functions\n{", sensor(
            'outlets ("out.*"); planes { in1 { point (0 0 0);'
            " normal (1 0 0); } }"
        ),
        ["'outlets' in 'sensor'", "(in1)", "system/controlDict"],
    ),
}
