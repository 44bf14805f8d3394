// SPDX-License-Identifier: GPL-3.0-or-later

#include "recycledKrylov.H"

namespace
{
    //- What is left of a direction, over all of it, if it says nothing new
    const Foam::scalar nothingNew = 1e-12;

    //- Ratio of a residual to that before from which on a step is of no use
    const Foam::scalar stuck = 0.999;

    //- Times that a solution begins anew from its true residual
    const Foam::label maxCycles = 10;

    //- Part of a direction that has to be left for once to be enough
    const Foam::scalar orthogonal = 0.5;


    //- Inner product. In four sums, none of which waits for the last addition:
    //  most of the time would go by in it.
    Foam::scalar inner
    (
        const Foam::scalarField& x,
        const Foam::scalarField& y
    )
    {
        const Foam::label n = x.size(), whole = n - n % 4;
        Foam::scalar sums[4] = {0, 0, 0, 0};

        for (Foam::label i = 0; i < whole; i += 4)
        {
            for (Foam::label j = 0; j < 4; ++j)
            {
                sums[j] += x[i + j]*y[i + j];
            }
        }
        for (Foam::label i = whole; i < n; ++i)
        {
            sums[0] += x[i]*y[i];
        }

        return Foam::returnReduce
        (
            sums[0] + sums[1] + sums[2] + sums[3],
            Foam::sumOp<Foam::scalar>()
        );
    }


    Foam::scalar norm(const Foam::scalarField& x)
    {
        return Foam::sqrt(inner(x, x));
    }
}


Foam::recycledKrylov::recycledKrylov
(
    const product& S,
    const product& preconditioner,
    const label most
)
:
    S_(S),
    preconditioner_(preconditioner),
    most_(most),
    nIterations_(0)
{}


void Foam::recycledKrylov::takeOff
(
    const label first,
    scalarField& r,
    scalarField& y
) const
{
    const label n = r.size();

    for (label i = first; i < c_.size(); ++i)
    {
        const scalarField& c = c_[i];
        const scalar part = inner(c, r);

        y[i] += part;

        for (label j = 0; j < n; ++j)
        {
            r[j] -= part*c[j];
        }
    }
}


bool Foam::recycledKrylov::append(const scalarField& c)
{
    const label n = c_.size();
    autoPtr<scalarField> z(new scalarField(preconditioner_(c)));
    autoPtr<scalarField> next(new scalarField(S_(z())));
    autoPtr<scalarField> column(new scalarField(n + 1, Zero));
    const scalar whole = norm(next());

    takeOff(0, next(), column());

    scalar rest = norm(next());

    // Twice is enough
    if (rest < orthogonal*whole)
    {
        takeOff(0, next(), column());
        rest = norm(next());
    }

    if (!(rest > nothingNew*whole))
    {
        return false;
    }
    next() /= rest;
    column()[n] = rest;

    z_.append(z);
    c_.append(next);
    R_.append(column);

    return true;
}


void Foam::recycledKrylov::addTo(scalarField& x, const scalarField& y) const
{
    scalarField t(y);

    for (label i = t.size() - 1; i >= 0; --i)
    {
        t[i] /= R_[i][i];

        for (label j = 0; j < i; ++j)
        {
            t[j] -= R_[i][j]*t[i];
        }
        x += t[i]*z_[i];
    }
}


Foam::scalar Foam::recycledKrylov::solve
(
    const scalarField& b,
    const scalar tolerance,
    const label maxIter,
    scalarField& x
)
{
    const scalar size = norm(b);
    scalar ratio = size > 0 ? 1 : 0;
    scalarField r(b);
    label left = maxIter;

    x = scalarField(b.size(), Zero);

    for (label i = 0; i < maxCycles && left > 0 && ratio > tolerance; ++i)
    {
        scalarField y(c_.size(), Zero);
        takeOff(0, r, y);
        ratio = norm(r)/size;
        scalarField last(r);

        while (left > 0 && ratio > tolerance && c_.size() < most_)
        {
            --left;
            ++nIterations_;

            if (!append(last))
            {
                break;
            }
            y.append(0);
            takeOff(c_.size() - 1, r, y);

            // The residual shows the way, unless the step has hardly changed it
            const scalar before = ratio;

            ratio = norm(r)/size;
            last = ratio < stuck*before ? r : c_[c_.size() - 1];
        }

        addTo(x, y);
        r = b - S_(x)();
        ratio = norm(r)/size;

        if (ratio > tolerance)
        {
            z_.clear();
            c_.clear();
            R_.clear();
        }
    }

    return ratio;
}
