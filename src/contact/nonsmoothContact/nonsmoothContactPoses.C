// SPDX-License-Identifier: GPL-3.0-or-later

#include "nonsmoothContact.H"

namespace
{
    //- Overlap over half the width that may stay, and number of projections:
    //  the gap is not linear in the displacements
    const Foam::scalar smallOverlap = 1e-8;
    const Foam::label maxPasses = 10;

    //- Of contacts that hold: more of them than it takes need not fit together
    const Foam::scalar softness = 1e-4;
}


void Foam::contactModels::nonsmoothContact::place
(
    PtrList<immersedBody>& bodies
) const
{
    for (const contactMover& m : movers_)
    {
        m.place(bodies[m.body]);
    }
}


Foam::scalar Foam::contactModels::nonsmoothContact::smallestHalfWidth
(
    const PtrList<immersedBody>& bodies
) const
{
    scalar width = GREAT;

    for (const contactMover& m : movers_)
    {
        width = min(width, bodies[m.body].shape().width());
    }

    return -0.5*movers_.ranks().largest(-width);
}


Foam::scalar Foam::contactModels::nonsmoothContact::addOverlaps
(
    const PtrList<immersedBody>& bodies
)
{
    scalar largest = 0;

    projection().clear();

    for (const contactMover& m : movers_)
    {
        projection().append
        (
            velocityProjection::body
            {
                Zero, Zero, m.inverseMass, m.inverseInertia
            }
        );
    }

    for (const touch& t : touches_)
    {
        const candidate& c = candidates()[t.candidate];
        const scalar gap = t.point.gap;
        const bool holds = t.record.holds();

        velocityProjection::contact k(contactOf(t, gap, 0, 0));

        if (holds)
        {
            k.least = -GREAT;
            k.softness = softness;
        }

        if (projection().append(k))
        {
            largest = max
            (
                largest,
                2*(holds ? mag(gap) : -gap)/movers_.width(c)
            );
        }
    }

    return movers_.ranks().largest(largest);
}


void Foam::contactModels::nonsmoothContact::projectPoses
(
    PtrList<immersedBody>& bodies,
    const wallFacets& walls
)
{
    scalar last = GREAT;

    for (label pass = 0; pass < maxPasses; ++pass)
    {
        place(bodies);
        findTouches(bodies, walls);

        const scalar overlap = addOverlaps(bodies);

        if (overlap <= smallOverlap || overlap > 0.5*last)
        {
            return;
        }
        last = overlap;

        solve(0.1*smallOverlap*smallestHalfWidth(bodies));

        forAll(movers_, i)
        {
            contactMover& m = movers_[i];
            const velocityProjection::body& way = projection()[i];

            m.state.move(1, way.U, way.omega);
            m.displaced = m.displaced
             || way.U != vector::zero || way.omega != vector::zero;
        }
    }
}


void Foam::contactModels::nonsmoothContact::keepTouches(const scalar h)
{
    for (candidate& c : candidates())
    {
        c.shift += h*c.velocity;
    }
    for (meeting& m : meetings_)
    {
        m.records.clear();
    }

    for (const touch& t : touches_)
    {
        if (t.record.live())
        {
            meetingOf(candidates()[t.candidate]).records.append(t.record);
        }
    }
}
