// SPDX-License-Identifier: GPL-3.0-or-later

#include "box.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "unitSurfaces.H"

namespace Foam
{
namespace bodyShapes
{
    defineTypeNameAndDebug(box, 0);
    addToRunTimeSelectionTable(bodyShape, box, dictionary);
}
}

namespace
{

//- Half the size in dict; GREAT for the empty direction
Foam::vector halfSize
(
    const Foam::dictionary& dict,
    const Foam::vector& emptyDir
)
{
    Foam::vector half(0.5*dict.get<Foam::vector>("size"));

    for (Foam::direction i = 0; i < 3; ++i)
    {
        if (emptyDir[i] > 0)
        {
            half[i] = Foam::GREAT;
        }
    }

    return half;
}

} // End anonymous namespace


Foam::bodyShapes::box::box
(
    const dictionary& dict,
    const geometricSpace& space
)
:
    bodyShape(),
    emptyDir_(space.emptyDir()),
    half_(halfSize(dict, emptyDir_))
{
    keywords::check(dict, {"type", "size"});
    checkPositive(dict, "size", half_);
}


void Foam::bodyShapes::box::distance
(
    const UList<point>& X,
    UList<scalar>& d
) const
{
    forAll(X, i)
    {
        const vector q(beyond(X[i]));

        d[i] = mag(max(q, vector::zero)) + min(cmptMax(q), 0);
    }
}


void Foam::bodyShapes::box::normal
(
    const UList<point>& X,
    UList<vector>& n
) const
{
    forAll(X, i)
    {
        const vector q(beyond(X[i]));
        const scalar largest = cmptMax(q);

        if (largest > 0)
        {
            n[i] = max(q, vector::zero);
            n[i] /= mag(n[i]);
        }
        else
        {
            n[i] = Zero;

            const direction j =
                q.x() == largest ? 0 : q.y() == largest ? 1 : 2;
            n[i][j] = X[i][j] == 0 ? 0 : 1;
        }

        for (direction j = 0; j < 3; ++j)
        {
            n[i][j] *= sign(X[i][j]);
        }
    }
}


Foam::scalar Foam::bodyShapes::box::volume() const
{
    return cmptProduct(2*halfInSpace() + emptyDir_);
}


Foam::symmTensor Foam::bodyShapes::box::inertia() const
{
    const vector half(halfInSpace());

    return inertiaOf(volume()/3*cmptMultiply(half, half), emptyDir_);
}


Foam::bodyShape::edgedSides Foam::bodyShapes::box::sides() const
{
    edgedSides s;
    const vector half(halfInSpace());

    for (direction i = 0; i < 3; ++i)
    {
        if (half[i] > 0)
        {
            vector axis(Zero);
            axis[i] = 1;
            s.faces.append(axis);
        }
    }

    // In the plane the edges are points
    if (emptyDir_ != vector::zero)
    {
        return s;
    }
    s.edges = s.faces;

    for (label i = 0; i < 8; ++i)
    {
        point corner(half);
        for (direction k = 0; k < 3; ++k)
        {
            corner[k] *= (i >> k) & 1 ? -1 : 1;
        }
        s.corners.append(corner);
    }

    return s;
}


Foam::point Foam::bodyShapes::box::support(const vector& n) const
{
    point x(halfInSpace());

    for (direction i = 0; i < 3; ++i)
    {
        x[i] *= n[i] < 0 ? -1 : 1;
    }

    return x;
}


void Foam::bodyShapes::box::surface
(
    pointField& points,
    faceList& faces
) const
{
    unitSurfaces::box(emptyDir_, points, faces);

    for (point& X : points)
    {
        X = cmptMultiply(X, halfInSpace());
    }
}
