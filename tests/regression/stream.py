# SPDX-License-Identifier: GPL-3.0-or-later
"""Conditions of a box with a stream along x, or a body that moves against it:
inlet, outlet, and sides that slip."""

P = """
    inlet   { type zeroGradient; }
    outlet  { type fixedValue; value uniform 0; }
    sides   { type slip; }
"""


def velocity(speed):
    """Those of U; the speed at the inlet."""
    return f"""
    inlet   {{ type fixedValue; value uniform ({speed} 0 0); }}
    outlet  {{ type zeroGradient; }}
    sides   {{ type slip; }}
"""
