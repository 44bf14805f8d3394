# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong entries of the case tube, and what the message about them says."""

FILE = "constant/immersedBodyProperties"
BODY = "position    (-0.53 -0.3 0);"
RHO = "rho             1;\n\nbodies\n{\n    disc\n    {\n"
DENSITY = (
    "        shape       { type disc; radius 0.25; }\n        density     2;\n"
)


def injector(entries):
    """Text with an injector, and what it has to come before."""
    return (
        "injection { seeds { shape { type disc; radius 0.2; }"
        f" densityRatio 2; {entries} }} }}\nbodies\n"
    )


def sensor(entries):
    """Text with a sensor, and what it has to come before."""
    return (
        "functions\n{ sensor { type opticalSensor;"
        f" libs (immersedBodyFunctionObjects); {entries} }}"
    )


# What is wrong: (file, text of the case, text instead, parts of the message)
WRONG = {
    # Keywords
    "keyword that is required": (
        FILE, "bodies\n",
        "contact { type softSphere; law Hertz; youngModulus 1e7;"
        " poissonRatio 0.3; }\nbodies\n",
        [
            "'contact' has no entry 'youngsModulus'",
            "nearest there is 'youngModulus'", FILE,
        ],
    ),
    "keyword": (
        FILE, "rho  ", "roh  ",
        ["'roh'", "nearest valid one is 'rho'", "Valid keywords", FILE],
    ),
    "keyword of a body": (
        FILE, "density ", "desnity ",
        ["'desnity'", "'density'", "'disc'", "constraints", FILE],
    ),
    "keyword of a shape": (
        FILE, "radius", "raduis 0.25; radius",
        ["'raduis'", "nearest valid one is 'radius'", FILE],
    ),
    "keyword of the coupling": (
        FILE, "bodies\n", "coupling { tolerence 1e-4; }\nbodies\n",
        ["'tolerence'", "nearest valid one is 'tolerance'",
         "nOuterCorrectors", "'coupling'", FILE],
    ),
    "keyword of the resistance": (
        FILE, "bodies\n", "resistance { steepnes 1; }\nbodies\n",
        ["'steepnes'", "nearest valid one is 'steepness'", "'resistance'",
         FILE],
    ),
    "keyword of the constraints": (
        FILE, BODY, BODY + " constraints { translation (1 0 0); }",
        ["'translation'", "nearest valid one is 'translate'", "rotate", FILE],
    ),

    # Types
    "type of shape": (
        FILE, "type disc", "type disk",
        ["'type disk'", "nearest valid one is 'disc'", "sphere", FILE],
    ),
    "no type of shape": (FILE, "type disc;", "", ["'type'", FILE]),
    "type of resistance": (
        FILE, "bodies\n", "resistance { type exponent; }\nbodies\n",
        ["'type exponent'", "nearest valid one is 'exponential'",
         "distanceWeighted", FILE],
    ),
    "type of contact": (
        FILE, "bodies\n", "contact { type softSpheres; }\nbodies\n",
        ["'type softSpheres'", "none", "contact", FILE],
    ),
    "type of lubrication": (
        FILE, "bodies\n", "lubrication { type leading; }\nbodies\n",
        ["'type leading'", "leadingOrder", "lubrication", FILE],
    ),
    "lubrication without contact": (
        FILE, "bodies\n",
        "lubrication { type leadingOrder; nu 1; }\nbodies\n",
        ["'lubrication'", "leadingOrder", "needs 'contact'"],
    ),
    "sphere in 2D": (
        FILE, "type disc", "type sphere",
        ["'type sphere'", "use 'disc'", FILE],
    ),

    # Values
    "negative radius": (
        FILE, "radius 0.25", "radius -0.25",
        ["'radius -0.25'", "greater than 0", FILE],
    ),
    "no radius": (FILE, "radius 0.25;", "", ["'radius'", FILE]),
    "negative rho": (
        FILE, "rho             1", "rho -1",
        ["'rho -1'", "greater than 0", FILE],
    ),
    "density without rho": (
        FILE, "rho             1;", "",
        ["'density'", "set 'rho'", "densityRatio", FILE],
    ),
    "no density": (
        FILE, "density     2;", "",
        ["'disc'", "one of 'density' and 'densityRatio'", FILE],
    ),
    "steepness": (
        FILE, "bodies\n", "resistance { steepness 2; }\nbodies\n",
        ["'steepness'", "'auto' or a number from 1 to 1.2", FILE],
    ),
    "zero iterations": (
        FILE, "bodies\n", "coupling { nOuterCorrectors 0; }\nbodies\n",
        ["'nOuterCorrectors 0'", "greater than 0", FILE],
    ),
    "more iterations at least than at most": (
        FILE, "bodies\n",
        "coupling { nOuterCorrectors 3; minOuterCorrectors 5; }\nbodies\n",
        ["'minOuterCorrectors 5' in 'coupling'", "'nOuterCorrectors', 3",
         FILE],
    ),
    "velocity": (
        FILE, "velocity    ambient", "velocity (1 0 0.1)",
        ["'velocity'", "'disc'", "out of the plane", FILE],
    ),

    # Orientation
    "orientation out of the plane": (
        FILE, BODY,
        BODY + " orientation { type axisAngle; axis (0 1 0); angle 20; }",
        ["'orientation' in 'disc'", "out of the plane", "(0 0 1)", FILE],
    ),
    "type of orientation": (
        FILE, BODY, BODY + " orientation { type axisangle; }",
        ["'type axisangle'", "nearest valid one is 'axisAngle'", FILE],
    ),
    "keyword of orientation": (
        FILE, BODY,
        BODY + " orientation { type axisAngle; axes (0 0 1); angle 20; }",
        ["'axes'", "nearest valid one is 'axis'", "'orientation'", FILE],
    ),
    "orientation in one word": (
        FILE, BODY, BODY + " orientation turned;",
        ["'orientation' in 'disc'", "'random'", "axisAngle", FILE],
    ),
    "random orientation without a seed": (
        FILE, BODY, BODY + " orientation random;", ["seed", FILE],
    ),

    # Steady state
    "keyword of steady": (
        FILE, "bodies\n", "steady { tolerence 1e-4; }\nbodies\n",
        ["'tolerence'", "nearest valid one is 'tolerance'", "'steady'", FILE],
    ),
    "steady in one word": (
        FILE, "bodies\n", "steady yes;\nbodies\n",
        ["'steady'", "not a sub-dictionary", FILE],
    ),
    "zero tolerance": (
        FILE, "bodies\n", "steady { tolerance 0; }\nbodies\n",
        ["'tolerance 0'", "greater than 0", FILE],
    ),
    "steady state of a body that crosses the mesh": (
        FILE, "bodies\n", "steady {}\nbodies\n",
        ["'steady'", "'disc'", "'motion { type fixed; }' for all",
         "'window { type comoving; ... }'", FILE],
    ),

    # Motion
    "type of motion": (
        FILE, BODY, BODY + " motion { type towed; }",
        ["'type towed'", "free fixed prescribed", "'motion'", FILE],
    ),
    "motion in one word": (
        FILE, BODY, BODY + " motion fixed;",
        ["'motion'", "not a sub-dictionary", FILE],
    ),
    "prescribed motion without a velocity": (
        FILE, "velocity    ambient;", "motion { type prescribed; }",
        ["'type prescribed'", "needs 'velocity'", "'type fixed'", FILE],
    ),
    "velocity of a fixed body": (
        FILE, BODY, BODY + " motion { type fixed; }",
        ["'velocity'", "'disc'", "'motion { type free; }'", "'type fixed'",
         FILE],
    ),
    "prescribed velocity out of the plane": (
        FILE, "velocity    ambient;",
        "motion { type prescribed; velocity (1 0 0.1); }",
        ["'velocity'", "(1 0 0.1) at time 0", "out of the plane",
         "allowed is (x y 0)", FILE],
    ),
    "prescribed spin out of the plane, later": (
        FILE, "velocity    ambient;",
        "motion { type prescribed;"
        " angularVelocity table ((0 (0 0 0)) (1 (1 0 0))); }",
        ["'angularVelocity'", "at time 0.02", "allowed is (0 0 z)", FILE],
    ),
    "type of function": (
        FILE, "velocity    ambient;",
        "motion { type prescribed; velocity sinus; }",
        ["sinus", "sine", FILE],
    ),
    "exponents": (
        FILE, "type disc; radius 0.25;",
        "type superellipse; semiAxes (0.25 0.25); exponent 1.5;",
        ["'exponent'", "from 2 (round) to 100", FILE],
    ),

    "constraints of half of a prescribed motion": (
        FILE, "velocity    ambient;",
        "motion { type prescribed; velocity (1 0 0); }"
        " constraints { translate (0 1 0); }",
        ["'rotate'", FILE],
    ),
    "prescribed velocity of a free component": (
        FILE, "velocity    ambient;",
        "motion { type prescribed; velocity (1 1 0); }"
        " constraints { translate (0 1 0); rotate (0 0 0); }",
        ["'velocity' in 'motion' is (1 1 0) at time 0", "'constraints'",
         "allowed is (x 0 0)", FILE],
    ),

    # Restraints
    "type of a restraint": (
        FILE, BODY, BODY + " restraints { one { type spring; } }",
        ["'type spring' in 'one'", "externalForce linearSpring", FILE],
    ),
    "keyword of a restraint": (
        FILE, BODY,
        BODY + " restraints { one { type linearSpring; stifness (1 1 1); } }",
        ["'stifness' in 'one'", "nearest valid one is 'stiffness'", FILE],
    ),
    "restraints without rho": (
        FILE, f"{RHO}{DENSITY}", f"{RHO}{DENSITY}".replace(
            "rho             1;", ""
        ).replace("density     2;", "densityRatio 2; restraints {"
                  " one { type linearSpring; damping (1 1 1); } }"),
        ["'restraints' in 'disc'", "set 'rho'", FILE],
    ),
    "force out of the plane, later": (
        FILE, BODY, BODY + " restraints { one { type externalForce;"
        " force table ((0 (0 0 0)) (1 (0 0 1))); } }",
        ["'force' in 'one'", "at time 0.02", "allowed is (x y 0)", FILE],
    ),

    # The window
    "window without a direction": (
        FILE, "bodies\n", "window { type comoving; }\nbodies\n",
        ["'window'", "one of 'direction' and 'directions'", FILE],
    ),
    "window across the walls": (
        FILE, "bodies\n",
        "window { type comoving; directions ((1 0 0) (0 1 0)); }\nbodies\n",
        ["'direction (0 1 0)'", "not parallel to the wall 'walls'", FILE],
    ),

    # Places
    "no position": (
        FILE, BODY, "",
        ["'disc'", "exactly one of", "positionsFile", FILE],
    ),
    "position outside": (
        FILE, BODY, "position (5 0 0);",
        ["'position (5 0 0)'", "'disc'", "outside the mesh", "(3 1 0.05)",
         FILE],
    ),
    "overlap": (
        FILE, BODY, "positions ((-0.5 0 0) (-0.1 0 0));",
        ["overlap", "disc1 and disc2", FILE],
    ),
    "overlap with a wall": (
        FILE, BODY, "position (0 0.8 0);",
        ["overlap", "disc and a wall", FILE],
    ),
    "file of positions": (
        FILE, BODY, 'positionsFile "constant/grains";',
        ["'positionsFile'", "constant/grains", FILE],
    ),

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
    "leaving in one word": (
        FILE, "bodies\n", "leaving { outlet remove; }\nbodies\n",
        ["'outlet' in 'leaving'", "'{ type remove; }'", FILE],
    ),
    "reinjection without a place": (
        FILE, "bodies\n", "leaving { outlet { type reinject; } }\nbodies\n",
        ["'type reinject' in 'outlet'", "'shift' and 'position'", FILE],
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
        ["nOuterCorrectors", "expected label", FILE],
    ),
    "a radius beyond all bounds": (
        FILE, "radius 0.25", "radius 1e300",
        ["Numbers overflow", "before the first time step"],
    ),

    # Other dictionaries
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
    "steady state": (
        "system/fvSchemes", "backward", "steadyState",
        ["ddt(U)", "steadyState", "Euler", "backward", "system/fvSchemes"],
    ),
    "Crank-Nicolson": (
        "system/fvSchemes", "backward", "CrankNicolson 0.9",
        ["ddt(U)", "CrankNicolson", "Euler", "backward", "system/fvSchemes"],
    ),
    "solver": (
        "system/controlDict", "immersedFluid", "immersedfluid",
        ["immersedfluid", "immersedFluid", "incompressibleFluid",
         "system/controlDict"],
    ),
}
