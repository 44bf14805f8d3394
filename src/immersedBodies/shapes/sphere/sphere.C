// SPDX-License-Identifier: GPL-3.0-or-later

#include "sphere.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;
using Foam::constant::mathematical::twoPi;

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
    // Quadrilaterals between meridians and parallels; at the poles two of
    // the corners coincide
    const label nAround = 24;
    const label nAlong = 12;

    points.setSize(nAround*(nAlong + 1));
    faces.setSize(nAround*nAlong);

    for (label j = 0; j <= nAlong; ++j)
    {
        const scalar theta = pi*j/nAlong;

        for (label i = 0; i < nAround; ++i)
        {
            const scalar angle = twoPi*i/nAround;
            const label next = (i + 1) % nAround;

            points[j*nAround + i] = radius_*vector
            (
                Foam::sin(theta)*Foam::cos(angle),
                Foam::sin(theta)*Foam::sin(angle),
                Foam::cos(theta)
            );

            if (j < nAlong)
            {
                const label here = j*nAround, below = here + nAround;

                faces[here + i] = face
                (
                    labelList({here + i, below + i, below + next, here + next})
                );
            }
        }
    }
}
