// SPDX-License-Identifier: GPL-3.0-or-later

#include "superellipse.H"
#include "addToRunTimeSelectionTable.H"
#include "ellipse.H"
#include "unitSurfaces.H"

namespace Foam
{
namespace bodyShapes
{
    defineTypeNameAndDebug(superellipse, 0);
    addToRunTimeSelectionTable(bodyShape, superellipse, dictionary);
}
}


Foam::bodyShapes::superellipse::superellipse
(
    const dictionary& dict,
    const geometricSpace& space
)
:
    superellipticShape
    (
        dict,
        space,
        2,
        ellipse::inPlaneAxes(dict, space),
        "exponent",
        dict.get<scalar>("exponent")*vector2D::one
    ),
    ab_(dict.get<vector2D>("semiAxes"))
{}


Foam::scalar Foam::bodyShapes::superellipse::volume() const
{
    return planeMoment(ab_.x(), ab_.y(), n1_, 0, 0);
}


Foam::symmTensor Foam::bodyShapes::superellipse::inertia() const
{
    return
    (
        planeMoment(ab_.x(), ab_.y(), n1_, 2, 0)
      + planeMoment(ab_.x(), ab_.y(), n1_, 0, 2)
    )*sqr(emptyDir_);
}


void Foam::bodyShapes::superellipse::surface
(
    pointField& points,
    faceList& faces
) const
{
    unitSurfaces::disc(emptyDir_, points, faces);

    for (point& X : points)
    {
        X = atAngles(X);
    }
}
