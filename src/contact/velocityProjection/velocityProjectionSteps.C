// SPDX-License-Identifier: GPL-3.0-or-later

#include "velocityProjection.H"

namespace
{
    //- Part of the residual that is left when sweeps take over: they find out
    //  which contacts push
    const Foam::scalar phase = 0.01;
}


Foam::scalar Foam::velocityProjection::sweep()
{
    scalar most = 0;

    for (row& r : rows_)
    {
        const scalar after =
            max(r.least, r.impulse - opening(r)/r.diagonal);
        const scalar change = after - r.impulse;

        r.free = r.impulse > r.least && after > r.least;

        if (change != 0)
        {
            r.impulse = after;
            push(r, change, bodies_);
            most = max(most, r.diagonal*mag(change));
        }
    }

    return most;
}


Foam::scalar Foam::velocityProjection::startDirections()
{
    scalar most = 0;

    for (row& r : rows_)
    {
        r.slope = r.free ? -opening(r) : 0;
        r.direction = r.slope/r.diagonal;
        most = max(most, mag(r.slope));
    }

    return largest(most);
}


Foam::scalar Foam::velocityProjection::along()
{
    for (body& b : changes_)
    {
        b.U = b.omega = Zero;
    }
    for (const row& r : rows_)
    {
        push(r, r.direction, changes_);
    }
    complete(changes_);

    // Of slopes along the direction, of work, and the least that this may be
    vector sums(Zero);

    for (row& r : rows_)
    {
        r.response = r.free
          ? speed(r, changes_) + r.softness*r.direction
          : 0;
        if (!r.elsewhere)
        {
            sums += r.direction
               *vector(r.slope, r.response, r.diagonal*r.direction);
        }
    }
    sums = total(sums);

    // None along a direction that changes no velocity, as there is one if more
    // contacts push than it takes
    return sums.y() > SMALL*sums.z() ? sums.x()/sums.y() : 0;
}


bool Foam::velocityProjection::cut(const scalar step)
{
    bool any = false;

    for (row& r : rows_)
    {
        const scalar least = r.least - r.impulse;

        if (step*r.direction < least)
        {
            r.direction = least/step;
            any = true;
        }
    }

    return largest(any) > 0;
}


void Foam::velocityProjection::go(const scalar step)
{
    for (row& r : rows_)
    {
        r.impulse = max(r.least, r.impulse + step*r.direction);
        r.free = r.free && r.impulse > r.least;
        r.slope = r.free ? r.slope - step*r.response : 0;
    }
    forAll(bodies_, i)
    {
        bodies_[i].U += step*changes_[i].U;
        bodies_[i].omega += step*changes_[i].omega;
    }
}


Foam::scalar Foam::velocityProjection::slopes(scalar& most) const
{
    scalar sum = 0;
    most = 0;

    for (const row& r : rows_)
    {
        sum += r.elsewhere ? 0 : sqr(r.slope)/r.diagonal;
        most = max(most, mag(r.slope));
    }
    most = largest(most);

    return total(vector(sum, 0, 0)).x();
}


void Foam::velocityProjection::conjugateSteps(const scalar small)
{
    const scalar enough = max(small, phase*startDirections());
    scalar left = GREAT;

    while (left > enough && nIterations_ < maxIter_)
    {
        scalar step = along();
        const bool bent = cut(step);

        // On the way to the best point some contacts cease to push: along what
        // is left of the direction another one is best
        if (bent)
        {
            step = min(step, along());
        }
        if (step <= 0)
        {
            return;
        }

        const scalar before = slopes(left);
        go(step);
        ++nIterations_;

        if (bent)
        {
            return;
        }

        const scalar beta = slopes(left)/before;

        for (row& r : rows_)
        {
            r.direction = r.slope/r.diagonal + beta*r.direction;
        }
    }
}
