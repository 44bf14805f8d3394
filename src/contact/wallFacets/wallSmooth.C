// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallFacets.H"

namespace
{

using namespace Foam;

//- Cosine above which normals are the same but for rounding
const scalar parallel = 1 - 1e-10;


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

        body.posed().normal(UList<point>(&x, 1), normals);
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


bool Foam::wallFacets::meetFace
(
    const immersedBody& body,
    const facet& f,
    const scalar reach,
    contactPoint& c
) const
{
    const scalar R = body.shape().boundingRadius();

    if (f.leastDistance(body.state().position) > R + reach)
    {
        return true;
    }

    const point lowest(body.posed().support(-f.normal));

    // No point of the facet is nearer than it is below the lowest of the body,
    // or deeper within the body
    c.gap = f.leastHeight(lowest);

    if (c.gap > reach)
    {
        return true;
    }
    if (f.covers(lowest, 1e-6*R))
    {
        c.gap = (lowest - f.nearest(lowest)) & f.normal;
        c.normal = -f.normal;
        c.position = lowest - c.gap*f.normal;
        return true;
    }

    return false;
}


void Foam::wallFacets::meetEdges
(
    const immersedBody& body,
    const facet& f,
    const scalar reach,
    contactPoint& c
) const
{
    const point& centre = body.state().position;

    // How far the body is, at least, from what is convex and has x as the point
    // nearest to its centre, or how deep that is in the body at most
    auto leastGap = [&](const point& x)
    {
        const vector apart(cmptMultiply(centre - x, inSpace_));
        const vector n(normalised(apart));

        return
            n == vector::zero
          ? -GREAT
          : mag(apart) - ((centre - body.posed().support(-n)) & n);
    };

    const point near(f.nearest(centre));

    c.gap = GREAT;
    if (((centre - near) & f.normal) <= 0 || leastGap(near) > reach)
    {
        return;
    }

    forAll(f.points, i)
    {
        const point& a = f.points[i];
        const point& b = f.points[f.points.fcIndex(i)];
        const vector ab(b - a);
        const scalar part = ((centre - a) & ab)/(magSqr(ab) + VSMALL);
        const point foot(a + min(max(part, scalar(0)), scalar(1))*ab);

        if (leastGap(foot) > min(c.gap, reach))
        {
            continue;
        }

        const point x(deepest(body, a, b));
        const scalar gap = body.posed().distance(x);

        if (gap < c.gap)
        {
            c.gap = gap;
            c.position = centre + cmptMultiply(x - centre, inSpace_);
        }
    }

    if (c.gap > reach)
    {
        return;
    }

    UList<vector> normals(&c.normal, 1);
    body.posed().normal(UList<point>(&c.position, 1), normals);
}


void Foam::wallFacets::meetSmooth
(
    const immersedBody& body,
    const UList<facet>& facets,
    const scalar reach,
    List<contactPoint>& result
) const
{
    const scalar rounding = 1e-9*body.shape().boundingRadius();
    DynamicList<label> met, beside;

    forAll(facets, i)
    {
        (meetFace(body, facets[i], reach, result[i]) ? met : beside).append(i);
    }

    for (const label i : beside)
    {
        // An edge between faces of one plane does not come before these
        bool hidden = false;

        for (const label j : met)
        {
            hidden = hidden
             ||
                (
                    result[j].gap <= result[i].gap + rounding
                 && (facets[i].normal & facets[j].normal) > parallel
                );
        }

        if (hidden)
        {
            result[i].gap = GREAT;
        }
        else
        {
            meetEdges(body, facets[i], reach, result[i]);
        }
    }
}
