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


Foam::List<Foam::contactPoint> Foam::wallFacets::nearest
(
    const immersedBody& body,
    const UList<facet>& facets
) const
{
    const point& centre = body.state().position;
    const scalar R = body.shape().boundingRadius();
    const bool round = body.shape().round();
    const bool support = body.shape().hasSupport();
    pointField surface
    (
        round || support ? pointField() : contactPoint::surface(body)
    );

    List<contactPoint> result(facets.size());

    forAll(facets, i)
    {
        const facet& f = facets[i];
        contactPoint& c = result[i];

        c.patch = f.patch;
        c.wallU = f.U;
        if (round)
        {
            // Most are too far to be touched: no need to know how far
            if (f.leastDistance(centre) > 2*R)
            {
                continue;
            }

            const vector apart
            (
                cmptMultiply(centre - f.nearest(centre), inSpace_)
            );
            const scalar distance = mag(apart);

            // Not one that is seen from behind
            if ((apart & f.normal) > 0)
            {
                c.gap = distance - R;
                c.normal = -apart/distance;
                c.position = centre - apart;
            }
            continue;
        }

        // Corners of the body on the face, and points of the face in the body
        pointField x(f.points);
        x.append(f.nearest(centre));
        scalarField gaps(x.size());
        body.distance(x, gaps);
        if (support)
        {
            surface = pointField(1, body.support(-f.normal));
        }

        for (const point& y : surface)
        {
            const point foot(f.nearest(y));
            const scalar height = (y - foot) & f.normal;

            if (mag(y - foot - height*f.normal) < 1e-6*R)
            {
                x.append(foot);
                gaps.append(height);
            }
        }

        c.average(x, gaps, body.shape().width());
        c.normal = -f.normal;
    }

    return result;
}


void Foam::wallFacets::update
(
    const UList<point>&,
    const UList<scalar>&,
    const periodicity&
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


Foam::scalar Foam::wallFacets::maxSpeedBeside(const label bodyi) const
{
    scalar speed = 0;

    for (const facet& f : facets_[bodyi])
    {
        speed = max(speed, mag(f.U));
    }

    return speed;
}
