// SPDX-License-Identifier: GPL-3.0-or-later

#include "gapFilms.H"

Foam::lubricationModel::film Foam::gapFilms::gapOf
(
    const PtrList<immersedBody>& bodies,
    const UList<scalar>& h,
    const pair& p
) const
{
    const label bodya = movers_[p.a].body;
    const label bodyb = p.b < 0 ? -1 : movers_[p.b].body;
    const bool round =
        bodies[bodya].shape().round()
     && (p.b < 0 || bodies[bodyb].shape().round());

    lubricationModel::film film{-1, h[bodya]};

    if (round)
    {
        const scalar Ra = bodies[bodya].shape().boundingRadius();

        film.radius = Ra;
        if (p.b >= 0)
        {
            const scalar Rb = bodies[bodyb].shape().boundingRadius();

            film.radius *= Rb/(Ra + Rb);
            film.cell = 0.5*(h[bodya] + h[bodyb]);
        }
    }

    return film;
}


Foam::scalarField Foam::gapFilms::reach(const UList<scalar>& h) const
{
    scalarField lengths(h.size());

    forAll(lengths, i)
    {
        lengths[i] = model_.range(h[i]);
    }

    return lengths;
}


void Foam::gapFilms::setPairs
(
    const PtrList<immersedBody>& bodies,
    const UList<scalar>& h
)
{
    gaps_.clear();

    if (!active())
    {
        return;
    }
    for (const pair& p : movers_.pairs())
    {
        gaps_.append(gapOf(bodies, h, p));
    }
    turns_.setPairs(bodies);
}


void Foam::gapFilms::add(const label pairi, const contactPoint& point)
{
    if (gaps_.empty())
    {
        return;
    }

    if (gaps_[pairi].radius > 0 && point.gap < range(pairi))
    {
        const vector U
        (
            movers_.relativeVelocity
            (
                movers_.pairs()[pairi], point.position, point.wallU
            )
        );

        films_.append(film{pairi, point, U & point.normal});
    }
}
