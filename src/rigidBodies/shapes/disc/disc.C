// SPDX-License-Identifier: GPL-3.0-or-later

#include "disc.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
#include "unitSurfaces.H"

using Foam::constant::mathematical::pi;

namespace Foam
{
namespace bodyShapes
{
    defineTypeNameAndDebug(disc, 0);
    addToRunTimeSelectionTable(bodyShape, disc, dictionary);
}
}


Foam::bodyShapes::disc::disc
(
    const dictionary& dict,
    const geometricSpace& space
)
:
    roundShape(dict, space, 2)
{}


Foam::scalar Foam::bodyShapes::disc::volume() const
{
    return pi*sqr(radius_);
}


Foam::symmTensor Foam::bodyShapes::disc::inertia() const
{
    return 0.5*volume()*sqr(radius_)*sqr(emptyDir_);
}


void Foam::bodyShapes::disc::surface
(
    pointField& points,
    faceList& faces
) const
{
    unitSurfaces::disc(emptyDir_, points, faces);
    points *= radius_;
}
