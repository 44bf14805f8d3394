# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs in one go and in two parts."""

from bodyCase import BodyCase


def check_exact(case, folder, half, end):
    """Run the case to `end` at once, and a copy in two parts: all that is
    written is the same, to the last bit."""
    # The sums of fastPoisson may differ in the last bit from run to run
    case.replace("system/fvSolution", "fastPoisson", "PCG; preconditioner DIC")
    parts = BodyCase(case, folder, "parts")
    case.controls(endTime=end)
    case.solve()
    for time in (half, end):
        parts.controls(endTime=time)
        parts.solve()

    for name in ("U", "p", "uniform/immersedBodies"):
        a, b = (
            (one.path/one.latest_time()/name).read_bytes()
            for one in (case, parts)
        )
        assert a == b, name
