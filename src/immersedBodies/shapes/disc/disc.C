// SPDX-License-Identifier: GPL-3.0-or-later

#include "disc.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;
using Foam::constant::mathematical::twoPi;

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
    // Sectors around the centre, so that the turning can be seen
    const label nSectors = 48;

    // Two unit vectors in the plane, right-handed with its normal
    const vector e1(emptyDir_.y(), emptyDir_.z(), emptyDir_.x());
    const vector e2(emptyDir_^e1);

    points.setSize(nSectors + 1);
    faces.setSize(nSectors);
    points[nSectors] = Zero;

    for (label i = 0; i < nSectors; ++i)
    {
        const scalar angle = twoPi*i/nSectors;
        points[i] = radius_*(Foam::cos(angle)*e1 + Foam::sin(angle)*e2);
        faces[i] = face(labelList({nSectors, i, (i + 1) % nSectors}));
    }
}
