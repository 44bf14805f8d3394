// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallFacets.H"

void Foam::wallFacets::meetRound
(
    const immersedBody& body,
    const facet& f,
    contactPoint& c
) const
{
    const point& centre = body.state().position;
    const scalar R = body.shape().boundingRadius();

    // Most are too far to be touched: no need to know how far
    if (f.leastDistance(centre) > 2*R)
    {
        return;
    }

    const vector apart(cmptMultiply(centre - f.nearest(centre), inSpace_));
    const scalar distance = mag(apart);

    // Not one that is seen from behind
    if ((apart & f.normal) > 0)
    {
        c.gap = distance - R;
        c.normal = -apart/distance;
        c.position = centre - apart;
    }
}


void Foam::wallFacets::meetCorners
(
    const immersedBody& body,
    const UList<point>& corners,
    const facet& f,
    const scalar reach,
    contactPoint& c
) const
{
    const scalar R = body.shape().boundingRadius();
    const scalar width = body.shape().width();

    if (f.leastDistance(body.state().position) > R + reach)
    {
        return;
    }

    // Corners of the body on the face, and points of the face in the body
    pointField x(f.points);
    x.append(f.nearest(body.state().position));
    scalarField gaps(x.size());
    body.posed().distance(x, gaps);

    scalar least = min(gaps);

    for (const point& y : corners)
    {
        // Most are too high to count
        if (f.leastHeight(y) > least + contactPoint::nearlySmallest(width))
        {
            continue;
        }

        const point foot(f.nearest(y));
        const scalar height = (y - foot) & f.normal;

        if (mag(y - foot - height*f.normal) < 1e-6*R)
        {
            x.append(foot);
            gaps.append(height);
            least = min(least, height);
        }
    }

    c.average(x, gaps, width);
    c.normal = -f.normal;
}


Foam::List<Foam::contactPoint> Foam::wallFacets::nearest
(
    const immersedBody& body,
    const UList<facet>& facets,
    const scalar reach
) const
{
    const bool round = body.shape().round();
    const bool smooth = body.shape().hasSupport();
    const pointField corners
    (
        round || smooth ? pointField() : contactPoint::surface(body)
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
            meetRound(body, f, c);
        }
        else if (!smooth)
        {
            meetCorners(body, corners, f, reach, c);
        }
    }
    if (smooth)
    {
        meetSmooth(body, facets, reach, result);
    }

    return result;
}
