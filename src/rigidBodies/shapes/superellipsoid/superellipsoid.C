// SPDX-License-Identifier: GPL-3.0-or-later

#include "superellipsoid.H"
#include "addToRunTimeSelectionTable.H"
#include "unitSurfaces.H"
#include <cmath>

namespace Foam
{
namespace bodyShapes
{
    defineTypeNameAndDebug(superellipsoid, 0);
    addToRunTimeSelectionTable(bodyShape, superellipsoid, dictionary);
}
}


Foam::bodyShapes::superellipsoid::superellipsoid
(
    const dictionary& dict,
    const geometricSpace& space
)
:
    superellipticShape
    (
        dict,
        space,
        3,
        dict.get<vector>("semiAxes"),
        "exponents",
        dict.get<vector2D>("exponents")
    )
{}


Foam::scalar Foam::bodyShapes::superellipsoid::moment
(
    const label i,
    const label j,
    const label k
) const
{
    const scalar e = 1/n1_;
    const scalar p = (k + 1)*e, q = (i + j + 2)*e + 1;
    const scalar beta =
        std::exp(std::lgamma(p) + std::lgamma(q) - std::lgamma(p + q));

    return planeMoment(semiAxes_.x(), semiAxes_.y(), n2_, i, j)
       *2*std::pow(semiAxes_.z(), k + 1)*e*beta;
}


Foam::scalar Foam::bodyShapes::superellipsoid::volume() const
{
    return moment(0, 0, 0);
}


Foam::symmTensor Foam::bodyShapes::superellipsoid::inertia() const
{
    return inertiaOf(vector(moment(2, 0, 0), moment(0, 2, 0), moment(0, 0, 2)));
}


void Foam::bodyShapes::superellipsoid::surface
(
    pointField& points,
    faceList& faces
) const
{
    unitSurfaces::sphere(points, faces);

    for (point& X : points)
    {
        X = atAngles(X);
    }
}
