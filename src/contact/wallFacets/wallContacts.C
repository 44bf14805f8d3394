// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallFacets.H"
#include "ListOps.H"

namespace
{

//- Cosine of the angle up to which faces are of one wall
const Foam::scalar sameWall = 0.7;

//- Cosine above which they are in one plane
const Foam::scalar samePlane = 1 - 1e-8;

//- How far behind a face a smooth wall may be, over the radius of the body
const Foam::scalar mostBehind = 0.1;

} // End anonymous namespace


Foam::DynamicList<Foam::label> Foam::wallFacets::concaveNeighbours
(
    const UList<facet>& facets,
    const UList<label>& group,
    const scalar tolerance
) const
{
    const facet& first = facets[group[0]];
    DynamicList<label> found;

    for (const label i : group)
    {
        const facet& f = facets[i];

        // Each plane once, however many faces are in it
        bool taken = (f.normal & first.normal) > samePlane;
        for (const label other : found)
        {
            taken = taken || (f.normal & facets[other].normal) > samePlane;
        }

        if (!taken && ((first.centre - f.centre) & f.normal) > 0)
        {
            bool adjacent = false;
            for (const point& x : f.points)
            {
                for (const point& y : first.points)
                {
                    adjacent = adjacent || mag(x - y) < tolerance;
                }
            }

            if (adjacent)
            {
                found.append(i);
            }
        }
    }

    return found;
}


void Foam::wallFacets::blend
(
    const immersedBody& body,
    const UList<facet>& facets,
    const UList<label>& group,
    contactPoint& contact
) const
{
    const scalar R = body.shape().boundingRadius();
    const point& centre = body.state().position;
    const facet& first = facets[group[0]];
    const DynamicList<label> beside
    (
        concaveNeighbours(facets, group, 1e-6*R)
    );
    const scalar height = (centre - first.centre) & first.normal;

    // How much higher the body is above the plane of a neighbour where it is
    // above the middle of the first
    scalar range = GREAT;
    for (const label i : beside)
    {
        const facet& f = facets[i];
        const scalar inMiddle =
            ((first.centre - f.centre) & f.normal)
          - height*(1 - (f.normal & first.normal));

        range = min(range, max(inMiddle, 1e-6*R));
    }

    // Weights of quadratic B-splines, with which a regular polygon becomes a
    // circle: 3/4, 1/8, 1/8 in the middle, 1/2, 1/2, 0 at the crease
    scalar lowest = range;
    scalar sum = 0, rise = 0;
    vector normal(Zero), U(Zero);

    for (const label i : beside)
    {
        const facet& f = facets[i];
        const scalar higher = ((centre - f.centre) & f.normal) - height;
        const scalar weight =
            0.125*sqr(max(2 - max(higher, scalar(0))/range, scalar(0)));

        lowest = min(lowest, max(higher, scalar(0)));
        sum += weight;
        rise += weight*higher;
        normal -= weight*f.normal;
        U += weight*f.U;
    }

    const scalar weight = 0.75 - 0.25*sqr(1 - lowest/range);
    sum += weight;
    normal += weight*contact.normal;
    U += weight*first.U;

    // In the middle of a face with two neighbours, where it is most behind, the
    // smooth wall is range/4 behind. Beside faces larger than the body its
    // centre would leave the mesh there.
    contact.gap += rise/sum*min(scalar(1), 4*mostBehind*R/range);
    contact.normal = normal/mag(normal);
    contact.wallU = U/sum;
    contact.position = centre + (R + contact.gap)*contact.normal;
}


Foam::DynamicList<Foam::contactPoint> Foam::wallFacets::contacts
(
    const label bodyi,
    const immersedBody& body,
    const scalar reach
) const
{
    const DynamicList<facet>& facets = facets_[bodyi];
    const scalar R = body.shape().boundingRadius();
    const scalar within = min(reach, R);
    const List<contactPoint> points(nearest(body, facets, within));

    scalarList gaps(points.size());
    forAll(points, i)
    {
        gaps[i] = points[i].gap;
    }

    DynamicList<contactPoint> result;
    DynamicList<label> rest(sortedOrder(gaps)), done;

    // Walls that are apart but for the reach of the search make no contact
    while (!rest.empty() && gaps[rest[0]] < within)
    {
        contactPoint contact(points[rest[0]]);
        const vector normal(facets[rest[0]].normal);
        DynamicList<label> group, others;

        for (const label i : rest)
        {
            const bool same = (facets[i].normal & normal) > sameWall;
            (same ? group : others).append(i);
        }

        bool crease = false;
        for (const label i : done)
        {
            crease = crease
             || mag(facets[i].nearest(contact.position) - contact.position)
              < 1e-6*R;
        }

        if (!crease)
        {
            if (body.shape().round())
            {
                blend(body, facets, group, contact);
            }
            contact.wallU -= (contact.wallU & contact.normal)*contact.normal;
            result.append(contact);
        }

        done.append(group);
        rest.transfer(others);
    }

    return result;
}
