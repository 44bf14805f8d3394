// SPDX-License-Identifier: GPL-3.0-or-later

#include "slidingSeparators.H"
#include "compat.H"
#include "SubField.H"

Foam::slidingSeparators::slidingSeparators
(
    const slabs& parts,
    const slidingModes& modes
)
:
    modes_(modes),
    n_(parts.size()),
    mine_(parts.mine())
{}


void Foam::slidingSeparators::assemble
(
    const scalarField& atHigh,
    const scalarField& atLow,
    const scalarField& between,
    const bool singular
)
{
    const label nModes = modes_.size();

    pivots_ = scalarField(n_*nModes, Zero);
    links_ = pivots_;
    corner_ = scalarField(nModes, Zero);

    // The low separator of the first slab is the last one
    scalarField& link = mine_ == 0 ? corner_ : links_;
    const label start = mine_ == 0 ? 0 : low(mine_)*nModes;

    for (label m = 0; m < nModes; ++m)
    {
        at(pivots_, mine_)[m] += atHigh[m];
        at(pivots_, low(mine_))[m] += atLow[m];
        link[start + m] += between[m];
    }
    for (scalarField* values : {&pivots_, &links_, &corner_})
    {
        compat::allReduce(*values, plusEqOp<scalar>());
    }

    if (singular)
    {
        // With the last unknown 0 a singular system is solved as well
        at(pivots_, n_ - 1)[0] = GREAT;
        corner_[0] = 0;
    }

    // Elimination, from the first separator on
    for (label i = 0; i < n_; ++i)
    {
        for (label m = 0; m < nModes; ++m)
        {
            scalar& pivot = at(pivots_, i)[m];

            if (i > 0)
            {
                pivot -= sqr(at(links_, i - 1)[m])*at(pivots_, i - 1)[m];
            }
            pivot = 1/pivot;
        }
    }

    fromHigh_ = scalarField(n_*nModes, Zero);
    fromLow_ = fromHigh_;
    std::fill_n(at(fromHigh_, 0), nModes, scalar(1));
    std::fill_n(at(fromLow_, n_ - 1), nModes, scalar(1));
    solveT(fromHigh_);
    solveT(fromLow_);
}


void Foam::slidingSeparators::solveT(scalarField& x) const
{
    const label nModes = modes_.size();

    for (label i = nModes; i < n_*nModes; ++i)
    {
        x[i] -= links_[i - nModes]*pivots_[i - nModes]*x[i - nModes];
    }
    for (label i = n_*nModes - 1; i >= 0; --i)
    {
        x[i] *= pivots_[i];

        if (i >= nModes)
        {
            x[i - nModes] -= links_[i - nModes]*x[i];
        }
    }
}


void Foam::slidingSeparators::solveMode(const label m) const
{
    const label nModes = modes_.size();
    const label other = modes_.partner(m);
    const label last = (n_ - 1)*nModes;
    const bool real = other == m;
    const complex one(1, 0);
    const complex p(corner_[m]*modes_.phase(m));
    const complex q(p.Re(), -p.Im());

    auto value = [&](const label start)
    {
        return complex(g_[start + m], real ? 0 : g_[start + other]);
    };

    // With the factors that the columns h and l have
    complex xh, xl;

    if (n_ == 1)
    {
        xh = xl = value(0)/(one + (p + q)*fromHigh_[m]);
    }
    else
    {
        const complex a(one + p*fromLow_[m]);
        const complex b(q*fromHigh_[m]);
        const complex c(p*fromLow_[last + m]);
        const complex d(one + q*fromHigh_[last + m]);
        const complex det(a*d - b*c);

        xh = (d*value(0) - b*value(last))/det;
        xl = (a*value(last) - c*value(0))/det;
    }

    for (label start = 0; start <= last; start += nModes)
    {
        const complex x
        (
            value(start)
          - p*xh*fromLow_[start + m] - q*xl*fromHigh_[start + m]
        );

        g_[start + m] = x.Re();
        if (!real)
        {
            g_[start + other] = x.Im();
        }
    }
}


void Foam::slidingSeparators::solve
(
    scalarField& atHigh,
    scalarField& atLow
) const
{
    const label nModes = modes_.size();

    g_.setSize(n_*nModes);
    g_ = 0;

    for (label m = 0; m < nModes; ++m)
    {
        at(g_, mine_)[m] += atHigh[m];
        at(g_, low(mine_))[m] += atLow[m];
    }
    compat::allReduce(g_, plusEqOp<scalar>());

    solveT(g_);

    for (label m = 0; m < nModes; ++m)
    {
        if (modes_.leads(m))
        {
            solveMode(m);
        }
    }

    std::copy_n(at(g_, mine_), nModes, atHigh.begin());
    std::copy_n(at(g_, low(mine_)), nModes, atLow.begin());
}
