# SPDX-License-Identifier: GPL-3.0-or-later
"""Is a peer there? If not, its rows are left out and one line says so."""

import shutil

REPORTED = set()


def installed(program, solver):
    """Whether the program is on PATH."""
    if shutil.which(program):
        return True
    if solver not in REPORTED:
        print(f"{solver} left out: no {program} on PATH", flush=True)
        REPORTED.add(solver)
    return False
