# SPDX-License-Identifier: GPL-3.0-or-later
"""Published losses: of bends, of sections that change, and what solids add.

zeta: loss of total pressure over the dynamic pressure rho U^2/2, here of the
section that is named. G: mass of solids through a section per area and time
[kg/(m2 s)], u: their speed [m/s]; results in Pa.
"""

import math

GRAVITY = 9.81
# Kinetic energy of the profile of the power 1/7 over that of an even one
PROFILE = 1.058


def ito(Re, ratio, angle):
    """zeta of a smooth bend, friction along it and what is lost behind it
    included; ratio: radius of its axis over that of the tube. H. Ito, J. Basic
    Eng. 82 (1960) 131, for Re (a/R)^2 > 91; None at other angles than his."""
    alpha = {45: 1 + 14.2*ratio**-1.47,
             90: 0.95 + 17.2*ratio**-1.96 if ratio < 19.7 else 1,
             180: 1 + 116*ratio**-4.52}.get(angle)
    if alpha is None or Re/ratio**2 < 91:
        return None
    return 0.00241*alpha*angle*ratio**0.84*Re**-0.17


def idelchik(f, ratio):
    """The same at 90 degrees; ratio: radius of the axis over the diameter, f:
    friction factor of the tube. I. E. Idelchik, Handbook of hydraulic
    resistance (diagram 6-1), for Re > 2e5, ten diameters and more of straight
    tube behind it; below that Re it is up to twice as much."""
    return 0.21*ratio**(-0.5 if ratio >= 1 else -2.5) + 0.5*math.pi*ratio*f


def expansion(ratio):
    """zeta of a sudden one, of the narrow section; ratio: narrow over wide
    area, 0: into the open. Borda (1766), Carnot."""
    return (1 - ratio)**2


def contraction(ratio):
    """zeta of a sudden one, of the narrow section; ratio: narrow over wide
    area, 0: sharp entrance that is flush with a wall. Idelchik (diagram 4-9),
    Re > 1e4."""
    return 0.5*(1 - ratio)**0.75


def momentum(G, u):
    """What solids carry through a section; what they take up between two is a
    loss of the air, if walls have none of it."""
    return G*u


def lift(G, u, height):
    """Weight of the solids that are on the way up."""
    return G/u*GRAVITY*height


def bendWithSolids(loss, loading):
    """What solids add to the loss of a bend, of that of the air alone; loading:
    mass of solids over that of the air. A. J. Chambers & R. D. Marcus (1986),
    2nd Int. Conf. on Bulk Materials Storage, Handling and Transportation."""
    return loading*loss


# Friction of solids on walls, f of 2 f G u L/D

def stemerding(u, diameter):
    """S. Stemerding, Chem. Eng. Sci. 17 (1962) 599: powder, up."""
    return 0.003


def konnoSaito(u, diameter):
    """H. Konno & S. Saito, J. Chem. Eng. Japan 2 (1969) 211: up and level."""
    return 0.0285*math.sqrt(GRAVITY*diameter)/u


def capesNakamura(u, diameter):
    """C. E. Capes & K. Nakamura, Can. J. Chem. Eng. 51 (1973) 31: up, coarse
    grains."""
    return 0.0483*u**-1.22


SOLIDS_FRICTION = (stemerding, konnoSaito, capesNakamura)


def solidsFriction(G, u, length, diameter):
    """Least and greatest of the three."""
    found = [2*f(u, diameter)*G*u*length/diameter for f in SOLIDS_FRICTION]
    return min(found), max(found)
