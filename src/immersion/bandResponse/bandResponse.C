// SPDX-License-Identifier: GPL-3.0-or-later

#include "bandResponse.H"
#include "coupledValues.H"

Foam::bandResponse::bandResponse
(
    const fvMesh& mesh,
    const cellNeighbours& neighbours,
    const bodySums& sums
)
:
    mesh_(mesh),
    neighbours_(neighbours),
    sums_(sums),
    delta_(mesh.boundary().size()),
    weight_(mesh.nCells(), Zero)
{
    forAll(delta_, patchi)
    {
        if (mesh.boundary()[patchi].coupled())
        {
            delta_[patchi] = mesh.boundary()[patchi].delta();
        }
    }
}


void Foam::bandResponse::update(const solvedMomentum& solved)
{
    neighbourA_ = coupledValues(solved.A0);
    neighbourK_ = coupledValues(sums_.K());
}


void Foam::bandResponse::begin
(
    const solvedMomentum& solved,
    const bodyRegion& region
)
{
    const scalarField& A0 = solved.A0;
    const scalarField& K = sums_.K();

    forAll(region.cells, i)
    {
        const label celli = region.cells[i];
        weight_[celli] = region.resistance[i]/(A0[celli] + K[celli]);
    }
}


void Foam::bandResponse::end(const bodyRegion& region)
{
    UIndirectList<scalar>(weight_, region.cells) = 0;
}


void Foam::bandResponse::addRow
(
    const solvedMomentum& solved,
    const bodyRegion& region,
    const label i,
    const vector& r,
    bodyLoad& load
) const
{
    const fvVectorMatrix& E0 = solved.E0;
    const scalarField& lower = E0.lower();
    const scalarField& upper = E0.upper();
    const scalarField& A0 = solved.A0;
    const vectorField& C = mesh_.cellCentres();
    const label celli = region.cells[i];
    const scalar w = weight_[celli];

    scalar sum = mesh_.V()[celli]
       *(w*A0[celli] + (1 - w)*region.share[i]*solved.ddt.c);
    vector sumR(sum*r);

    if (w > 0)
    {
        for (const auto& n : neighbours_.of(celli))
        {
            const scalar a =
                w*weight_[n.cell()]*(n.owner() ? upper : lower)[n.face()];

            sum += a;
            sumR += a*(r + (C[n.cell()] - C[celli]));
        }

        for (const auto& face : neighbours_.onPatches(celli))
        {
            if (neighbourA_[face.patch].size())
            {
                const scalar A = neighbourA_[face.patch][face.face];
                const scalar K = neighbourK_[face.patch][face.face];
                const scalar a = -w*K/(A + K)
                   *E0.boundaryCoeffs()[face.patch][face.face].x();

                sum += a;
                sumR += a*(r + delta_[face.patch][face.face]);
            }
        }
    }

    load.addResponseRow(sum, sumR, r);
}
