// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactMovers.H"

namespace
{
    //- Part of the way of a body that it may go further in a later iteration of
    //  the time step without a new search
    const Foam::scalar spareWay = 0.1;
}


Foam::label Foam::contactMovers::moverOf(const label bodyi)
{
    if (numbers_[bodyi] < 0)
    {
        numbers_[bodyi] = movers_.size();
        movers_.append(bodyi);
    }

    return numbers_[bodyi];
}


void Foam::contactMovers::findPairs
(
    const PtrList<immersedBody>& bodies,
    const UList<closePairs::pair>& close,
    const wallFacets& walls,
    const scalar dt
)
{
    for (const closePairs::pair& p : close)
    {
        const bool needed = ranks_.mine(p.a) || ranks_.mine(p.b);

        if (needed && (bodies[p.a].isFree() || bodies[p.b].isFree()))
        {
            pair found;

            found.a = moverOf(p.a);
            found.b = moverOf(p.b);

            // The step begins where sliding images have been
            found.shift = p.shift - dt*p.velocity;
            found.velocity = p.velocity;
            pairs_.append(found);
        }
    }

    forAll(bodies, i)
    {
        if (ranks_.mine(i) && bodies[i].isFree() && walls.beside(i))
        {
            pair found;

            found.a = moverOf(i);
            pairs_.append(found);
        }
    }
}


Foam::scalarField Foam::contactMovers::ways
(
    const PtrList<immersedBody>& bodies,
    const scalar dt,
    const vector& meshU
)
{
    scalarField lengths(bodies.size());

    forAll(bodies, i)
    {
        const bodyState& old = bodies[i].motion().old();
        const bodyState& end = bodies[i].state();
        const bodyShape& shape = bodies[i].shape();
        const scalar spin =
            shape.round() ? 0 : max(mag(old.omega), mag(end.omega));

        lengths[i] = dt
           *(
                max(speed(old.U, meshU), speed(end.U, meshU))
              + shape.boundingRadius()*spin
            );
    }

    return lengths;
}


bool Foam::contactMovers::within(UList<scalar>& furthest) const
{
    bool all = true;

    forOutcomes([&](const outcome& e)
    {
        if (e.way > furthest[e.body])
        {
            furthest[e.body] = 2*e.way;
            all = false;
        }
    });

    return ranks_.spread() ? returnReduce(all, andOp<bool>()) : all;
}


bool Foam::contactMovers::search
(
    const PtrList<immersedBody>& bodies,
    wallFacets& walls,
    const periodicity& periods,
    const scalar dt,
    const UList<scalar>& furthest,
    const UList<scalar>& aroundBody,
    const UList<scalar>& aroundWall
)
{
    pointField centres(bodies.size());
    scalarField radii(bodies.size()), reach(bodies.size());
    scalarField spare(bodies.size());
    const scalar slide = dt*mag(periods.slideVelocity());

    forAll(bodies, i)
    {
        const scalar radius =
            bodies[i].shape().boundingRadius() + furthest[i] + slide;

        centres[i] = bodies[i].motion().old().position;
        radii[i] = radius + aroundBody[i];
        reach[i] = bodies[i].isFree() ? radius + aroundWall[i] : 0;
        spare[i] = spareWay*furthest[i];
    }

    const DynamicList<closePairs::pair>& close =
        near_.find(centres, radii, spare, periods, ranks_.share());

    walls.update
    (
        centres, reach, periods, ranks_.spread() ? &ranks_.held() : nullptr
    );

    clear();
    movers_.clear();
    pairs_.clear();
    exchange_.clear();
    numbers_.setSize(bodies.size());
    numbers_ = -1;

    findPairs(bodies, close, walls, dt);

    // Large as they are, without room for more
    if (movers_.size() > capacity())
    {
        clearStorage();
        setCapacity(movers_.size());
    }
    for (const label bodyi : movers_)
    {
        append(contactMover(bodies, bodyi, dt));
    }

    if (ranks_.shared())
    {
        connect();
        return returnReduce(pairs_.size(), sumOp<label>()) > 0;
    }

    return !pairs_.empty();
}


Foam::scalar Foam::contactMovers::width(const pair& p) const
{
    const scalar a = (*this)[p.a].width;

    return p.b < 0 ? a : min(a, (*this)[p.b].width);
}


Foam::vector Foam::contactMovers::relativeVelocity
(
    const pair& p,
    const point& x,
    const vector& wallU
) const
{
    const vector U((*this)[p.a].state.velocity(x));

    return p.b < 0
      ? vector(U - wallU)
      : vector(U - p.velocity - (*this)[p.b].state.velocity(x - p.shift));
}


Foam::Pair<Foam::scalar> Foam::contactMovers::inverseMasses
(
    const pair& p,
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

    add((*this)[p.a], x - (*this)[p.a].state.position);
    if (p.b >= 0)
    {
        add((*this)[p.b], x - p.shift - (*this)[p.b].state.position);
    }

    return sums;
}


void Foam::contactMovers::addImpulse
(
    const pair& p,
    const point& x,
    const vector& impulse,
    sums& to
) const
{
    to.impulse += impulse;
    to.contactMoment += impulse*(x - (*this)[p.a].state.position);

    if (p.b >= 0)
    {
        to.contactMoment -=
            impulse*(x - p.shift - (*this)[p.b].state.position);
    }
}


void Foam::contactMovers::putBack(PtrList<immersedBody>& bodies) const
{
    for (const contactMover& m : *this)
    {
        bodies[m.body].setState(m.end);
    }
}


void Foam::contactMovers::setContact
(
    PtrList<immersedBody>& bodies,
    const scalar dt
) const
{
    forOutcomes([&](const outcome& e)
    {
        bodyState pose;

        pose.position = e.position;
        pose.orientation = e.orientation;
        bodies[e.body].setContact(pose, e.dU, e.dOmega, (1/dt)*e.impulse);
    });
}


Foam::contactModel::pairMoment Foam::contactMovers::moment
(
    const pair& p,
    const sums& done,
    const scalar dt
) const
{
    return contactModel::pairMoment
    {
        (*this)[p.a].body,
        p.b < 0 ? -1 : (*this)[p.b].body,
        p.shift,
        done.impulse/dt,
        done.contactMoment/dt,
        done.filmMoment/dt
    };
}
