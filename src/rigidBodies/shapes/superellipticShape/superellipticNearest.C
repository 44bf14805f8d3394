// SPDX-License-Identifier: GPL-3.0-or-later

#include "superellipticShape.H"
#include <cmath>

namespace
{

using Foam::scalar;

//- The norm (a^n + b^n)^(1/n) of positive a, b, and its derivatives
struct planeNorm
{
    scalar value, d1, d2, d11, d12, d22;

    planeNorm(const scalar a, const scalar b, const scalar n)
    :
        value(norm(a, b, n))
    {
        const scalar A = a/value, B = b/value;
        const scalar Ap = std::pow(A, n - 2), Bp = std::pow(B, n - 2);
        const scalar bend = (n - 1)*Ap*Bp/value;

        d1 = Ap*A;
        d2 = Bp*B;
        d11 = bend*B*B;
        d12 = -bend*A*B;
        d22 = bend*A*A;
    }

    //- Scaled: powers of what is small vanish
    static scalar norm(const scalar a, const scalar b, const scalar n)
    {
        const scalar larger = Foam::max(a, b), ratio = Foam::min(a, b)/larger;

        return larger*std::pow(1 + std::pow(ratio, n), 1/n);
    }
};


//- Components over the semi-axes, kept off zero, where ratios have no limit
Foam::vector scaled(const Foam::point& x, const Foam::vector& semiAxes)
{
    const scalar tiny = 1e-20;

    return Foam::max
    (
        Foam::cmptDivide(x, semiAxes),
        Foam::vector::uniform(tiny)
    );
}

} // End anonymous namespace


Foam::point Foam::bodyShapes::superellipticShape::onSurface
(
    const point& x
) const
{
    const vector u(scaled(cmptMag(x), semiAxes_));
    const scalar r = planeNorm::norm(u.x(), u.y(), n2_);

    return cmptMag(x)/planeNorm::norm(r, u.z(), n1_);
}


void Foam::bodyShapes::superellipticShape::derivatives
(
    const point& x,
    vector& g,
    symmTensor& H
) const
{
    const vector u(scaled(x, semiAxes_));
    const planeNorm r(u.x(), u.y(), n2_);
    const planeNorm N(r.value, u.z(), n1_);
    const vector& s = semiAxes_;

    g = cmptDivide(vector(N.d1*r.d1, N.d1*r.d2, N.d2), s);

    H.xx() = (N.d11*r.d1*r.d1 + N.d1*r.d11)/(s.x()*s.x());
    H.xy() = (N.d11*r.d1*r.d2 + N.d1*r.d12)/(s.x()*s.y());
    H.yy() = (N.d11*r.d2*r.d2 + N.d1*r.d22)/(s.y()*s.y());
    H.xz() = N.d12*r.d1/(s.x()*s.z());
    H.yz() = N.d12*r.d2/(s.y()*s.z());
    H.zz() = N.d22/(s.z()*s.z());
}


Foam::vector Foam::bodyShapes::superellipticShape::newtonStep
(
    const point& x,
    const point& Y,
    scalar& slope
) const
{
    vector g;
    symmTensor H;
    derivatives(x, g, H);

    // Two unit vectors in the tangent plane; in 2D one is the empty direction
    const direction least =
        g.x() <= min(g.y(), g.z()) ? 0 : g.y() <= g.z() ? 1 : 2;
    vector e1(Zero);
    e1[least] = 1;
    e1 = normalised(e1 - (e1 & g)*g/magSqr(g));
    const vector e2(normalised(g^e1));

    // With x(v) = (x + v)/N(x + v) half the squared distance is, to second
    // order, -(Y - x).v + v.(I + ((Y - x).x) H).v/2
    const vector r(Y - x);
    const scalar k = r & x;
    scalar A11 = 1 + k*(e1 & (H & e1));
    scalar A22 = 1 + k*(e2 & (H & e2));
    const scalar A12 = k*(e1 & (H & e2));
    const scalar b1 = r & e1, b2 = r & e2;

    // Beyond the centre of curvature, inside: towards a minimum all the same
    const scalar lowest =
        0.5*(A11 + A22) - std::hypot(0.5*(A11 - A22), A12);

    if (lowest < 1e-4)
    {
        const scalar shift = max(-lowest, 0.1) - lowest;
        A11 += shift;
        A22 += shift;
    }

    const scalar det = A11*A22 - A12*A12;
    const scalar v1 = (b1*A22 - b2*A12)/det, v2 = (b2*A11 - b1*A12)/det;

    slope = b1*v1 + b2*v2;

    return v1*e1 + v2*e2;
}


Foam::vector Foam::bodyShapes::superellipticShape::descend
(
    point x,
    const point& Y
) const
{
    const scalar size = mag(x);
    const label maxIter = 100, maxHalvings = 30;
    scalar moved = size;

    for (label iter = 0; iter < maxIter && moved > 1e-12*size; ++iter)
    {
        scalar slope;
        vector v(newtonStep(x, Y, slope));
        point next(onSurface(x + v));
        moved = mag(v);

        // Where rounding hides what is gained, Newton's step is good
        if (moved > 1e-6*size)
        {
            label halvings = 0;

            while (0.5*((next - x) & (next + x - 2*Y)) > -1e-4*slope)
            {
                if (++halvings > maxHalvings)
                {
                    next = x;
                    moved = 0;
                    break;
                }

                v *= 0.5;
                slope *= 0.5;
                next = onSurface(x + v);
            }
        }
        x = next;
    }

    vector g;
    symmTensor H;
    derivatives(x, g, H);

    return g;
}


Foam::vector Foam::bodyShapes::superellipticShape::nearestGradient
(
    const point& Y
) const
{
    // Outside there is one minimum, inside up to one for each pair of sides
    const bool inside = magSqr(onSurface(Y)) >= magSqr(Y);
    const label nRuns = inside ? starts_.size() : 1;
    vector best(Zero);
    scalar highest = -GREAT;

    for (label run = 0; run < nRuns; ++run)
    {
        const point* x = nullptr;

        for (label side = 0; side < starts_.size(); ++side)
        {
            for (const point& start : starts_[side])
            {
                if
                (
                    (side == run || !inside)
                 && (!x || magSqr(start - Y) < magSqr(*x - Y))
                )
                {
                    x = &start;
                }
            }
        }

        if (x)
        {
            const vector g(descend(*x, Y));
            const scalar d = ((Y & g) - 1)/mag(g);

            if (d > highest)
            {
                highest = d;
                best = g;
            }
        }
    }

    return best;
}
