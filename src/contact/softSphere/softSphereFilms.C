// SPDX-License-Identifier: GPL-3.0-or-later

#include "softSphere.H"

void Foam::contactModels::softSphere::addFilm
(
    const label candidatei,
    const contactPoint& point
)
{
    if (gaps_.empty())
    {
        return;
    }

    const candidate& c = candidates()[candidatei];
    const lubricationModel::film& film = gaps_[candidatei];

    if (film.radius > 0 && point.gap < lubrication_.range(film.cell))
    {
        const scalar closing =
            movers_.relativeVelocity(c, point.position, point.wallU) & point.normal;

        films_.append(gapFilm{candidatei, point, closing});
    }
}


Foam::vector Foam::contactModels::softSphere::rollingVelocity
(
    const gapFilm& film
) const
{
    const candidate& c = candidates()[film.candidate];
    const contactMover& a = movers_[c.a];
    const point& x = film.point.position;
    const vector& n = film.point.normal;
    vector U(a.state.velocity(x));

    if (c.b < 0)
    {
        U += film.point.wallU - 2*a.state.U;
    }
    else
    {
        // The middle of the gap moves with the line of centres
        const contactMover& b = movers_[c.b];
        const point xb(x - c.shift);
        const scalar la = mag(x - a.state.position);
        const scalar lb = mag(xb - b.state.position);

        const vector Ub(b.state.U + c.velocity);

        U += b.state.velocity(xb) + c.velocity;
        U -= 2*(lb*a.state.U + la*Ub)/(la + lb);
    }

    return U - (U & n)*n;
}


Foam::scalar Foam::contactModels::softSphere::inverseRollingMass
(
    const gapFilm& film
) const
{
    const candidate& c = candidates()[film.candidate];
    const point& x = film.point.position;
    const vector& n = film.point.normal;
    const Pair<scalar> masses(inverseMasses(c, x, n));

    // The same as that of sliding, but for the part of translation
    scalar part = 1;
    if (c.b >= 0)
    {
        const scalar la = mag(x - movers_[c.a].state.position);
        const scalar lb = mag(x - c.shift - movers_[c.b].state.position);

        part = sqr((la - lb)/(la + lb));
    }

    return masses.second() - (1 - part)*masses.first();
}


void Foam::contactModels::softSphere::push
(
    const gapFilm& film,
    const vector& impulse,
    const bool rolling
)
{
    candidate& c = candidates()[film.candidate];
    tensor& filmMoment = meetingOf(c).sums.filmMoment;

    // r: of the surface, shear: impulse along it, of which what is not linear
    // is balanced by the pressure
    auto give = [&]
    (
        contactMover& m, const vector& linear, const vector& r, const vector& shear
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
        filmMoment += linear*r + r*(linear - shear);
    };

    contactMover& a = movers_[c.a];
    const vector ra(film.point.position - a.state.position);

    if (c.b < 0)
    {
        give(a, (rolling ? -1 : 1)*impulse, ra, impulse);
        return;
    }

    contactMover& b = movers_[c.b];
    const vector rb(film.point.position - c.shift - b.state.position);
    const scalar la = mag(ra), lb = mag(rb);
    const scalar part = rolling ? (la - lb)/(la + lb) : 1;

    give(a, part*impulse, ra, impulse);
    give(b, -part*impulse, rb, (rolling ? 1 : -1)*impulse);
}


Foam::scalar Foam::contactModels::softSphere::closingAfter
(
    const gapFilm& film,
    const scalar before,
    const scalar inverseMass,
    const scalar h
) const
{
    const lubricationModel::film& f = gaps_[film.candidate];
    const scalar gap = film.point.gap;
    const scalar start = lubrication_.normalSum(f, gap + 0.5*h*film.closing);

    // Grows with the speed after the sub-step, and vanishes for the right one
    auto excess = [&](const scalar after)
    {
        const scalar end = lubrication_.normalSum(f, gap - 0.5*h*after);

        return after - before + inverseMass*(start - end);
    };

    scalar x0 = 0, x1 = before;
    scalar f0 = excess(x0), f1 = excess(x1);

    if (f0*f1 > 0)
    {
        return before/(1 + h*inverseMass*lubrication_.normal(f, gap));
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


void Foam::contactModels::softSphere::lubricate(const scalar h)
{
    for (const gapFilm& film : films_)
    {
        const candidate& c = candidates()[film.candidate];
        const lubricationModel::film& f = gaps_[film.candidate];
        const contactPoint& p = film.point;
        const Pair<scalar> masses(inverseMasses(c, p.position, p.normal));

        if (masses.first() <= 0)
        {
            continue;
        }

        auto resist = [&]
        (
            const vector& U,
            const scalar resistance,
            const scalar inverseMass,
            const bool rolling
        )
        {
            const scalar drag = resistance*h/(1 + h*inverseMass*resistance);

            push(film, -drag*U, rolling);
            energy_.lubrication +=
                drag*(1 - 0.5*drag*inverseMass)*magSqr(U);
        };

        const vector U(movers_.relativeVelocity(c, p.position, p.wallU));
        const scalar before = U & p.normal;
        const scalar after = closingAfter(film, before, masses.first(), h);
        const scalar impulse = (before - after)/masses.first();

        push(film, -impulse*p.normal, false);
        energy_.lubrication += 0.5*impulse*(before + after);

        resist
        (
            U - before*p.normal, lubrication_.sliding(f, p.gap),
            masses.second(), false
        );
        resist
        (
            rollingVelocity(film), lubrication_.rolling(f, p.gap),
            inverseRollingMass(film), true
        );
    }
}
