# SPDX-License-Identifier: GPL-3.0-or-later
"""A tube whose ends are driven by traction, with cells that are small at the
ends and the walls: where they meet the traction is singular.

    core = around(0, 4*RADIUS, h), around(y, 4*RADIUS, h)
    case = EndCase(folder, "name", h, core, h_end=0.02, force=0.5)
    case.bodies(...)
    case.solve()
    case.flow_rate()
"""

from bodyCase import BodyCase
from boxMesh import coarsen

HALF_LENGTH = 3
NU = 0.5

HEADER = """FoamFile
{
    version     2.0;
    format      ascii;
    class       vol%sField;
    object      %s;
}

dimensions      [0 %d -%d 0 0 0 0];
"""
WALLS = {"U": "noSlip", "p": "zeroGradient"}


def stretch(length, h, h_end, growth):
    """Sections from cells of size h to such of size h_end; none if there is
    no length."""
    if length < 1e-9*h:
        return []
    first = coarsen(0.5*length, h, growth)
    last = coarsen(0.5*length, h_end, growth)
    return [first, (last[0], last[1], 1/last[2])]


def direction(half, core, h, h_end, growth):
    """From -half to half, equal cells in the core, small ones at the ends."""
    right = stretch(half - core[1], h, h_end, growth)
    left = stretch(core[0] + half, h, h_end, growth)
    left = [(length, n, 1/ratio) for length, n, ratio in reversed(left)]
    cells = round((core[1] - core[0])/h)
    return [-half, *left, (core[1] - core[0], cells, 1), *right]


class EndCase(BodyCase):
    """Force in viscous units, over nu."""

    def __init__(self, folder, name, h, core, h_end, force, growth=1.06,
                 half_length=HALF_LENGTH, **conditions):
        super().__init__("tube", folder, name)
        self.controls(writeFormat="ascii", writePrecision="12")
        # Nearly the flow that comes out
        self.replace(
            "system/setExprFieldsDict", "1.5*",
            f"{force/(4*half_length):.8g}*",
        )
        self.cells = self.mesh(
            direction(half_length, core[0], h, h_end, growth),
            direction(1, core[1], h, h_end, growth),
        )
        self.conditions(force, **conditions)

    def conditions(self, force, tangential="free", more=""):
        """Set the conditions of U and p; force: a number or an entry."""
        if not isinstance(force, str):
            force = f"({NU*force:.12g} 0 0)"
        traction = "type fixedTractionVelocity; traction {}; " \
            f"tangentialVelocity {tangential}; {more}"
        ends = {
            "U": (traction.format(force), traction.format("(0 0 0)")),
            "p": 2*("type fixedTractionPressure;",),
        }
        for field, (inlet, outlet) in ends.items():
            path = self.path / "0" / field
            text = path.read_text()
            begin = text.index("internalField")
            internal = text[begin:text.index("boundaryField")]
            header = HEADER % (
                ("Vector", field, 1, 1) if field == "U"
                else ("Scalar", field, 2, 2)
            )
            path.write_text(f"""{header}{internal}
boundaryField
{{
    inlet   {{ {inlet} }}
    outlet  {{ {outlet} }}
    walls   {{ type {WALLS[field]}; }}
    frontAndBack {{ type empty; }}
}}
""")

    def flow_rate(self, window=0.0):
        """Flow rate per depth; of a window that moves at this speed."""
        self.run("postProcess", "-latestTime", "-func",
                 "flowRatePatch(name=outlet)")
        file = max(self.path.glob("postProcessing/flowRatePatch*/*/*.dat"))
        return float(file.read_text().split()[-1])/0.1 + 2*window
