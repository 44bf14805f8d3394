# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases for the application stokesModes.

    case = stokes_tube(tmp_path, "one", x, y, [(0, -0.3)])
    table = solve(case, states=[[(0, -0.3)], [(0, 0.2)]])
    table["V_x0"][0]
"""

import boxMesh
from bodyCase import BodyCase
from boxMesh import uniform
from foamCase import FoamError
from grainfoam import tables
from periodicTube import BOUNDARY, SIDES

RADIUS = 0.065

# Mean speed 1 along a periodic tube
DRIVE = "{ direction (1 0 0); meanVelocity 1; }"

HEAD = """FoamFile
{
    version     2.0;
    format      ascii;
    class       dictionary;
    object      stokesModesDict;
}

"""


def discs(places, radius=RADIUS):
    """Entries of bodies, discs at the places."""
    return "\n".join(
        f"disc{i} {{ shape {{ type disc; radius {radius}; }}"
        f" position ({x:.15g} {y:.15g} 0); }}"
        for i, (x, y) in enumerate(places)
    )


def stokes_tube(folder, name, x, y, places, radius=RADIUS):
    """The tube of mean speed 1 between plates at y = -1 and 1."""
    case = BodyCase("tube", folder, name)
    case.mesh(x, y)
    case.bodies(discs(places, radius))
    return case


def periodic_stokes_tube(
    folder, name, cells, places, radius=RADIUS, half_length=3, walls="noSlip"
):
    """The same with cyclic ends, `cells` across, square but for rounding."""
    case = BodyCase("tube", folder, name)
    boxMesh.write(
        case, uniform(-half_length, half_length, round(half_length*cells)),
        uniform(-1, 1, cells), None, SIDES,
    )
    case.set_cyclic("left", "right")
    case.run("blockMesh")
    case.conditions(
        BOUNDARY.format(walls=walls), BOUNDARY.format(walls="zeroGradient")
    )
    case.bodies(discs(places, radius))
    return case


def write_dict(case, states=None, **entries):
    """Write system/stokesModesDict."""
    text = HEAD
    if states is not None:
        rows = " ".join(
            "(" + " ".join(f"({x:.15g} {y:.15g} 0)" for x, y in state) + ")"
            for state in states
        )
        text += f"states ( {rows} );\n"
    for key, value in entries.items():
        text += f"{key} {value};\n"
    (case.path / "system/stokesModesDict").write_text(text)


def table_file(case):
    return case.path / "postProcessing/stokesModes/0/stokesModes.dat"


def table(case):
    """Columns by their names without units."""
    return tables.run_columns(case.path, "stokesModes")


def solve(case, states=None, ranks=1, **entries):
    """The table after a run."""
    write_dict(case, states, **entries)
    if ranks > 1 and not (case.path / "processor0").exists():
        case.decompose(ranks)
    case.run("stokesModes", ranks=ranks)
    return table(case)


def refused(case, *texts):
    """Check that the command ends with an error that has these texts."""
    try:
        case.run("stokesModes")
    except FoamError:
        log = (case.path/"log.stokesModes").read_text()
        assert "FOAM FATAL" in log
        assert [text for text in texts if text not in log] == []
    else:
        raise AssertionError("stokesModes has taken what it should refuse")
