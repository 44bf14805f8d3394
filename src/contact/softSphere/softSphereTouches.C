// SPDX-License-Identifier: GPL-3.0-or-later

#include "softSphere.H"

namespace
{

//- Mean of the overlap over a sub-step h [s] in which the gap changes at the
//  rate -closing [m/s] from half before to half after the given one, and the
//  part of the sub-step in which they overlap
void meanOverlap
(
    const Foam::scalar gap,
    const Foam::scalar closing,
    const Foam::scalar h,
    Foam::scalar& overlap,
    Foam::scalar& fraction
)
{
    const Foam::scalar half = 0.5*h*Foam::mag(closing);
    const Foam::scalar least = -gap - half, most = -gap + half;

    if (most <= 0)
    {
        overlap = fraction = 0;
    }
    else if (least >= 0)
    {
        overlap = -gap;
        fraction = 1;
    }
    else
    {
        fraction = most/(most - least);
        overlap = 0.5*most*fraction;
    }
}

} // End anonymous namespace


Foam::Pair<Foam::scalar> Foam::contactModels::softSphere::inverseMasses
(
    const candidate& c,
    const point& x,
    const vector& n
) const
{
    Pair<scalar> sums(0, 0);

    auto add = [&](const contactMover& m, const vector& r)
    {
        const scalar along = m.inverseMass & vector(cmptMultiply(n, n));

        // Of round bodies the same for all directions in the plane
        const tensor& I = m.inverseInertia;
        const label nAxes = (I.xx() > 0) + (I.yy() > 0) + (I.zz() > 0);

        sums.first() += along;
        sums.second() += along + magSqr(r)*tr(I)/max(nAxes, label(1));
    };

    add(movers_[c.a], x - movers_[c.a].state.position);
    if (c.b >= 0)
    {
        add(movers_[c.b], x - c.shift - movers_[c.b].state.position);
    }

    return sums;
}


Foam::contactHistory::record& Foam::contactModels::softSphere::recordOf
(
    const PtrList<immersedBody>& bodies,
    candidate& c,
    const vector& normal
) const
{
    contactHistory::record* known =
        contactHistory::nearest(c.records, normal);

    if (known)
    {
        return *known;
    }

    // In the place of one that has ended, if there is one
    label place = 0;
    while (place < c.records.size() && c.records[place].live())
    {
        ++place;
    }
    if (place == c.records.size())
    {
        c.records.append(contactHistory::record());
    }

    contactHistory::record& r = c.records[place];

    r.bodies = movers_.bodyNumbers(bodies, c);

    return r;
}


void Foam::contactModels::softSphere::addTouch
(
    const PtrList<immersedBody>& bodies,
    const label candidatei,
    const contactPoint& wall,
    const scalar h,
    const scalar dt
)
{
    candidate& c = candidates_[candidatei];
    contactPoint point(wall);

    if (c.b < 0 && rough_ && !meetSlope(bodies, candidatei, h, point))
    {
        return;
    }

    const scalar closing =
        movers_.relativeVelocity(c, point.position, point.wallU) & point.normal;
    touch t;

    meanOverlap
    (
        point.gap, closing, h, t.contact.overlap, t.contact.fraction
    );
    const Pair<scalar> inverse(inverseMasses(c, point.position, point.normal));

    if (t.contact.fraction <= 0 || inverse.first() <= 0)
    {
        return;
    }

    contactHistory::record& r = recordOf(bodies, c, wall.normal);

    t.candidate = candidatei;
    t.record = &r - c.records.cdata();
    t.position = point.position;
    t.gap = point.gap;
    t.wallU = point.wallU;
    t.force = Zero;
    t.contact.normal = point.normal;
    t.contact.dt = h;
    t.contact.mass = 1/inverse.first();
    t.contact.tangentialMass = 1/inverse.second();
    t.contact.radius = contactRadius(bodies, c, point.normal);
    t.contact.halfWidth = 0.5*movers_.width(bodies, c);

    r.speed = r.live() ? r.speed : max(closing, scalar(0));
    t.contact.coefficients = coefficients(c, point).at(r.speed);
    t.rollingMass = t.contact.coefficients.rollingFriction > 0
      ? rollingMass(c, t.contact.radius) : 0;

    if (!r.live())
    {
        // One that is faster than the search knew has fewer sub-steps
        r.spring = r.rolling = Zero;
        r.time = max
        (
            law_->collisionTime(t.contact, mag(closing), dt),
            0.5*subSteps_*h
        );
    }

    r.normal = wall.normal;
    t.contact.time = r.time;
    touches_.append(t);
}


void Foam::contactModels::softSphere::findTouches
(
    PtrList<immersedBody>& bodies,
    const wallFacets& walls,
    const scalar h,
    const scalar dt
)
{
    touches_.clear();
    films_.clear();

    forAll(candidates_, i)
    {
        candidate& c = candidates_[i];
        immersedBody& a = bodies[movers_[c.a].body];
        const label first = touches_.size();

        if (c.b < 0)
        {
            movers_[c.a].place(a);

            const DynamicList<contactPoint> points
            (
                walls.contacts(movers_[c.a].body, a)
            );

            for (const contactPoint& point : points)
            {
                addTouch(bodies, i, point, h, dt);
                addFilm(i, point);
            }
        }
        else if (!apart(i, h))
        {
            immersedBody& b = bodies[movers_[c.b].body];

            movers_[c.a].place(a);
            movers_[c.b].place(b);

            const contactPoint point(a, b, c.shift);

            addTouch(bodies, i, point, h, dt);
            addFilm(i, point);
        }

        endContacts(c, first);
    }
}


void Foam::contactModels::softSphere::endContacts
(
    candidate& c,
    const label first
) const
{
    forAll(c.records, k)
    {
        bool touched = false;
        for (label l = first; l < touches_.size(); ++l)
        {
            touched = touched || touches_[l].record == k;
        }

        if (!touched)
        {
            c.records[k] = contactHistory::record();
        }
    }
}
