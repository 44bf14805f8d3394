// SPDX-License-Identifier: GPL-3.0-or-later

#include "lineSweep.H"

Foam::lineSweep::lineSweep(const lineGrid::lines& along)
:
    along_(along),
    nLines_(along.nLines),
    y_(along.widths.size()*nLines_, Zero),
    g_(y_.size(), Zero),
    b_(y_.size(), Zero),
    s_(nullptr),
    sweptOver_(along.nFaces(), Zero),
    inverse_(along.widths.size(), Zero)
{
    forAll(inverse_, i)
    {
        inverse_[i] = along.widths[i] > 0 ? 1/along.widths[i] : 0;
    }
}


void Foam::lineSweep::differences
(
    const scalarField& low,
    const scalarField& high,
    const label begin,
    const label end,
    const scalarField& y,
    scalarField& result
) const
{
    for (label layer = begin; layer < end; ++layer)
    {
        const label at = lineGrid::lines::at(layer);
        const scalar lo = low[at], hi = high[at];
        const scalar* const own = &y[at*nLines_];
        const scalar* const below = own - nLines_;
        const scalar* const above = own + nLines_;
        scalar* const r = &result[at*nLines_];

        for (label line = 0; line < nLines_; ++line)
        {
            r[line] = lo*(below[line] - own[line])
              + hi*(above[line] - own[line]);
        }
    }
}


void Foam::lineSweep::differentiate()
{
    differences(along_.low, along_.high, -2, along_.n + 2, y_, g_);
}


void Foam::lineSweep::sweep(const scalar* displacements, const bool smooth)
{
    s_ = displacements;
    differentiate();

    if (smooth)
    {
        differences
        (
            along_.bendLow, along_.bendHigh, -1, along_.n + 1, g_, b_
        );
    }

    // Between layers i - 1 and i; the formula is that of sweptRemap, where all
    // gradients are along s
    for (label i = 0; i <= along_.n; ++i)
    {
        const label at = lineGrid::lines::at(i);
        const scalar w = along_.weight[at];
        const scalar d = along_.distance[at];
        const scalar* const y = &y_[at*nLines_];
        const scalar* const g = &g_[at*nLines_];
        const scalar* const b = &b_[at*nLines_];
        const scalar* const s = &s_[i*nLines_];
        scalar* const swept = &sweptOver_[i*nLines_];

        // Faces of patches do not move
        const scalar inverse = d > 0 ? 1/d : 0;

        for (label line = 0; line < nLines_; ++line)
        {
            const label o = line - nLines_, n = line;
            const scalar m = s[line]*inverse;
            const scalar k = 1 - m*m, l = 4 - m*m;
            const scalar dy = y[n] - y[o];
            const scalar excess = d*(w*g[o] + (1 - w)*g[n]) - dy;
            const scalar bend = d*(w*b[o] + (1 - w)*b[n]);

            swept[line] = s[line]
               *(
                    w*y[o] + (1 - w)*y[n]
                  - k*(1./6)*d*((g[n] - g[o]) - l*(1./20)*(b[n] - b[o]))
                  - 0.5*m
                   *(
                        dy - k*(1./3)*excess
                      + k*l*(1./90)*(bend - 4*excess)
                    )
                );
        }
    }
}
