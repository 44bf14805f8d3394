// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallFacets.H"

namespace
{

using namespace Foam;

//- The point [m] between a and b, at which a body ends that is smooth and
//  convex, that is deepest within the body or else nearest to it: where the
//  distance, which is convex, has its least value
point deepest(const immersedBody& body, const point& a, const point& b)
{
    // Its slope along the line
    auto slope = [&](const scalar t)
    {
        point x(a + t*(b - a));
        vector n(Zero);
        UList<vector> normals(&n, 1);

        body.normal(UList<point>(&x, 1), normals);
        return n & (b - a);
    };

    scalar t0 = 0, t1 = 1;
    scalar s0 = slope(t0), s1 = slope(t1);

    if (s0 >= 0 || s1 <= 0)
    {
        return s0 >= 0 ? a : b;
    }

    // By false position, and half of the value of an end that stays (Illinois)
    const scalar enough = 1e-8*body.shape().boundingRadius()/mag(b - a);

    for (label i = 0; i < 60 && t1 - t0 > enough; ++i)
    {
        const scalar t = (t0*s1 - t1*s0)/(s1 - s0);
        const scalar s = slope(t);

        if (mag(s) < 1e-9*mag(b - a))
        {
            return a + t*(b - a);
        }
        if (s < 0)
        {
            t0 = t;
            s0 = s;
            s1 *= 0.5;
        }
        else
        {
            t1 = t;
            s1 = s;
            s0 *= 0.5;
        }
    }

    return a + 0.5*(t0 + t1)*(b - a);
}

} // End anonymous namespace


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


void Foam::wallFacets::meetSmooth
(
    const immersedBody& body,
    const facet& f,
    const scalar reach,
    contactPoint& c
) const
{
    const point& centre = body.state().position;
    const scalar R = body.shape().boundingRadius();

    if (f.leastDistance(centre) > R + reach)
    {
        return;
    }

    const point lowest(body.support(-f.normal));
    const point foot(f.nearest(lowest));
    const scalar height = (lowest - foot) & f.normal;

    if (f.covers(lowest, 1e-6*R))
    {
        c.gap = height;
        c.normal = -f.normal;
        c.position = lowest - height*f.normal;
        return;
    }

    // Beside the face, a plane across the line from the centre to the facet is
    // between both, or how deep they overlap at most
    const vector apart(cmptMultiply(centre - f.nearest(centre), inSpace_));
    const vector n(normalised(apart));

    if
    (
        (apart & f.normal) <= 0
     || max(height, mag(apart) - ((centre - body.support(-n)) & n)) > reach
    )
    {
        return;
    }

    forAll(f.points, i)
    {
        const point x
        (
            deepest(body, f.points[i], f.points[f.points.fcIndex(i)])
        );
        const scalar gap = body.distance(x);

        if (gap < c.gap)
        {
            c.gap = gap;
            c.position = centre + cmptMultiply(x - centre, inSpace_);
        }
    }

    UList<vector> normals(&c.normal, 1);
    body.normal(UList<point>(&c.position, 1), normals);
}


void Foam::wallFacets::meetCorners
(
    const immersedBody& body,
    const UList<point>& corners,
    const facet& f,
    contactPoint& c
) const
{
    const scalar R = body.shape().boundingRadius();

    // Corners of the body on the face, and points of the face in the body
    pointField x(f.points);
    x.append(f.nearest(body.state().position));
    scalarField gaps(x.size());
    body.distance(x, gaps);

    for (const point& y : corners)
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
        else if (smooth)
        {
            meetSmooth(body, f, reach, c);
        }
        else
        {
            meetCorners(body, corners, f, c);
        }
    }

    return result;
}
