// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxGradient.H"

void Foam::boxGradient
(
    const boxCells& box,
    const UList<scalar>& y,
    const scalar factor,
    UList<vector>& grad
)
{
    const boxCells::line& first = box.along(0);
    const boxCells::line& second = box.along(1);
    const boxCells::line& third = box.along(2);
    const scalarField low(factor*first.low);
    const scalarField own(factor*first.own);
    const scalarField high(factor*first.high);
    const label last = first.n - 1;
    const direction cmptI = first.cmpt;
    const direction cmptJ = second.cmpt;
    const direction cmptK = third.cmpt;

    box.forRows
    (
        [&](const boxCells::row& r)
        {
            const scalar lowJ = factor*second.low[r.j];
            const scalar ownJ = factor*second.own[r.j];
            const scalar highJ = factor*second.high[r.j];
            const scalar lowK = factor*third.low[r.k];
            const scalar ownK = factor*third.own[r.k];
            const scalar highK = factor*third.high[r.k];

            const scalar* const here = &y[r.cell];
            const scalar* const belowJ = here + second.below(r.j);
            const scalar* const aboveJ = here + second.above(r.j);
            const scalar* const belowK = here + third.below(r.k);
            const scalar* const aboveK = here + third.above(r.k);

            const auto set =
            [&](const label i, const scalar before, const scalar after)
            {
                vector& g = grad[r.cell + i];

                g[cmptI] =
                    low[i]*before + own[i]*here[i] + high[i]*after;
                g[cmptJ] =
                    lowJ*belowJ[i] + ownJ*here[i] + highJ*aboveJ[i];
                g[cmptK] =
                    lowK*belowK[i] + ownK*here[i] + highK*aboveK[i];
            };

            set(0, here[0], here[1]);
            for (label i = 1; i < last; ++i)
            {
                set(i, here[i - 1], here[i + 1]);
            }
            set(last, here[last - 1], here[last]);
        }
    );
}
