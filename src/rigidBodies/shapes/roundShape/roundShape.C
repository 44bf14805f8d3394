// SPDX-License-Identifier: GPL-3.0-or-later

#include "roundShape.H"
#include "checkKeywords.H"

Foam::bodyShapes::roundShape::roundShape
(
    const dictionary& dict,
    const geometricSpace& space,
    const label nDims
)
:
    bodyShape(),
    radius_(keywords::positive(dict, "radius")),
    emptyDir_(space.emptyDir())
{
    keywords::check(dict, {"type", "radius"});

    checkSpace(dict, space, nDims, space.twoD() ? "disc" : "sphere");
}


void Foam::bodyShapes::roundShape::distance
(
    const UList<point>& X,
    UList<scalar>& d
) const
{
    forAll(X, i)
    {
        d[i] = mag(inSpace(X[i])) - radius_;
    }
}


void Foam::bodyShapes::roundShape::normal
(
    const UList<point>& X,
    UList<vector>& n
) const
{
    forAll(X, i)
    {
        const vector r(inSpace(X[i]));
        n[i] = r/(mag(r) + VSMALL);
    }
}


void Foam::bodyShapes::roundShape::curvature
(
    const UList<vector>& n,
    UList<scalar>& kappa
) const
{
    const bool flat = emptyDir_ != vector::zero;

    forAll(n, i)
    {
        kappa[i] = flat && magSqr(inSpace(n[i])) > SMALL ? 1/radius_ : 0;
    }
}
