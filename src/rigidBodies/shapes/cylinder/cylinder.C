// SPDX-License-Identifier: GPL-3.0-or-later

#include "cylinder.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "mathematicalConstants.H"
#include "unitSurfaces.H"

using Foam::constant::mathematical::pi;

namespace Foam
{
namespace bodyShapes
{
    defineTypeNameAndDebug(cylinder, 0);
    addToRunTimeSelectionTable(bodyShape, cylinder, dictionary);
}
}


Foam::bodyShapes::cylinder::cylinder
(
    const dictionary& dict,
    const geometricSpace& space
)
:
    bodyShape(),
    radius_(keywords::positive(dict, "radius")),
    half_(0.5*keywords::positive(dict, "length"))
{
    keywords::check(dict, {"type", "radius", "length"});
    checkSpace(dict, space, 3, "disc");
}


void Foam::bodyShapes::cylinder::distance
(
    const UList<point>& X,
    UList<scalar>& d
) const
{
    forAll(X, i)
    {
        const vector2D q(beyond(X[i]));

        d[i] = Foam::hypot(max(q.x(), 0), max(q.y(), 0))
          + min(max(q.x(), q.y()), 0);
    }
}


void Foam::bodyShapes::cylinder::normal
(
    const UList<point>& X,
    UList<vector>& n
) const
{
    forAll(X, i)
    {
        const vector2D q(beyond(X[i]));
        const vector r(X[i].x(), X[i].y(), 0);

        // Zero on the axis, in the middle between the ends
        const vector outward(r/(mag(r) + VSMALL));
        const vector along(0, 0, X[i].z() == 0 ? 0 : sign(X[i].z()));

        if (max(q.x(), q.y()) > 0)
        {
            n[i] = max(q.x(), 0)*outward + max(q.y(), 0)*along;
            n[i] /= mag(n[i]);
        }
        else
        {
            n[i] = q.x() > q.y() ? outward : along;
        }
    }
}


Foam::scalar Foam::bodyShapes::cylinder::volume() const
{
    return 2*pi*sqr(radius_)*half_;
}


Foam::symmTensor Foam::bodyShapes::cylinder::inertia() const
{
    const scalar across = 0.25*sqr(radius_);

    return inertiaOf(volume()*vector(across, across, sqr(half_)/3));
}


Foam::bodyShape::edgedSides Foam::bodyShapes::cylinder::sides() const
{
    edgedSides s;

    s.mantle = vector(0, 0, 1);
    s.faces.append(s.mantle);
    s.edges.append(s.mantle);

    return s;
}


Foam::point Foam::bodyShapes::cylinder::support(const vector& n) const
{
    const scalar across = Foam::hypot(n.x(), n.y());
    const scalar z = n.z() < 0 ? -half_ : half_;

    // Normal to an end, but for rounding, any point of that is farthest
    return across > 1e-9
      ? point(radius_*n.x()/across, radius_*n.y()/across, z)
      : point(0, 0, z);
}


void Foam::bodyShapes::cylinder::surface
(
    pointField& points,
    faceList& faces
) const
{
    // From the centre of the upper end along its radius, down the mantle, and
    // back along the lower end
    const label nRadial = 4, nAlong = 8;
    DynamicList<vector2D> profile;

    for (label i = 0; i < nRadial; ++i)
    {
        profile.append(vector2D(radius_*i/nRadial, half_));
    }
    for (label i = 0; i <= nAlong; ++i)
    {
        profile.append(vector2D(radius_, half_*(1 - 2.0*i/nAlong)));
    }
    for (label i = nRadial - 1; i >= 0; --i)
    {
        profile.append(vector2D(radius_*i/nRadial, -half_));
    }

    unitSurfaces::revolution(vector2DField(profile), points, faces);
}
