// SPDX-License-Identifier: GPL-3.0-or-later

#include "separatorSystem.H"
#include "exchange.H"
#include <numeric>


Foam::separatorSystem::separatorSystem
(
    const slabs& parts,
    const bool cyclic,
    const label nModes
)
:
    nSlabs_(parts.size()),
    n_(cyclic ? nSlabs_ : nSlabs_ - 1),
    slabOf_(nSlabs_),
    modes_(nSlabs_ + 1)
{
    for (label i = 0; i < nSlabs_; ++i)
    {
        slabOf_[parts.processor(i)] = i;
    }

    for (label proci = 0; proci <= nSlabs_; ++proci)
    {
        modes_[proci] = scalar(nModes)*proci/nSlabs_;
    }

    allStart_ = 2*modes_;
    ownStart_ = 2*nOwn()*labelField(identity(nSlabs_ + 1));
    g_.setSize(n_*nOwn());
    x_.setSize(n_);
    all_.setSize(2*nModes);
    own_.setSize(2*nOwn()*nSlabs_);
}


Foam::label Foam::separatorSystem::nOwn() const
{
    const label me = Pstream::myProcNo();

    return modes_[me + 1] - modes_[me];
}


Foam::label Foam::separatorSystem::high(const label slab) const
{
    return slab < n_ ? slab : -1;
}


Foam::label Foam::separatorSystem::low(const label slab) const
{
    return slab > 0 ? slab - 1 : n_ == nSlabs_ ? n_ - 1 : -1;
}


void Foam::separatorSystem::collect
(
    const scalar* atHigh,
    const scalar* atLow
) const
{
    for (label proci = 0; proci < nSlabs_; ++proci)
    {
        const label n = modes_[proci + 1] - modes_[proci];
        scalar* message = all_.begin() + allStart_[proci];
        std::copy_n(atHigh + modes_[proci], n, message);
        std::copy_n(atLow + modes_[proci], n, message + n);
    }

    exchange(all_, allStart_, own_, ownStart_);
}


void Foam::separatorSystem::addTo
(
    scalarField& sum,
    const label proci,
    const label i,
    const label j,
    const label n
) const
{
    const scalar* atHigh = own_.begin() + ownStart_[proci];
    const scalar* atLow = atHigh + nOwn();

    for (label m = 0; m < nOwn(); ++m)
    {
        if (i >= 0)
        {
            sum[m*n + i] += atHigh[m];
        }
        if (j >= 0)
        {
            sum[m*n + j] += atLow[m];
        }
    }
}


void Foam::separatorSystem::invert(const bool singular)
{
    for (label m = 0; m < nOwn(); ++m)
    {
        scalar* A = inverse_.begin() + m*n_*n_;

        // With the last unknown 0 a singular system is solved as well
        const bool fix = singular && m + modes_[Pstream::myProcNo()] == 0;
        const label last = fix ? n_ - 1 : n_;

        for (label i = 0; fix && i < n_; ++i)
        {
            A[last*n_ + i] = A[i*n_ + last] = 0;
        }

        // Gauss-Jordan; positive definite: no pivoting
        for (label p = 0; p < last; ++p)
        {
            const scalar pivot = 1/A[p*n_ + p];
            A[p*n_ + p] = 1;

            for (label j = 0; j < last; ++j)
            {
                A[p*n_ + j] *= pivot;
            }

            for (label i = 0; i < last; ++i)
            {
                if (i == p)
                {
                    continue;
                }

                const scalar multiple = A[i*n_ + p];
                A[i*n_ + p] = 0;

                for (label j = 0; j < last; ++j)
                {
                    A[i*n_ + j] -= multiple*A[p*n_ + j];
                }
            }
        }
    }
}


void Foam::separatorSystem::assemble
(
    const scalarField& atHigh,
    const scalarField& atLow,
    const scalarField& between,
    const bool singular
)
{
    const label n2 = n_*n_;
    inverse_ = scalarField(n2*nOwn(), Zero);

    collect(atHigh.begin(), atLow.begin());

    for (label proci = 0; proci < nSlabs_; ++proci)
    {
        const label i = high(slabOf_[proci]), j = low(slabOf_[proci]);
        const label ii = i < 0 ? -1 : i*n_ + i;
        const label jj = j < 0 ? -1 : j*n_ + j;
        addTo(inverse_, proci, ii, jj, n2);
    }

    collect(between.begin(), between.begin());

    for (label proci = 0; proci < nSlabs_; ++proci)
    {
        const label i = high(slabOf_[proci]), j = low(slabOf_[proci]);

        if (i >= 0 && j >= 0)
        {
            addTo(inverse_, proci, i*n_ + j, j*n_ + i, n2);
        }
    }

    invert(singular);
}


void Foam::separatorSystem::solve(scalarField& atHigh, scalarField& atLow) const
{
    collect(atHigh.begin(), atLow.begin());
    g_ = 0;

    for (label proci = 0; proci < nSlabs_; ++proci)
    {
        addTo(g_, proci, high(slabOf_[proci]), low(slabOf_[proci]), n_);
    }

    for (label m = 0; m < nOwn(); ++m)
    {
        const scalar* row = inverse_.begin() + m*n_*n_;
        scalar* g = g_.begin() + m*n_;

        for (label i = 0; i < n_; ++i, row += n_)
        {
            x_[i] = std::inner_product(row, row + n_, g, scalar(0));
        }

        std::copy_n(x_.begin(), n_, g);
    }

    for (label proci = 0; proci < nSlabs_; ++proci)
    {
        const label i = high(slabOf_[proci]), j = low(slabOf_[proci]);
        scalar* message = own_.begin() + ownStart_[proci];

        for (label m = 0; m < nOwn(); ++m)
        {
            message[m] = i < 0 ? 0 : g_[m*n_ + i];
            message[nOwn() + m] = j < 0 ? 0 : g_[m*n_ + j];
        }
    }

    exchange(own_, ownStart_, all_, allStart_);

    for (label proci = 0; proci < nSlabs_; ++proci)
    {
        const label n = modes_[proci + 1] - modes_[proci];
        const scalar* message = all_.begin() + allStart_[proci];
        std::copy_n(message, n, atHigh.begin() + modes_[proci]);
        std::copy_n(message + n, n, atLow.begin() + modes_[proci]);
    }
}
