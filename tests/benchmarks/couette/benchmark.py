# SPDX-License-Identifier: GPL-3.0-or-later
"""A disc on the centre line between plates, down to narrow gaps."""

from bodyCase import BodyCase
from boxMesh import graded, uniform
from measure import DEPTH, LOCKED, Run, around, set_profile, set_stokes

# Radius over half the gap of the plates: spin over shear rate of the free disc
# in Couette flow; torque on the held one over mu, shear rate and h^2; force on
# the held one in Poiseuille flow over mu U_max, speed of the free one over
# U_max; force on the towed one over mu U
REFERENCES = {
    0.1: (-0.497243204, -0.0629703367, 8.90602749, 0.995019719, 8.95060401),
    0.2: (-0.488717045, -0.253509465, 16.2072299, 0.980322636, 16.5325468),
    0.3: (-0.473695244, -0.57627475, 27.8951245, 0.956670815, 29.1585403),
    0.4: (-0.451088806, -1.03841081, 48.4814482, 0.925344863, 52.3928431),
    0.5: (-0.419572523, -1.64898841, 88.2383006, 0.887998643, 99.3676075),
    0.65: (-0.352312774, -2.86668468, 259.083156, 0.82455304, 314.210418),
    0.8: (-0.255465937, -4.48295418, 1233.5402, 0.756909397, 1629.70654),
}
NU, U_MAX = 0.5, 1.5
# With convection: small enough for the Stokes values to hold
LOW_SHEAR = 0.02
END, STEP = 10, 0.05
POISEUILLE = "1.5*(1 - sqr(pos().y()))"

FREE_SPIN = "constraints { translate (0 0 0); }"
FREE_ALONG = "constraints { translate (1 0 0); }"
WINDOW = "window { type comoving; direction (1 0 0); }"


class Channel:
    """The disc and its mesh; plates at y = -1 and 1."""

    def __init__(self, folder, k, cells):
        self.folder, self.k, self.cells = folder, k, cells
        self.h = 2*k/cells
        core = 4*k
        if core > 0.8:
            # Equal cells from plate to plate
            n = round(2/self.h)
            self.h = 2/n
            self.y = uniform(-1, 1, n)
            core = k + 0.5
        else:
            self.y = graded(-1, 1, around(0, core, self.h, 0.4), self.h)
        self.x = graded(-4, 4, around(0, core, self.h, 0.3), self.h)
        self.D_over_h = round(2*k/self.h, 2)
        self.gap = (1 - k)/self.h

    def solve(self, settings, disc, profile=None, stokes=True, window=""):
        """The case after its run, and the run; profile: of Couette flow."""
        name = f"{settings.replace(' ', '_')}_{self.k}_D{self.cells}"
        case = BodyCase("tube", self.folder, name)
        if stokes:
            set_stokes(case)
        if profile:
            set_profile(case, POISEUILLE, profile)
            for file in ("0.orig/U", "0/U"):
                case.replace(file, "{ type noSlip; }", "{ $inlet; }")
        n = case.mesh(self.x, self.y)
        case.bodies(f"""
            disc
            {{
                shape       {{ type disc; radius {self.k}; }}
                densityRatio 2;
                position    (0 0 0);
                {disc}
            }}
        """, window)
        case.controls(endTime=f"{END}", deltaT=f"{STEP}")
        return case, Run(case, f"{settings} D/H {self.k}", self.D_over_h, n)

    def couette(self):
        """Free and held disc between plates that move."""
        spin, torque, *_ = REFERENCES[self.k]
        for settings, shear, stokes in (
            ("Couette free", 1, True),
            ("Couette free low Re", LOW_SHEAR, False),
        ):
            case, run = self.solve(
                settings, FREE_SPIN, f"{shear}*pos().y()", stokes
            )
            omega = case.table("motion")["angularVelocity_z"]/shear
            yield run, "spin", omega, spin

        case, run = self.solve("Couette held", LOCKED, "pos().y()")
        measured = case.table("forces")["fluidTorque_z"]/(DEPTH*NU)
        yield run, "torque", measured, torque

    def poiseuille(self):
        """Free and held disc between plates at rest."""
        _, _, force, speed, _ = REFERENCES[self.k]
        case, run = self.solve("Poiseuille held", LOCKED)
        measured = case.table("forces")["fluidForce_x"]/(DEPTH*NU*U_MAX)
        yield run, "F/(mu U_max)", measured, force

        case, run = self.solve("Poiseuille free", FREE_ALONG, window=WINDOW)
        measured = case.table("motion")["velocity_x"]/U_MAX
        yield run, "U/U_max", measured, speed

    def towed(self):
        """Disc towed through fluid at rest, over two cells."""
        speed = 2*self.h/END
        case, run = self.solve(
            "towed", f"velocity ({speed:.12g} 0 0); {LOCKED}", "0"
        )
        force = case.table("forces")["fluidForce_x"]/(DEPTH*NU*speed)
        # Mean over the last cell
        mean = -force[len(force)//2:].mean()
        yield run, "F/(mu U)", [mean], REFERENCES[self.k][4]


def rows(folder, quick):
    for k in list(REFERENCES)[1 if quick else 0:]:
        for cells in (8, 16) if quick or k < 0.5 else (8, 16, 32):
            channel = Channel(folder, k, cells)
            for figures in (
                channel.couette(), channel.poiseuille(), channel.towed()
            ):
                for run, quantity, values, reference in figures:
                    yield run.row(quantity, values[-1], reference)
                    if len(values) > 1:
                        last = values[3*len(values)//4:]/values[-1] - 1
                        yield run.row("last change, %", 100*abs(last).max())
            yield run.row("gap/h", channel.gap)
