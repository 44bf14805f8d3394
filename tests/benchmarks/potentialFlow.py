# SPDX-License-Identifier: GPL-3.0-or-later
"""Potential flow through a simple cubic array of spheres in a cell of side 1,
along z: the same as a current around insulators (Rayleigh 1892)."""

import numpy as np

# Solid harmonics of the degrees 1, 3, ..., and Gauss points along an edge
DEGREES, POINTS = 11, 40


def solid_harmonics(x, y, z):
    """r^l P_l^m cos(m phi), scaled, by (l, m): l odd, m = 0, 4, 8, ..., as the
    array is that of a square about z."""
    r2 = x*x + y*y + z*z
    found = {}
    for m in range(0, 2*DEGREES, 4):
        before, now = 0, ((x + 1j*y)**m).real*(-2.0)**m
        for l in range(m, 2*DEGREES):
            if l % 2:
                found[l, m] = now*2.0**(l - m)
            before, now = now, (
                (2*l + 1)*z*now - (l + m)*r2*before
            )/(l - m + 1)
    return found


def potentials(x, y, z, radius):
    """Potentials that have no gradient normal to the sphere."""
    r = np.sqrt(x*x + y*y + z*z)
    return np.array([
        value*(1 + l/(l + 1)*(radius/r)**(2*l + 1))
        for (l, _), value in solid_harmonics(x, y, z).items()
    ])


def gradient(x, y, z, radius, h=1e-4):
    """Of the potentials, by differences of fourth order."""
    def difference(axis):
        def at(step):
            place = [x, y, z]
            place[axis] = place[axis] + step*h
            return potentials(*place, radius)
        return (8*(at(1) - at(-1)) - (at(2) - at(-2)))/(12*h)
    return [difference(axis) for axis in range(3)]


def solve(fraction):
    """Conductivity s over that around the insulators, and the length
    2 int |u|^2 dV/int |u|^2 dS, for a solid fraction."""
    radius = (3*fraction/(4*np.pi))**(1/3)
    nodes, weights = np.polynomial.legendre.leggauss(POINTS)
    a, b = (g.ravel() for g in np.meshgrid(0.25*(nodes + 1), 0.25*(nodes + 1)))
    weight = np.outer(weights, weights).ravel()/4
    half = np.full_like(a, 0.5)

    # 1/2 on the end z = 1/2, no flux through the side x = 1/2
    matrix = np.r_[potentials(a, b, half, radius).T,
                   gradient(half, a, b, radius)[0].T]
    right = np.r_[half, 0*half]
    scale = abs(matrix).max(axis=0)
    root = np.sqrt(np.r_[weight, weight])[:, None]
    terms, *_ = np.linalg.lstsq(
        root*matrix/scale, root[:, 0]*right, rcond=None)
    terms /= scale

    s = weight @ (terms @ gradient(a, b, half, radius)[2])
    # An eighth of the sphere; |u|^2 is a polynomial there
    cosine, phi = 0.5*(nodes + 1), 0.25*np.pi*(nodes + 1)
    z, phi = (g.ravel() for g in np.meshgrid(cosine, phi))
    ring = np.sqrt(1 - z*z)
    place = (radius*ring*np.cos(phi), radius*ring*np.sin(phi), radius*z)
    u2 = sum((terms @ g)**2 for g in gradient(*place, radius))
    surface = 4*np.pi*radius**2*(weight @ u2)
    return s, 2*s/surface


def sangani_acrivos(c):
    """Series of Sangani & Acrivos (1983) for the same conductivity."""
    L = [-(2*i - 1)/(2*i) for i in range(1, 6)]
    return 1 - 3*c/(
        -1/L[0] + c
        + 1.305*L[1]*c**(10/3)*(1 + 0.231*L[2]*c**(11/3))
        / (1 - 0.405*L[1]*c**(7/3))
        + 0.0723*L[2]*c**(14/3) + 0.153*L[3]*c**6 + 0.0105*L[4]*c**(22/3)
    )
