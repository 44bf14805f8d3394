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


void Foam::contactModels::softSphere::addTouch
(
    const PtrList<immersedBody>& bodies,
    const label candidatei,
    const contactPoint& wall,
    const scalar h,
    const scalar dt
)
{
    candidate& c = candidates()[candidatei];
    contactPoint point(wall);

    if (c.b < 0 && rough_ && !meetSlope(bodies, candidatei, h, point))
    {
        return;
    }

    const scalar closing =
        movers_.relativeVelocity(c, point.position, point.wallU) & point.normal;
    softTouches::touch t;

    meanOverlap
    (
        point.gap, closing, h, t.contact.overlap, t.contact.fraction
    );
    const Pair<scalar> inverse
    (
        movers_.inverseMasses(c, point.position, point.normal)
    );

    if (t.contact.fraction <= 0 || inverse.first() <= 0)
    {
        return;
    }

    contactHistory::record& r = recordOf(bodies, c, wall.normal);

    t.pairi = candidatei;
    t.record = &r - meetingOf(c).records.cdata();
    t.position = point.position;
    t.gap = point.gap;
    t.wallU = point.wallU;
    t.force = Zero;
    t.contact.normal = point.normal;
    t.contact.dt = h;
    t.contact.mass = 1/inverse.first();
    t.contact.tangentialMass = 1/inverse.second();
    t.contact.radius = contactRadius(bodies, c, point.normal);
    t.contact.halfWidth = 0.5*movers_.width(c);

    r.speed = r.live() ? r.speed : max(closing, scalar(0));
    t.contact.coefficients = coefficients(c, point).at(r.speed);
    t.rollingMass = t.contact.coefficients.rollingFriction > 0
      ? touches_.rollingMass(c, t.contact.radius) : 0;

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


void Foam::contactModels::softSphere::meetWalls
(
    PtrList<immersedBody>& bodies,
    const wallFacets& walls,
    const label candidatei,
    const scalar h,
    const scalar dt
)
{
    const contactMover& m = movers_[candidates()[candidatei].a];
    scalar reach = m.radius;

    // What the gap of a smooth body may close by in the sub-step, as the search
    // costs more within reach; films are of round ones
    if (!m.round && m.smooth)
    {
        reach = h
           *(
                mag(m.state.U) + m.radius*mag(m.state.omega)
              + walls.maxSpeedBeside(m.body)
            );
    }

    m.place(bodies[m.body]);

    const DynamicList<contactPoint> points
    (
        walls.contacts(m.body, bodies[m.body], reach)
    );

    for (const contactPoint& point : points)
    {
        addTouch(bodies, candidatei, point, h, dt);
        films_.add(candidatei, point);
    }
}
