// SPDX-License-Identifier: GPL-3.0-or-later

#include "gapFilms.H"

Foam::vector Foam::gapFilms::rollingVelocity(const film& f) const
{
    const pair& p = pairOf(f);
    const contactMover& a = movers_[p.a];
    const point& x = f.point.position;
    const vector& n = f.point.normal;
    vector U(a.state.velocity(x));

    if (p.b < 0)
    {
        U += f.point.wallU - 2*a.state.U;
    }
    else
    {
        // The middle of the gap moves with the line of centres
        const contactMover& b = movers_[p.b];
        const point xb(x - p.shift);
        const scalar la = mag(x - a.state.position);
        const scalar lb = mag(xb - b.state.position);

        const vector Ub(b.state.U + p.velocity);

        U += b.state.velocity(xb) + p.velocity;
        U -= 2*(lb*a.state.U + la*Ub)/(la + lb);
    }

    return U - (U & n)*n;
}


Foam::scalar Foam::gapFilms::inverseRollingMass(const film& f) const
{
    const pair& p = pairOf(f);
    const point& x = f.point.position;
    const vector& n = f.point.normal;
    const Pair<scalar> masses(movers_.inverseMasses(p, x, n));

    // The same as that of sliding, but for the part of translation
    scalar part = 1;
    if (p.b >= 0)
    {
        const scalar la = mag(x - movers_[p.a].state.position);
        const scalar lb = mag(x - p.shift - movers_[p.b].state.position);

        part = sqr((la - lb)/(la + lb));
    }

    return masses.second() - (1 - part)*masses.first();
}


void Foam::gapFilms::push
(
    const film& f,
    const vector& impulse,
    const bool rolling,
    tensor& moment
)
{
    const pair& p = pairOf(f);

    // r: of the surface, shear: impulse along it, of which what is not linear
    // is balanced by the pressure
    auto give = [&]
    (
        contactMover& m,
        const vector& linear,
        const vector& r,
        const vector& shear
    )
    {
        const vector angular(r^shear);
        const vector dU(cmptMultiply(m.inverseMass, linear));
        const vector dOmega(m.inverseInertia & angular);

        m.state.U += dU;
        m.state.omega += dOmega;
        m.dU += dU;
        m.dOmega += dOmega;
        m.impulse = m.impulse + rigidMomentum{linear, angular};
        moment += linear*r + r*(linear - shear);
    };

    contactMover& a = movers_[p.a];
    const vector ra(f.point.position - a.state.position);

    if (p.b < 0)
    {
        give(a, (rolling ? -1 : 1)*impulse, ra, impulse);
        return;
    }

    contactMover& b = movers_[p.b];
    const vector rb(f.point.position - p.shift - b.state.position);
    const scalar la = mag(ra), lb = mag(rb);
    const scalar part = rolling ? (la - lb)/(la + lb) : 1;

    give(a, part*impulse, ra, impulse);
    give(b, -part*impulse, rb, (rolling ? 1 : -1)*impulse);
}


Foam::scalar Foam::gapFilms::closingAfter
(
    const film& f,
    const scalar before,
    const scalar inverseMass,
    const scalar h
) const
{
    const lubricationModel::film& of = gaps_[f.pairi];
    const scalar gap = f.point.gap;
    const scalar start = model_.normalSum(of, gap + 0.5*h*f.closing);

    // Grows with the speed after the sub-step, and vanishes for the right one
    auto excess = [&](const scalar after)
    {
        const scalar end = model_.normalSum(of, gap - 0.5*h*after);

        return after - before + inverseMass*(start - end);
    };

    scalar x0 = 0, x1 = before;
    scalar f0 = excess(x0), f1 = excess(x1);

    if (f0*f1 > 0)
    {
        return before/(1 + h*inverseMass*model_.normal(of, gap));
    }

    // False position, with the end that stays pulled in (Illinois)
    for (label i = 0; i < 50 && mag(x1 - x0) > 1e-10*mag(before); ++i)
    {
        const scalar x = x1 - f1*(x1 - x0)/(f1 - f0 + VSMALL);
        const scalar fx = excess(x);

        if (fx*f1 < 0)
        {
            x0 = x1;
            f0 = f1;
        }
        else
        {
            f0 *= 0.5;
        }
        x1 = x;
        f1 = fx;

        if (mag(f1) < 1e-12*mag(before))
        {
            break;
        }
    }

    return x1;
}


Foam::scalar Foam::gapFilms::resistClosing
(
    const film& f,
    const scalar before,
    const scalar inverseMass,
    const scalar h,
    tensor& moment
)
{
    const scalar after = closingAfter(f, before, inverseMass, h);
    const scalar impulse = (before - after)/inverseMass;

    push(f, -impulse*f.point.normal, false, moment);

    return 0.5*impulse*(before + after);
}


Foam::scalar Foam::gapFilms::resist
(
    const film& f,
    const vector& U,
    const scalar resistance,
    const scalar inverseMass,
    const bool rolling,
    const scalar h,
    tensor& moment
)
{
    const scalar drag = resistance*h/(1 + h*inverseMass*resistance);

    push(f, -drag*U, rolling, moment);

    return drag*(1 - 0.5*drag*inverseMass)*magSqr(U);
}


Foam::scalar Foam::gapFilms::act
(
    const film& f,
    const scalar h,
    tensor& moment
)
{
    const pair& p = pairOf(f);
    const lubricationModel::film& of = gaps_[f.pairi];
    const contactPoint& at = f.point;
    const Pair<scalar> masses
    (
        movers_.inverseMasses(p, at.position, at.normal)
    );

    if (masses.first() <= 0)
    {
        return 0;
    }

    const vector U(movers_.relativeVelocity(p, at.position, at.wallU));
    const scalar closing = U & at.normal;
    scalar lost = resistClosing(f, closing, masses.first(), h, moment);

    lost += resist
    (
        f, U - closing*at.normal, model_.sliding(of, at.gap),
        masses.second(), false, h, moment
    );
    lost += resist
    (
        f, rollingVelocity(f), model_.rolling(of, at.gap),
        inverseRollingMass(f), true, h, moment
    );

    return lost;
}


Foam::scalar Foam::gapFilms::act(const scalar h, const moments& momentOf)
{
    labelList pairs(films_.size());
    scalar lost = 0;

    forAll(pairs, i)
    {
        pairs[i] = films_[i].pairi;
    }

    turns_.go
    (
        pairs,
        [&](const label i)
        {
            const film& f = films_[i];
            const scalar loss = act(f, h, momentOf(f.pairi));

            lost += movers_.mine(pairOf(f)) ? loss : 0;
        }
    );

    return lost;
}
