// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshLayers.H"
#include "compat.H"
#include "volFields.H"

Foam::meshLayers::meshLayers
(
    const fvMesh& mesh,
    const vector& direction,
    const label n
)
:
    mesh_(mesh),
    direction_(normalised(direction)),
    n_(n)
{
    const scalarField corners(mesh_.points() & direction_);

    low_ = gMin(corners);
    thickness_ = (gMax(corners) - low_)/n_;
}


Foam::List<Foam::scalarField> Foam::meshLayers::sums
(
    const scalarField& rows,
    const label nColumns
) const
{
    const scalarField height(mesh_.cellCentres() & direction_);
    List<scalarField> all(n_, scalarField(nColumns + 1, Zero));

    forAll(height, celli)
    {
        const label layeri = label((height[celli] - low_)/thickness_);
        scalarField& sum = all[min(max(layeri, label(0)), n_ - 1)];
        const scalar V = mesh_.V()[celli];

        sum[0] += V;
        for (label k = 0; k < nColumns; ++k)
        {
            sum[k + 1] += V*rows[nColumns*celli + k];
        }
    }

    for (scalarField& sum : all)
    {
        compat::allReduce(sum, plusEqOp<scalar>());
    }

    return all;
}
