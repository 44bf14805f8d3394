// SPDX-License-Identifier: GPL-3.0-or-later

#include "velocityProjection.H"

namespace
{
    //- Part of the largest speed below which violations are rounding
    const Foam::scalar rounding = 1e-6;
}


Foam::velocityProjection::velocityProjection
(
    const scalar tolerance,
    const label maxIter
)
:
    tolerance_(tolerance),
    maxIter_(maxIter),
    nIterations_(0),
    residual_(0)
{
    clear();
}


void Foam::velocityProjection::clear()
{
    bodies_.clear();
    rows_.clear();
    append(body{Zero, Zero, Zero, Zero});
}


void Foam::velocityProjection::append(const body& b)
{
    bodies_.append(b);
}


bool Foam::velocityProjection::append(const contact& c)
{
    row r;

    r.a = c.a + 1;
    r.b = c.b < 0 ? 0 : c.b + 1;
    r.normal = c.normal;
    r.offset = c.offset;
    r.least = c.least;
    r.impulse = c.impulse;
    r.slope = r.direction = r.response = 0;
    r.free = false;
    r.elsewhere = c.elsewhere;

    const body& a = bodies_[r.a];
    const body& b = bodies_[r.b];

    r.turna = c.arma^c.normal;
    r.turnb = c.b < 0 ? vector::zero : vector(c.armb^c.normal);

    // A body and an image of itself: all that counts is that it turns
    if (r.a == r.b)
    {
        r.turnb -= r.turna;
        r.normal = r.turna = Zero;
    }

    r.dUa = cmptMultiply(a.inverseMass, r.normal);
    r.dUb = cmptMultiply(b.inverseMass, r.normal);
    r.dOmegaa = a.inverseInertia & r.turna;
    r.dOmegab = b.inverseInertia & r.turnb;
    r.diagonal =
        (r.normal & (r.dUa + r.dUb))
      + (r.turna & r.dOmegaa) + (r.turnb & r.dOmegab);

    r.softness = c.softness*r.diagonal;
    r.diagonal += r.softness;

    const scalar most =
        cmptMax(a.inverseMass) + cmptMax(b.inverseMass);
    const bool givesWay = r.diagonal > SMALL*most;

    if (givesWay)
    {
        rows_.append(r);
    }

    return givesWay;
}


Foam::scalar Foam::velocityProjection::largestResidual() const
{
    scalar most = 0;

    for (const row& r : rows_)
    {
        const scalar spare = r.diagonal*(r.impulse - r.least);

        most = max(most, mag(min(opening(r), spare)));
    }

    return largest(most);
}


Foam::scalar Foam::velocityProjection::limit() const
{
    scalar most = 0;

    for (const row& r : rows_)
    {
        const scalar w = opening(r);
        const body& a = bodies_[r.a];
        const body& b = bodies_[r.b];

        most = max(most, r.least < 0 ? mag(w) : -w);
        most = max
        (
            most,
            rounding
           *(
                mag(a.U) + mag(b.U)
              + mag(r.turna)*mag(a.omega) + mag(r.turnb)*mag(b.omega)
            )
        );
    }

    return tolerance_*largest(most);
}


bool Foam::velocityProjection::solve(const scalar floor)
{
    complete(bodies_);

    const scalar small = max(limit(), floor);

    for (row& r : rows_)
    {
        // A guess is of no use where there is nothing to be done
        r.impulse = small > 0 ? max(r.least, r.impulse) : 0;
        push(r, r.impulse, bodies_);
    }
    complete(bodies_);

    changes_ = bodies_;
    nIterations_ = 0;
    scalar left = small > 0 ? largestResidual() : 0;

    while (left > small && nIterations_ < maxIter_)
    {
        ++nIterations_;

        // What a sweep changes is near the residual before it
        if (sweep() <= small)
        {
            left = largestResidual();
        }

        if (left > small && nIterations_ < maxIter_)
        {
            conjugateSteps(small);
            left = largestResidual();
        }
    }

    residual_ = small > 0 ? tolerance_*left/small : 0;

    return left <= small;
}
