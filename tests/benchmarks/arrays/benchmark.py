# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag of periodic arrays of discs and spheres, Stokes flow."""

import math

from measure import DEPTH, LOCKED, Run, set_stokes, set_viscosity
from periodicBox import periodic_case, superficial_speed

# Centres in a cell of side 1, distance between neighbours, and for each solid
# fraction F/(mu U) of a disc, F/(6 pi mu a U) of a sphere
ARRAYS = {
    "square": (((0, 0),), 1, {
        0.05: 15.5578223, 0.2: 51.526949, 0.4: 217.894315, 0.6: 1763.57311,
    }),
    "simple": (((0, 0, 0),), 1, {
        0.064: 2.810198, 0.216: 7.441954, 0.45: 28.08732,
    }),
    "body-centred": (((0, 0, 0), (0.5, 0.5, 0.5)), math.sqrt(0.75), {
        0.064: 2.889385, 0.216: 7.738778, 0.4: 23.1093,
    }),
    "face-centred": (
        ((0, 0, 0), (0.5, 0.5, 0), (0.5, 0, 0.5), (0, 0.5, 0.5)),
        math.sqrt(0.5),
        {
            0.064: 2.888753, 0.216: 7.757677, 0.367: 19.33978,
            0.486: 43.26502, 0.592: 100.4014,
        },
    ),
}
# Of the array from the mesh, in cells
OFFSET = (0.3, 0.4, 0.2)
# Driven by a body force, too
BY_FORCE = (("square", 0.2), ("simple", 0.216))
# Time step in h^2/nu, and their number
STEP, STEPS = 50, 200


class Array:
    """An array on a mesh of about D/h cells per diameter."""

    def __init__(self, lattice, fraction, cells):
        self.centres, self.distance, drags = ARRAYS[lattice]
        self.lattice, self.fraction = lattice, fraction
        self.reference = drags[fraction]
        self.dims = len(self.centres[0])
        volume = fraction/len(self.centres)
        self.radius = (
            math.sqrt(volume/math.pi) if self.dims == 2
            else (3*volume/(4*math.pi))**(1/3)
        )
        self.n = round(cells/(2*self.radius))
        self.h = 1/self.n
        self.D_over_h = round(2*self.radius*self.n, 2)
        self.gap = (self.distance - 2*self.radius)*self.n

    def positions(self):
        """Centres, in the form of OpenFOAM's lists."""
        for centre in self.centres:
            x = [x + s*self.h for x, s in zip(centre, OFFSET)]
            yield "({:.12g} {:.12g} {:.12g})".format(*(*x, 0)[:3])

    def solve(self, folder, by_force):
        """The run, and the drag after each step."""
        # The gradient makes a superficial speed of about 1, where it starts
        scale = 1
        if self.dims == 3:
            scale = 6*math.pi*self.radius*len(self.centres)
        gradient = self.reference*scale
        settings = f"{self.lattice} {self.fraction}"
        settings += " body force" if by_force else ""
        case = periodic_case(
            folder, f"{settings.replace(' ', '_')}_n{self.n}", self.n,
            self.dims, gradient, by_force,
        )
        set_stokes(case)
        set_viscosity(case, 1)
        case.bodies(f"""
            body
            {{
                shape
                {{
                    type {"disc" if self.dims == 2 else "sphere"};
                    radius {self.radius:.15g};
                }}
                positions ({" ".join(self.positions())});
                {LOCKED}
            }}
        """)
        dt = STEP*self.h**2
        case.controls(endTime=f"{STEPS*dt:.12g}", deltaT=f"{dt:.12g}")
        run = Run(case, settings, self.D_over_h, self.n**self.dims)
        speed = superficial_speed(case, DEPTH if self.dims == 2 else 1)
        return run, gradient/scale/speed


def permeability(fraction, drag):
    """Over the radius of spheres squared, of their F/(6 pi mu a U)."""
    return 2/(9*fraction*drag)


def carman_kozeny(fraction):
    """The same for granular beds."""
    return (1 - fraction)**3/(45*fraction**2)


def sizes(lattice, quick):
    """Cells per diameter."""
    if lattice == "square":
        return (8, 16) if quick else (8, 16, 32)
    return (8, 12) if quick else (8, 12, 16, 24)


def figures(array, folder, by_force=False):
    """Rows of one array."""
    run, drag = array.solve(folder, by_force)
    name = "F/(mu U)" if array.dims == 2 else "F/(6 pi mu a U)"
    yield run.row(name, drag[-1], array.reference)
    # What is left falls as one over the number of steps
    limit = 2*drag[-1] - drag[len(drag)//2 - 1]
    yield run.row("the same, any steps", limit, array.reference)
    if array.lattice == "face-centred":
        yield run.row(
            "k/a^2", permeability(array.fraction, drag[-1]),
            permeability(array.fraction, array.reference),
        )
        yield run.row(
            "k/a^2, Carman-Kozeny", carman_kozeny(array.fraction)
        )
    yield run.row("gap/h", array.gap)
    last = abs(drag[3*len(drag)//4:]/drag[-1] - 1).max()
    yield run.row("last change, %", 100*last)


def rows(folder, quick):
    most = 20_000 if quick else 140_000
    for lattice, (_, _, drags) in ARRAYS.items():
        for fraction in drags:
            for cells in sizes(lattice, quick):
                array = Array(lattice, fraction, cells)
                if array.n**array.dims <= most:
                    yield from figures(array, folder)

    for lattice, fraction in BY_FORCE:
        for cells in sizes(lattice, True):
            array = Array(lattice, fraction, cells)
            yield from figures(array, folder, by_force=True)
