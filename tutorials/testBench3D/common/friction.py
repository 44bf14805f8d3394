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
    """Pressure gradients over density [m/s2] of a log of foamRun, one per step,
    after the last pressure correction of meanVelocityForce."""
    found = {}
    for time, block in re.findall(r"\nTime = (\S+)\n(.*?)ExecutionTime", log,
                                  re.DOTALL):
        values = re.findall(r"pressure gradient = (\S+)", block)
        if values:
            found[float(time)] = float(values[-1])
    return found


def periodicFriction(case="."):
    """Re and f of a run with meanVelocityForce, at its end."""
    values = benchValues(case)
    U, D = values["meanVelocity"], values["diameter"]
    log = (pathlib.Path(case)/"log.foamRun").read_text()
    gradient = [*gradients(log).values()][-1]
    return U*D/values["nu"], 2*D*gradient/U**2, values["Ks"]/D


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
