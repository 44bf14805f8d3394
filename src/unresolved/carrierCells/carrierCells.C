// SPDX-License-Identifier: GPL-3.0-or-later

#include "carrierCells.H"

void Foam::carrierCells::clear()
{
    for (const label celli : covered_)
    {
        isCovered_[celli] = false;
    }
    covered_.clear();
}


void Foam::carrierCells::cover
(
    const bodyKernel& kernel,
    const scalar V,
    const scalar D
)
{
    if (cells_.empty())
    {
        cells_.resize(mesh_.nCells());
        isCovered_.resize(mesh_.nCells(), false);
    }

    kernel.forCells
    (
        [&](const label celli, const scalar w, const point&, const vector&)
        {
            cell& c = cells_[celli];

            if (!isCovered_[celli])
            {
                isCovered_[celli] = true;
                covered_.append(celli);
                c.C = mesh_.cellCentres()[celli];
                c.V = mesh_.V()[celli];
                c.fraction = c.crowd = 0;
            }
            c.fraction += w*V;
            c.crowd += w*D;
        }
    );
}


void Foam::carrierCells::gather
(
    const ddtCoefficients& ddt,
    const carrierFlow& flow
)
{
    const volVectorField& U = flow.U;
    const vectorField& U0 = U.oldTime();
    const vectorField& U00 = ddt.c00 != 0 ? U.oldTime().oldTime() : U0;

    for (const label celli : covered_)
    {
        cell& c = cells_[celli];

        c.U = U[celli];
        c.ddtU = flow.ddtU
          ? (*flow.ddtU)[celli]
          : ddt(U[celli], U0[celli], U00[celli]);
        c.nu = flow.nu[celli];
        c.nuEff = flow.nuEff[celli];
        c.k = flow.k ? (*flow.k)[celli] : 0;
        c.epsilon = flow.epsilon ? (*flow.epsilon)[celli] : 0;
    }
}


void Foam::carrierCells::addFraction(scalarField& fraction) const
{
    for (const label celli : covered_)
    {
        fraction[celli] += cells_[celli].fraction;
    }
}
