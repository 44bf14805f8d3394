# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that touch each other and walls, in a fluid so light that the closed
forms of a collision hold.

    case = box2d(tmp_path, 20)
    case.bodies(discs([(0, -0.5), (0.1, 0.2)]), contact(e=0.5))
"""

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform

RATIO = 1e4


def contact(e=0.88, mu=0.25, more=""):
    """Entry of the model."""
    return (
        f"contact {{ type softSphere; restitution {e}; friction {mu};"
        f" {more} }}"
    )


def box2d(folder, n, name=None):
    """A square of two by two with walls and n cells along each side."""
    case = BodyCase("box", folder, name)
    sides = {"walls": "x- x+ y- y+"}
    boxMesh.write(case, uniform(-1, 1, n), uniform(-1, 1, n), None, sides)
    for field in ("U", "p"):
        case.replace(
            f"0/{field}", "boundaryField\n{",
            "boundaryField\n{\n    frontAndBack { type empty; }",
        )
    case.gravity()
    case.run("blockMesh")
    return case


def discs(positions, radius=0.25, velocities=None, ratio=RATIO):
    """Entries of discs, by their positions in the plane."""
    return "\n".join(
        f"disc{i} {{ shape {{ type disc; radius {radius}; }}"
        f" densityRatio {ratio}; position ({x} {y} 0);"
        f" velocity ({u} {v} 0); }}"
        for i, ((x, y), (u, v)) in enumerate(zip(
            positions, velocities or [(0, 0)]*len(positions), strict=True
        ))
    )


def conditions(case, velocities):
    """Boundary conditions of closed walls, by patch."""
    empty = {
        patch: text for patch, text in velocities.items() if "empty" in text
    }
    for field, by_patch in (
        ("U", velocities), ("p", {".*": "type zeroGradient;", **empty}),
    ):
        path = case.path/"0"/field
        head = path.read_text().split("boundaryField", 1)[0]
        entries = "".join(
            f'"{patch}" {{ {text} }}\n' for patch, text in by_patch.items()
        )
        path.write_text(f"{head}boundaryField\n{{\n{entries}}}\n")
