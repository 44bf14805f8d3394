// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallFacets.H"

Foam::wallFacets::facet::facet(const UList<point>& x)
:
    points(x)
{
    const face f(identity(points.size()));

    centre = f.centre(points);
    normal = -f.areaNormal(points);
    normal /= mag(normal) + VSMALL;
    radius = bulge = 0;

    for (const point& p : points)
    {
        radius = max(radius, mag(p - centre));
        bulge = max(bulge, mag((p - centre) & normal));
    }
}


Foam::point Foam::wallFacets::facet::nearest(const point& x) const
{
    return face(identity(points.size())).nearestPoint(x, points).rawPoint();
}


bool Foam::wallFacets::facet::covers
(
    const point& x,
    const scalar margin
) const
{
    // In the triangle of the centre and an edge
    forAll(points, i)
    {
        const point corners[3] =
        {
            centre, points[i], points[points.fcIndex(i)]
        };
        bool inside = true;

        for (direction k = 0; k < 3; ++k)
        {
            const point& from = corners[k];
            const vector outwards(normal ^ (from - corners[(k + 1) % 3]));

            inside = inside
             && (outwards & (x - from)) >= -margin*mag(outwards);
        }

        if (inside)
        {
            return true;
        }
    }

    return false;
}


Foam::wallFacets::wallFacets(const geometricSpace& space)
:
    inSpace_(space.translation())
{}


Foam::wallFacets::wallFacets
(
    const UList<pointField>& faces,
    const label nBodies,
    const geometricSpace& space,
    const UList<vector>& U
)
:
    facets_(nBodies),
    inSpace_(space.translation())
{
    for (DynamicList<facet>& facets : facets_)
    {
        forAll(faces, i)
        {
            facets.append(facet(faces[i]));
            facets.last().U = U.empty() ? vector::zero : U[i];
        }
    }
}


void Foam::wallFacets::update
(
    const UList<point>&,
    const UList<scalar>&,
    const periodicity&,
    const bodyShare*
)
{}


Foam::wordList Foam::wallFacets::patches() const
{
    return wordList();
}


Foam::scalar Foam::wallFacets::maxSpeed() const
{
    scalar speed = 0;

    forAll(facets_, bodyi)
    {
        speed = max(speed, maxSpeedBeside(bodyi));
    }

    return speed;
}


Foam::scalar Foam::wallFacets::leastDistance
(
    const label bodyi,
    const point& x
) const
{
    scalar least = GREAT;

    for (const facet& f : facets_[bodyi])
    {
        least = min(least, f.leastDistance(x));
    }

    return least;
}


Foam::scalar Foam::wallFacets::leastGap
(
    const label bodyi,
    const immersedBody& body
) const
{
    const scalar R = body.shape().boundingRadius();
    scalar least = GREAT;

    for (const facet& f : facets_[bodyi])
    {
        const scalar outside = f.leastDistance(body.state().position) - R;

        if (outside < least)
        {
            const point lowest(body.posed().support(-f.normal));

            least = min(least, max(outside, f.leastHeight(lowest)));
        }
    }

    return least;
}


Foam::scalar Foam::wallFacets::maxSpeedBeside(const label bodyi) const
{
    scalar speed = 0;

    for (const facet& f : facets_[bodyi])
    {
        speed = max(speed, mag(f.U));
    }

    return speed;
}
