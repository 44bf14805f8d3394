# SPDX-License-Identifier: GPL-3.0-or-later
"""The house: libraries that use those before them, folders without circles."""

import re
from pathlib import Path

import pytest

pytestmark = pytest.mark.fast

SRC = Path(__file__).resolve().parents[2]/"src"

# Each may use those before it, and of the mesh what is said
ORDER = (
    "rigidBodies", "contact", "LeesEdwards", "linearSolvers", "immersion",
    "unresolved", "traffic", "scene", "fusedKernels", "fvPatchFields",
    "flowSolvers", "functionObjects", "seedDrill", "stokesModes",
)
WITHOUT_MESH = ("rigidBodies", "contact")
ON_TOP = ORDER[8:]


def sources():
    return [
        f for f in SRC.rglob("*.[CH]")
        if not {"lnInclude", "Make"} & set(f.parts)
    ]


def includes():
    """Pairs of a folder and one that it includes a header of."""
    folder = {
        f.name: str(f.parent.relative_to(SRC))
        for f in sources() if f.suffix == ".H"
    }
    pairs = set()
    for f in sources():
        own = str(f.parent.relative_to(SRC))
        for name in re.findall(r'#include "([^"]+)"', f.read_text()):
            other = folder.get(Path(name).name)
            if other and other != own:
                pairs.add((own, other))
    return pairs


def circle(pairs):
    """Some folders that include one another in turn; empty if there are none."""
    after = {}
    for one, other in pairs:
        after.setdefault(one, set()).add(other)
    done = set()

    def visit(folder, path):
        if folder in path:
            return [*path[path.index(folder):], folder]
        if folder in done:
            return []
        for other in sorted(after.get(folder, ())):
            found = visit(other, [*path, folder])
            if found:
                return found
        done.add(folder)
        return []

    for folder in sorted(after):
        found = visit(folder, [])
        if found:
            return found
    return []


def test_a_circle_is_found():
    assert circle({("a", "b"), ("b", "c"), ("c", "b")}) == ["b", "c", "b"]
    assert circle({("a", "b"), ("b", "c"), ("a", "c")}) == []


def test_no_folder_includes_itself_by_others():
    assert circle(includes()) == []


def test_libraries_use_those_before_them():
    wrong = []
    for one, other in includes():
        user, used = (x.split("/")[0] for x in (one, other))
        if used == "compat" or user == used:
            continue
        before = ORDER.index(used) < ORDER.index(user)
        # Solvers, conditions and function objects do not use each other, but
        # flow solvers the kernels and what conditions can do,
        # the modes of Stokes flow the latter two as well, and the seed drill
        # what function objects share
        apart = used in ON_TOP and (user, used) not in (
            ("flowSolvers", "fvPatchFields"), ("flowSolvers", "fusedKernels"),
            ("seedDrill", "functionObjects"),
            ("stokesModes", "fusedKernels"), ("stokesModes", "fvPatchFields"),
        )
        if not before or apart:
            wrong.append((one, other))
    assert wrong == []


def test_options_name_what_may_be_included():
    for library in ORDER:
        options = (SRC/library/"Make/options").read_text()
        named = set(re.findall(r"-I\.\./(\w+)/lnInclude", options))
        used = {
            other.split("/")[0] for one, other in includes()
            if one.split("/")[0] == library
        } - {"compat", library}
        assert used <= named, library
        assert all(ORDER.index(n) < ORDER.index(library) for n in named)
        if library in WITHOUT_MESH:
            assert "finiteVolume" not in options
