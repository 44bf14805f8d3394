# SPDX-License-Identifier: GPL-3.0-or-later
"""Text of the case tube that wrong entries take the place of."""

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
