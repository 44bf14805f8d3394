// SPDX-License-Identifier: GPL-3.0-or-later

#include "slidingModes.H"

Foam::label Foam::slidingModes::axis(const vector& v)
{
    for (label d = 0; d < 3; ++d)
    {
        if (mag(v[d]) > (1 - 1e-9)*mag(v))
        {
            return d;
        }
    }

    return -1;
}


Foam::slidingModes::slidingModes
(
    const slidingPair& pair,
    const label normal,
    const label nA,
    const label nB
)
:
    pair_(pair),
    nA_(nA),
    nModes_(nA*nB),
    alongA_(axis(pair.direction()) == (normal == 0 ? 1 : 0)),
    firstIsLast_(pair.height()[normal] > 0)
{}


void Foam::slidingModes::update() const
{
    // Along the axis, not along the direction; beyond the patch with the shift
    // is what is at -shift
    const label d = axis(pair_.direction());
    const label n = pair_.nCells();
    const scalar shift = pair_.shiftInCells()
       *(pair_.direction()[d] > 0 ? 1 : -1)
       *(firstIsLast_ ? -1 : 1);

    phases_.resize(n/2 + 1);

    forAll(phases_, k)
    {
        phases_[k] = rowShift::phase(k, n, shift);
    }
}


Foam::label Foam::slidingModes::partner(const label mode) const
{
    const label n = pair_.nCells();
    const label k = along(mode);
    const label other = k == 0 ? 0 : n - k;

    return mode + (other - k)*(alongA_ ? 1 : nA_);
}


void Foam::slidingModes::multiply
(
    UList<scalar>& modes,
    const bool conjugate
) const
{
    for (label m = 0; m < nModes_; ++m)
    {
        const label other = partner(m);

        if (other < m)
        {
            continue;
        }

        const complex& factor = phase(m);
        const scalar c = factor.Re();
        const scalar s = conjugate ? -factor.Im() : factor.Im();

        if (other == m)
        {
            modes[m] *= c;
        }
        else
        {
            const scalar re = modes[m], im = modes[other];

            modes[m] = c*re - s*im;
            modes[other] = s*re + c*im;
        }
    }
}
