# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh of a piece with a head by gmsh, for gmshToFoam, in place of makeMesh.py:
tetrahedra and prisms, of the head of bench.ini or of any other.

    gmshMesh.py PIECE [-step FILE [-faces FILE]] [SECTION.NAME=VALUE ...]
    gmshMesh.py PIECE -writeStep FILE [SECTION.NAME=VALUE ...]
    gmshMesh.py PIECE -check [...]

in the folder of a case; PIECE: distributionHead or wholeBench. Writes what
makeMesh.py writes. Needs gmsh and its module for python.

-step FILE      the air in another head, as a solid in a STEP file, in its units
-faces FILE     where its openings are: lines "fanInlet X Y Z", "outlet1 X Y Z",
                ..., the middles of plane faces [m]; without it those of
                distributionHead
-writeStep FILE write the head of bench.ini as a STEP file, and nothing else
-check          only read arguments and parameters
"""

import pathlib
import sys

sys.dont_write_bytecode = True

import gmshHead
from benchParameters import BenchError, known, readBench
from gmshHead import gmsh
from makeMesh import writeCase
from pieces import HEADS, headFlow, headShape


def readFaces(file):
    """{name: place} of a file of openings."""
    found = {}
    for line in pathlib.Path(file).read_text().splitlines():
        words = line.split("#")[0].split()
        if not words:
            continue
        try:
            name, *place = words[0], *map(float, words[1:])
        except ValueError:
            place = []
        if len(place) != 3:
            raise BenchError(f"{file}: '{line}': NAME X Y Z is wanted")
        found[name] = place
    if "fanInlet" not in found or "outlet1" not in found:
        raise BenchError(f"{file}: fanInlet and outlet1 ... are wanted")
    return found


def options(arguments):
    """{option: file} and the changes of parameters."""
    files, changes, words = {}, [], list(arguments)
    while words:
        word = words.pop(0)
        if not word.startswith("-"):
            changes.append(word)
            continue
        known("option", word, ["-step", "-faces", "-writeStep", "-check"])
        if word == "-check":
            files[word] = None
            continue
        if not words:
            raise BenchError(f"{word}: a file is wanted")
        files[word] = words.pop(0)
        if word != "-writeStep" and not pathlib.Path(files[word]).is_file():
            raise BenchError(f"{word}: there is no file '{files[word]}'")
    if "-faces" in files and "-step" not in files:
        raise BenchError("-faces: goes with -step")
    return files, changes


def writeStep(file):
    occ = gmsh.model.occ
    gmshHead.unite(occ.getEntities(3))
    occ.synchronize()
    gmsh.write(str(file))
    print(f"Wrote {file}")


def make(piece, files, changes):
    bench = readBench(changes)
    headShape(bench)
    if "-step" in files:
        openings = readFaces(files["-faces"]) if "-faces" in files \
            else gmshHead.places(bench)
    if "-check" in files:
        return
    if "-step" in files:
        patches = gmshHead.readStep(files["-step"], openings)
    else:
        patches = gmshHead.addHead(bench, piece)
    if "-writeStep" in files:
        writeStep(files["-writeStep"])
        return
    gmsh.model.occ.synchronize()
    count = gmshHead.write(bench, patches, f"{piece}.msh")
    writeCase(bench, headFlow(
        bench, [name for name in patches if name != "fanInlet"]), changes)
    print(f"Wrote {piece}.msh: {count} cells")


def main():
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    piece = sys.argv[1]
    known("piece", piece, list(HEADS))
    files, changes = options(sys.argv[2:])
    if gmsh is None:
        raise SystemExit(
            "gmshMesh: gmsh is missing: on Debian, etc/setup-debian -gmsh, or"
            " apt-get install python3-gmsh; makeMesh.py does without")
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 2)
    # Of lengths in the model; STEP files have a unit of their own
    gmsh.option.setString("Geometry.OCCTargetUnit", "M")
    try:
        make(piece, files, changes)
    except ValueError as error:
        raise SystemExit(f"gmshMesh: {error}") from None
    finally:
        gmsh.finalize()


if __name__ == "__main__":
    main()
