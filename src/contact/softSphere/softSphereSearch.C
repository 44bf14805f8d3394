// SPDX-License-Identifier: GPL-3.0-or-later

#include "softSphere.H"

Foam::scalarField Foam::contactModels::softSphere::likelyWays
(
    const PtrList<immersedBody>& bodies,
    const scalar dt,
    const vector& meshU
)
{
    scalarField lengths(contactMovers::ways(bodies, dt, meshU));
    const scalar mean = movers_.ranks().mean(lengths);
    const scalar largest = movers_.ranks().largest(lengths);

    // One that is hit may go as far as the fastest, which costs little where
    // that is less than a radius
    forAll(lengths, i)
    {
        lengths[i] = max
        (
            1.25*max(lengths[i], mean),
            min(2*largest, bodies[i].shape().boundingRadius())
        );
    }

    return lengths;
}


bool Foam::contactModels::softSphere::search
(
    PtrList<immersedBody>& bodies,
    const UList<scalar>& h,
    wallFacets& walls,
    const periodicity& periods,
    const scalar dt,
    const UList<scalar>& furthest
)
{
    const scalarField range(films_.reach(h));

    if
    (
        !movers_.search
        (
            bodies, walls, periods, dt, furthest, 0.5*range, range
        )
    )
    {
        return false;
    }

    touches_.reset();
    moverMaterials_.clear();

    for (const contactMover& m : movers_)
    {
        moverMaterials_.append
        (
            materials_.active()
          ? materials_.number(bodies[m.body].kind().material())
          : -1
        );
    }

    findMeetings(bodies);
    films_.setPairs(bodies, h);

    clearance_.reset(movers_.size());
    slideSpeed_ = 0;

    for (const candidate& c : candidates())
    {
        keepOwn(c);
        clearance_.append(c.a, c.b);
        slideSpeed_ = max(slideSpeed_, mag(c.velocity));
    }

    return true;
}


void Foam::contactModels::softSphere::keepOwn(const candidate& c)
{
    if (c.b < 0 || c.meeting < 0)
    {
        return;
    }

    DynamicList<contactHistory::record>& records =
        meetings_[c.meeting].records;

    if (records.size() > 1)
    {
        const vector apart
        (
            movers_[c.b].state.position + c.shift
          - movers_[c.a].state.position
        );
        const contactHistory::record* mine =
            contactHistory::nearest(records, normalised(apart));
        const contactHistory::record kept
        (
            mine ? *mine : contactHistory::record()
        );

        records = DynamicList<contactHistory::record>(1, kept);
    }
}


Foam::scalar Foam::contactModels::softSphere::shortestTime
(
    const scalar dt
) const
{
    scalarField speeds(movers_.size()), inverseMasses(movers_.size());

    forAll(movers_, i)
    {
        const contactMover& m = movers_[i];
        const vector& U = m.state.U;

        speeds[i] = max(mag(U), mag(U + dt*m.acceleration));
        inverseMasses[i] = cmptMax(m.inverseMass);
    }

    scalar shortest = GREAT;

    for (const candidate& c : candidates())
    {
        scalar inverseMass = inverseMasses[c.a];
        scalar approach = speeds[c.a];

        if (c.b >= 0)
        {
            inverseMass += inverseMasses[c.b];
            approach += speeds[c.b] + mag(c.velocity);
        }

        contactLaw::contact touch;
        touch.mass = 1/inverseMass;
        touch.halfWidth = 0.5*movers_.width(c);
        touch.radius = touch.halfWidth;
        touch.coefficients = materials_.largest();

        shortest = min(shortest, law_->collisionTime(touch, approach, dt));
    }

    for (const meeting& m : meetings_)
    {
        for (const contactHistory::record& r : m.records)
        {
            shortest = r.live() ? min(shortest, r.time) : shortest;
        }
    }

    return movers_.ranks().shared()
      ? returnReduce(shortest, minOp<scalar>())
      : shortest;
}
