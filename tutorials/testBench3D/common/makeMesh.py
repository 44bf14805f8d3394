# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh of a piece of the bench, for gmshToFoam, and values for its fields.

    makeMesh.py PIECE [SECTION.NAME=VALUE ...]

in the folder of a case: writes PIECE.msh, constant/benchValues and
system/benchFunctionObjects. Parameters are those of bench.ini, or as given.
"""

import math
import pathlib
import sys

sys.dont_write_bytecode = True

from benchParameters import known, readBench
from drillPiece import drill
from pieces import PIECES
from sampling import functionObjects

PIECES = {**PIECES, "drill": drill}

# Turbulence at the inlet: intensity, length over diameter
INTENSITY, LENGTH = 0.05, 0.07


def values(bench, flow):
    """Entries for the dictionaries of a case, kinematic."""
    U, D = flow["meanVelocity"], flow["diameter"]
    rho = bench["air"]["density"]
    k = 1.5*(INTENSITY*U)**2
    return {
        "meanVelocity": U,                                    # [m/s]
        "diameter": D,                                        # [m]
        "nu": bench["air"]["viscosity"]/rho,                  # [m2/s]
        "rho": rho,                                           # [kg/m3]
        "kInlet": k,                                          # [m2/s2]
        "omegaInlet": math.sqrt(k)/(0.09**0.25*LENGTH*D),     # [1/s]
        "Ks": bench["walls"]["roughness"],                    # [m]
        **flow.get("values", {}),
    }


def wallFunction(bench):
    """For smooth walls one that holds at any distance, and is the more accurate
    in the buffer layer."""
    rough = bench["walls"]["roughness"] > 0
    return "nutkRoughWallFunction" if rough else "nutUSpaldingWallFunction"


def writeValues(bench, flow):
    lines = ["// Written by makeMesh.py from bench.ini; SI units"]
    lines += [f"{name:<16}{value:.10g};"
              for name, value in values(bench, flow).items()]
    lines.append(f"{'nutWall':<16}{wallFunction(bench)};")
    pathlib.Path("constant").mkdir(exist_ok=True)
    pathlib.Path("constant/benchValues").write_text("\n".join(lines) + "\n")


def writeCase(bench, flow, changes):
    """All that a case needs besides its mesh; changes: of bench.ini."""
    writeValues(bench, flow)
    pathlib.Path("constant/benchChanges").write_text(
        "\n".join(changes) + "\n")
    pathlib.Path("system").mkdir(exist_ok=True)
    pathlib.Path("system/benchFunctionObjects").write_text(
        functionObjects(flow))


def main():
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    piece = sys.argv[1]
    known("piece", piece, list(PIECES))
    bench = readBench(sys.argv[2:])
    try:
        mesh, flow = PIECES[piece](bench)
    except ValueError as error:
        raise SystemExit(f"makeMesh: {error}") from None
    count = mesh.write(f"{piece}.msh")
    writeCase(bench, flow, sys.argv[2:])
    print(f"Wrote {piece}.msh: {count} cells")


if __name__ == "__main__":
    main()
