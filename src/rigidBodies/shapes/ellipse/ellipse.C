// SPDX-License-Identifier: GPL-3.0-or-later

#include "ellipse.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
#include "unitSurfaces.H"
#include "vector2D.H"

using Foam::constant::mathematical::pi;

namespace Foam
{
namespace bodyShapes
{
    defineTypeNameAndDebug(ellipse, 0);
    addToRunTimeSelectionTable(bodyShape, ellipse, dictionary);
}
}

Foam::vector Foam::bodyShapes::ellipse::inPlaneAxes
(
    const dictionary& dict,
    const geometricSpace& space
)
{
    const vector2D ab(dict.get<vector2D>("semiAxes"));
    const vector emptyDir(space.emptyDir());
    vector axes(GREAT, GREAT, GREAT);

    for (int i = 0; i < 3; ++i)
    {
        if (emptyDir[i] > 0)
        {
            axes[(i + 1) % 3] = ab.x();
            axes[(i + 2) % 3] = ab.y();
        }
    }

    return axes;
}


Foam::bodyShapes::ellipse::ellipse
(
    const dictionary& dict,
    const geometricSpace& space
)
:
    ellipticShape(dict, space, 2, inPlaneAxes(dict, space))
{}


Foam::scalar Foam::bodyShapes::ellipse::volume() const
{
    return pi*cmptProduct(inPlane(semiAxes_) + emptyDir_);
}


Foam::symmTensor Foam::bodyShapes::ellipse::inertia() const
{
    const vector axes(inPlane(semiAxes_));

    return inertiaOf(0.25*volume()*cmptMultiply(axes, axes), emptyDir_);
}


void Foam::bodyShapes::ellipse::surface
(
    pointField& points,
    faceList& faces
) const
{
    unitSurfaces::disc(emptyDir_, points, faces);

    for (point& X : points)
    {
        X = cmptMultiply(X, inPlane(semiAxes_));
    }
}
