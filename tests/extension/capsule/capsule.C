// SPDX-License-Identifier: GPL-3.0-or-later

#include "capsule.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "mathematicalConstants.H"
#include "unitSurfaces.H"

using Foam::constant::mathematical::pi;

namespace Foam
{
namespace bodyShapes
{
    defineTypeNameAndDebug(capsule, 0);
    addToRunTimeSelectionTable(bodyShape, capsule, dictionary);
}
}


Foam::bodyShapes::capsule::capsule
(
    const dictionary& dict,
    const geometricSpace& space
)
:
    bodyShape(),
    radius_(keywords::positive(dict, "cap")),
    half_(0.5*keywords::positive(dict, "straight"))
{
    keywords::check(dict, {"type", "cap", "straight"});
    checkSpace(dict, space, 3);
}


void Foam::bodyShapes::capsule::distance
(
    const UList<point>& X,
    UList<scalar>& d
) const
{
    forAll(X, i)
    {
        d[i] = mag(fromLine(X[i])) - radius_;
    }
}


void Foam::bodyShapes::capsule::normal
(
    const UList<point>& X,
    UList<vector>& n
) const
{
    forAll(X, i)
    {
        const vector r(fromLine(X[i]));

        n[i] = r/(mag(r) + VSMALL);
    }
}


Foam::scalar Foam::bodyShapes::capsule::volume() const
{
    return pi*sqr(radius_)*(2*half_ + 4.0/3.0*radius_);
}


Foam::symmTensor Foam::bodyShapes::capsule::inertia() const
{
    // Of the straight part and of the two half spheres, these shifted
    const scalar R2 = sqr(radius_), ball = 4.0/15.0*radius_;
    const scalar across = pi*sqr(R2)*(0.5*half_ + ball);
    const scalar along = pi*R2
       *(
            2.0/3.0*pow3(half_) + R2*(ball + half_)
          + 4.0/3.0*radius_*sqr(half_)
        );

    return inertiaOf(vector(across, across, along));
}


Foam::point Foam::bodyShapes::capsule::support(const vector& n) const
{
    return radius_*n + vector(0, 0, n.z() < 0 ? -half_ : half_);
}


void Foam::bodyShapes::capsule::surface
(
    pointField& points,
    faceList& faces
) const
{
    const label nCap = 8;
    DynamicList<vector2D> profile;

    for (label i = 0; i <= 2*nCap; ++i)
    {
        const scalar angle = 0.5*pi*i/nCap;
        const scalar r = radius_*Foam::sin(angle);
        const scalar z = radius_*Foam::cos(angle);

        // The middle twice: the straight part is between
        if (i <= nCap)
        {
            profile.append(vector2D(i == 0 ? 0 : r, z + half_));
        }
        if (i >= nCap)
        {
            profile.append(vector2D(i == 2*nCap ? 0 : r, z - half_));
        }
    }

    unitSurfaces::revolution(vector2DField(profile), points, faces);
}
