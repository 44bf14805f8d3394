// SPDX-License-Identifier: GPL-3.0-or-later

#include "ellipticShape.H"
#include "checkKeywords.H"

Foam::bodyShapes::ellipticShape::ellipticShape
(
    const dictionary& dict,
    const geometricSpace& space,
    const label nDims,
    const vector& semiAxes
)
:
    bodyShape(),
    counts_(space.translation()),
    smallest_(cmptMin(semiAxes)),
    excess_(Zero),
    semiAxes_(semiAxes),
    emptyDir_(space.emptyDir())
{
    keywords::check(dict, {"type", "semiAxes"});
    checkSpace(dict, space, nDims, space.twoD() ? "ellipse" : "ellipsoid");
    checkPositive(dict, "semiAxes", semiAxes);

    excess_ = cmptMultiply(semiAxes, semiAxes)/sqr(smallest_) - vector::one;
}


Foam::scalar Foam::bodyShapes::ellipticShape::nearest
(
    const point& X,
    vector& v
) const
{
    // The components are kept off zero, where the pole at w = 0 would vanish
    // together with the root beside it
    const scalar tiny = 1e-20;

    vector y, a;
    scalar w = 0;

    for (direction i = 0; i < 3; ++i)
    {
        y[i] = counts_[i]*max(mag(X[i]), tiny*semiAxes_[i]);
        a[i] = (excess_[i] + 1)*y[i]/semiAxes_[i];

        // Where one term of the sum is one, the sum is at least that
        w = max(w, a[i] - excess_[i]);
    }

    for (label iter = 0; iter < 200; ++iter)
    {
        scalar sum = 0, slope = 0;

        for (direction i = 0; i < 3; ++i)
        {
            const scalar term = sqr(a[i]/(w + excess_[i]));
            sum += term;
            slope += 2*term/(w + excess_[i]);
        }

        const scalar dw = (sum - 1)/slope;
        w += dw;

        if (dw < 1e-15*w)
        {
            break;
        }
    }

    for (direction i = 0; i < 3; ++i)
    {
        v[i] = y[i]/(w + excess_[i]);
    }

    return w;
}


void Foam::bodyShapes::ellipticShape::distance
(
    const UList<point>& X,
    UList<scalar>& d
) const
{
    vector v;

    forAll(X, i)
    {
        const scalar w = nearest(X[i], v);
        d[i] = (w - 1)*mag(v);
    }
}


void Foam::bodyShapes::ellipticShape::normal
(
    const UList<point>& X,
    UList<vector>& n
) const
{
    vector v;

    forAll(X, i)
    {
        nearest(X[i], v);
        const scalar magV = mag(v);

        for (direction j = 0; j < 3; ++j)
        {
            n[i][j] = X[i][j] == 0 ? 0 : sign(X[i][j])*v[j]/magV;
        }

        // Two nearest points, which differ by the sign of what has been zero
        if (magSqr(n[i]) < 0.999)
        {
            n[i] = Zero;
        }
    }
}


Foam::scalar Foam::bodyShapes::ellipticShape::boundingRadius() const
{
    return cmptMax(inPlane(semiAxes_));
}


Foam::point Foam::bodyShapes::ellipticShape::support(const vector& n) const
{
    const vector scaled(cmptMultiply(inPlane(semiAxes_), n));

    return cmptMultiply(inPlane(semiAxes_), scaled)/(mag(scaled) + VSMALL);
}


Foam::symmTensor Foam::bodyShapes::ellipticShape::supportTensor() const
{
    const vector axes(inPlane(semiAxes_));
    symmTensor A(Zero);

    A.xx() = sqr(axes.x());
    A.yy() = sqr(axes.y());
    A.zz() = sqr(axes.z());

    return A;
}


Foam::scalar Foam::bodyShapes::ellipticShape::contactRadius
(
    const vector& n
) const
{
    const vector an(cmptMultiply(inPlane(semiAxes_), n));
    const scalar h = mag(an)/mag(inPlane(n));

    // The empty component counts as one
    const scalar product = cmptProduct(inPlane(semiAxes_) + emptyDir_);

    return emptyDir_ == vector::zero ? product/sqr(h) : sqr(product)/pow3(h);
}
