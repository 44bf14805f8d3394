// SPDX-License-Identifier: GPL-3.0-or-later

#include "tridiagonal.H"


Foam::tridiagonal::tridiagonal
(
    const scalarField& diag,
    const scalarField& off,
    const scalarField& lambda,
    const bool singular
)
:
    n_(diag.size()),
    nModes_(lambda.size()),
    off_(off),
    inverse_(n_*nModes_)
{
    for (label t = 0; t < n_; ++t)
    {
        scalar* now = inverse_.begin() + t*nModes_;

        for (label m = 0; m < nModes_; ++m)
        {
            const scalar before = t > 0 ? sqr(off_[t - 1])*now[m - nModes_] : 0;

            // The last pivot of the constant mode is zero, or what rounding
            // makes of it
            now[m] = singular && t == n_ - 1 && m == 0
              ? 0
              : 1/(diag[t] + lambda[m] - before);
        }
    }
}


void Foam::tridiagonal::solve(scalar* v) const
{
    // As many modes at a time as stay in the cache from one sweep to the other
    const label nTogether = 256;

    for (label first = 0; first < nModes_; first += nTogether)
    {
        const label n = min(nTogether, nModes_ - first);

        for (label t = 0; t < n_; ++t)
        {
            const scalar c = t > 0 ? off_[t - 1] : 0;
            scalar* x = v + t*nModes_ + first;
            const scalar* before = t > 0 ? x - nModes_ : x;
            const scalar* inverse = inverse_.begin() + t*nModes_ + first;

            #pragma GCC ivdep
            for (label m = 0; m < n; ++m)
            {
                x[m] = (x[m] + c*before[m])*inverse[m];
            }
        }

        for (label t = n_ - 2; t >= 0; --t)
        {
            const scalar c = off_[t];
            scalar* x = v + t*nModes_ + first;
            const scalar* after = x + nModes_;
            const scalar* inverse = inverse_.begin() + t*nModes_ + first;

            #pragma GCC ivdep
            for (label m = 0; m < n; ++m)
            {
                x[m] += c*inverse[m]*after[m];
            }
        }
    }
}
