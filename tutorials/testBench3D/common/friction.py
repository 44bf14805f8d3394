# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction factors of round tubes, of Darcy: -dp/dx = f/D rho U^2/2.

As a script, in the folder of a periodic tube that has been run: prints f beside
those of the formulas.
"""

import math
import pathlib
import re


def blasius(Re):
    """H. Blasius (1913): smooth, Re from 3000 to 1e5."""
    return 0.3164/Re**0.25


def colebrook(Re, roughness=0.0):
    """C. F. Colebrook (1939): roughness Ks/D; 0: smooth (Prandtl)."""
    f = 0.02
    for _ in range(50):
        f = (-2*math.log10(roughness/3.7 + 2.51/(Re*math.sqrt(f))))**-2
    return f


def benchValues(case="."):
    """The numbers of constant/benchValues."""
    text = (pathlib.Path(case)/"constant/benchValues").read_text()
    return {name: float(value) for name, value in
            re.findall(r"^(\w+)\s+([-+.\de]+);", text, re.MULTILINE)}


def gradients(log):
    """Pressure gradient over density [m/s2] of each time step of a log of
    foamRun, after the last pressure correction of meanVelocityForce."""
    steps = re.split(r"\nTime = ", log)[1:]
    found = (re.findall(r"pressure gradient = (\S+)", step) for step in steps)
    return [float(values[-1]) for values in found if values]


def periodicFriction(case=".", part=0.0):
    """Re, f and Ks/D of a run with meanVelocityForce: at its end, or the mean
    of its last part."""
    values = benchValues(case)
    U, D = values["meanVelocity"], values["diameter"]
    all_ = gradients((pathlib.Path(case)/"log.foamRun").read_text())
    late = all_[min(len(all_) - 1, round((1 - part)*len(all_))):]
    f = 2*D*sum(late)/len(late)/U**2
    return U*D/values["nu"], f, values["Ks"]/D


def report(Re, f, roughness):
    """One line for the user."""
    parts = [f"Re {Re:.0f}: friction factor {f:.5f}"]
    if roughness == 0:
        parts.append(f"Blasius {blasius(Re):.5f} ({f/blasius(Re) - 1:+.1%})")
    name = f"Colebrook, Ks/D {roughness:.3g}," if roughness else "Colebrook"
    reference = colebrook(Re, roughness)
    parts.append(f"{name} {reference:.5f} ({f/reference - 1:+.1%})")
    return "; ".join(parts)


if __name__ == "__main__":
    print(report(*periodicFriction()))
