# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong entries of how bodies move and are held, see wrongEntries."""

from wrongText import BODY, DENSITY, FILE, RHO

# What is wrong: (file, text of the case, text instead, parts of the message)
MOTIONS = {
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
}
