// SPDX-License-Identifier: GPL-3.0-or-later

#include "sphere.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
#include "unitSurfaces.H"

using Foam::constant::mathematical::pi;

namespace Foam
{
namespace bodyShapes
{
    defineTypeNameAndDebug(sphere, 0);
    addToRunTimeSelectionTable(bodyShape, sphere, dictionary);
}
}


Foam::bodyShapes::sphere::sphere
(
    const dictionary& dict,
    const geometricSpace& space
)
:
    roundShape(dict, space, 3)
{}


Foam::scalar Foam::bodyShapes::sphere::volume() const
{
    return 4.0/3.0*pi*pow3(radius_);
}


Foam::symmTensor Foam::bodyShapes::sphere::inertia() const
{
    return 0.4*volume()*sqr(radius_)*symmTensor::I;
}


void Foam::bodyShapes::sphere::surface
(
    pointField& points,
    faceList& faces
) const
{
    unitSurfaces::sphere(points, faces);
    points *= radius_;
}
