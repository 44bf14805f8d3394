// SPDX-License-Identifier: GPL-3.0-or-later

#include "ellipsoid.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
#include "unitSurfaces.H"

using Foam::constant::mathematical::pi;

namespace Foam
{
namespace bodyShapes
{
    defineTypeNameAndDebug(ellipsoid, 0);
    addToRunTimeSelectionTable(bodyShape, ellipsoid, dictionary);
}
}


Foam::bodyShapes::ellipsoid::ellipsoid
(
    const dictionary& dict,
    const geometricSpace& space
)
:
    ellipticShape(dict, space, 3, dict.get<vector>("semiAxes"))
{}


Foam::scalar Foam::bodyShapes::ellipsoid::volume() const
{
    return 4.0/3.0*pi*cmptProduct(semiAxes_);
}


Foam::symmTensor Foam::bodyShapes::ellipsoid::inertia() const
{
    return inertiaOf(0.2*volume()*cmptMultiply(semiAxes_, semiAxes_));
}


void Foam::bodyShapes::ellipsoid::surface
(
    pointField& points,
    faceList& faces
) const
{
    unitSurfaces::sphere(points, faces);

    for (point& X : points)
    {
        X = cmptMultiply(X, semiAxes_);
    }
}
