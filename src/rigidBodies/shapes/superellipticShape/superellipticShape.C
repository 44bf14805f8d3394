// SPDX-License-Identifier: GPL-3.0-or-later

#include "superellipticShape.H"
#include "checkKeywords.H"
#include "mathematicalConstants.H"
#include <cmath>

using Foam::constant::mathematical::piByTwo;

namespace
{

//- Largest exponent: edges then have a radius of a hundredth of the body
const Foam::scalar maxExponent = 100;


//- |s|^e with the sign of s; what is zero but for rounding is zero
Foam::scalar signedPow(const Foam::scalar s, const Foam::scalar e)
{
    return Foam::mag(s) < 1e-10 ? 0 : Foam::sign(s)*std::pow(Foam::mag(s), e);
}


//- Largest length of (a u, b v) with u^n + v^n = 1, by Hoelder's inequality
Foam::scalar longest
(
    const Foam::scalar a,
    const Foam::scalar b,
    const Foam::scalar n
)
{
    const Foam::scalar larger = Foam::max(a, b);
    const Foam::scalar e = 2*n/Foam::max(n - 2, Foam::SMALL);

    return larger*std::pow
    (
        std::pow(a/larger, e) + std::pow(b/larger, e),
        1/e
    );
}

} // End anonymous namespace


Foam::bodyShapes::superellipticShape::superellipticShape
(
    const dictionary& dict,
    const geometricSpace& space,
    const label nDims,
    const vector& semiAxes,
    const word& exponentsKey,
    const vector2D& exponents
)
:
    bodyShape(),
    semiAxes_(semiAxes),
    n1_(exponents.x()),
    n2_(exponents.y()),
    emptyDir_(space.emptyDir())
{
    keywords::check(dict, {"type", "semiAxes", exponentsKey});
    checkSpace
    (
        dict,
        space,
        nDims,
        space.twoD() ? "superellipse" : "superellipsoid"
    );
    checkPositive(dict, "semiAxes", semiAxes);

    if (!(cmptMin(exponents) >= 2 && cmptMax(exponents) <= maxExponent))
    {
        FatalIOErrorInFunction(dict)
            << "'" << exponentsKey << "' in '" << dict.dictName()
            << "' must be from 2 (round) to " << maxExponent
            << " (nearly a box)" << nl << exit(FatalIOError);
    }

    makeStarts();
}


Foam::point Foam::bodyShapes::superellipticShape::atAngles
(
    const vector& onSphere
) const
{
    const scalar r = std::hypot(onSphere.x(), onSphere.y());
    const scalar inv = 1/max(r, SMALL);
    const scalar rn = signedPow(r, 2/n1_);

    return inPlane(cmptMultiply
    (
        semiAxes_,
        vector
        (
            rn*signedPow(inv*onSphere.x(), 2/n2_),
            rn*signedPow(inv*onSphere.y(), 2/n2_),
            signedPow(onSphere.z(), 2/n1_)
        )
    ));
}


void Foam::bodyShapes::superellipticShape::addStart(const point& x)
{
    const vector u(cmptDivide(x, semiAxes_));
    const label side =
        u.x() >= max(u.y(), u.z()) ? 0 : u.y() >= u.z() ? 1 : 2;

    starts_[side].append(x);
}


void Foam::bodyShapes::superellipticShape::makeStarts()
{
    // Barr's angles are close at the edges, the same divided by their norm on
    // the sides. None in the planes of symmetry, where the method would stay.
    const label n = 8;

    for (label i = 0; i < n; ++i)
    {
        const scalar eta = piByTwo*(i + 0.5)/n;

        for (label j = 0; j < n; ++j)
        {
            const scalar angle = piByTwo*(j + 0.5)/n;
            vector X
            (
                Foam::cos(eta)*Foam::cos(angle),
                Foam::cos(eta)*Foam::sin(angle),
                Foam::sin(eta)
            );

            if (emptyDir_ != vector::zero)
            {
                const scalar part = piByTwo*(n*i + j + 0.5)/(n*n);
                const vector e1(emptyDir_.y(), emptyDir_.z(), emptyDir_.x());
                const vector e2(emptyDir_^e1);

                X = Foam::cos(part)*e1 + Foam::sin(part)*e2;
            }

            addStart(atAngles(X));
            addStart(onSurface(inPlane(cmptMultiply(semiAxes_, X))));
        }
    }
}


void Foam::bodyShapes::superellipticShape::distance
(
    const UList<point>& X,
    UList<scalar>& d
) const
{
    forAll(X, i)
    {
        const point Y(inPlane(cmptMag(X[i])));
        const vector g(nearestGradient(Y));

        d[i] = ((Y & g) - 1)/mag(g);
    }
}


void Foam::bodyShapes::superellipticShape::normal
(
    const UList<point>& X,
    UList<vector>& n
) const
{
    forAll(X, i)
    {
        const vector g(nearestGradient(inPlane(cmptMag(X[i]))));
        const scalar magG = mag(g);

        for (direction j = 0; j < 3; ++j)
        {
            n[i][j] = X[i][j] == 0 ? 0 : sign(X[i][j])*g[j]/magG;
        }

        // Two nearest points, which differ by the sign of what has been zero
        if (magSqr(n[i]) < 0.999)
        {
            n[i] = Zero;
        }
    }
}


Foam::scalar Foam::bodyShapes::superellipticShape::boundingRadius() const
{
    const vector axes(inPlane(semiAxes_));

    if (emptyDir_.z() > 0)
    {
        return longest(axes.x(), axes.y(), n2_);
    }

    // With an empty direction in the plane both exponents are the same
    return longest(longest(axes.x(), axes.y(), n2_), axes.z(), n1_);
}


Foam::scalar Foam::bodyShapes::superellipticShape::planeMoment
(
    const scalar a,
    const scalar b,
    const scalar n,
    const label i,
    const label j
)
{
    // Dirichlet's integral over a quarter, four times
    return 4*std::pow(a, i + 1)*std::pow(b, j + 1)/(n*n)
       *std::exp
        (
            std::lgamma((i + 1)/n) + std::lgamma((j + 1)/n)
          - std::lgamma((i + j + 2)/n + 1)
        );
}


Foam::point Foam::bodyShapes::superellipticShape::support
(
    const vector& n
) const
{
    // Gradient of the norm that is dual to N
    const scalar q1 = n1_/(n1_ - 1), q2 = n2_/(n2_ - 1);
    const vector axes(inPlane(semiAxes_));
    const vector s(cmptMultiply(axes, cmptMag(n)));
    const scalar r = std::pow
    (
        std::pow(s.x(), q2) + std::pow(s.y(), q2), 1/q2
    );
    const scalar norm = std::pow(std::pow(r, q1) + std::pow(s.z(), q1), 1/q1);
    const scalar rPart = std::pow(r/max(norm, VSMALL), q1 - 1);

    const vector parts
    (
        rPart*std::pow(s.x()/max(r, VSMALL), q2 - 1),
        rPart*std::pow(s.y()/max(r, VSMALL), q2 - 1),
        std::pow(s.z()/max(norm, VSMALL), q1 - 1)
    );
    point x(Zero);

    for (direction i = 0; i < 3; ++i)
    {
        x[i] = sign(n[i])*axes[i]*parts[i];
    }

    return x;
}
