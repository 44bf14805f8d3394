// SPDX-License-Identifier: GPL-3.0-or-later

#include "bandResponse.H"
#include "coupledValues.H"

Foam::bandResponse::bandResponse
(
    const fvMesh& mesh,
    const bodyBands& bands,
    const bodySums& sums
)
:
    mesh_(mesh),
    bands_(bands),
    sums_(sums),
    delta_(mesh.boundary().size()),
    weight_(mesh.nCells(), Zero),
    rows_(mesh.nCells())
{
    forAll(delta_, patchi)
    {
        if (mesh.boundary()[patchi].coupled())
        {
            delta_[patchi] = mesh.boundary()[patchi].delta();
        }
    }
}


void Foam::bandResponse::measure
(
    const PtrList<immersedBody>& bodies,
    const solvedMomentum& solved,
    List<bodyLoad>& loads
)
{
    const List<scalarField> neighbourA(coupledValues(solved.A0));
    const List<scalarField> neighbourK(coupledValues(sums_.K()));

    for (bodyLoad& load : loads)
    {
        load.clearResponse();
    }

    for (const bodyRegion& region : bands_.regions())
    {
        add
        (
            solved,
            neighbourA,
            neighbourK,
            region.centre(bodies[region.body()].state()),
            region,
            loads[region.body()]
        );
    }
}


void Foam::bandResponse::add
(
    const solvedMomentum& solved,
    const List<scalarField>& neighbourA,
    const List<scalarField>& neighbourK,
    const point& centre,
    const bodyRegion& region,
    bodyLoad& load
)
{
    const vectorField& centres = mesh_.cellCentres();
    const scalarField& A0 = solved.A0;
    const scalarField& K = sums_.K();

    forAll(region.cells, i)
    {
        const label celli = region.cells[i];
        const scalar w = region.resistance[i]/(A0[celli] + K[celli]);

        weight_[celli] = w;
        rows_[celli] = row{0, Zero};
        rows_[celli].add
        (
            mesh_.V()[celli]
           *(w*A0[celli] + (1 - w)*region.share[i]*solved.ddt.c),
            centres[celli] - centre
        );
    }

    addInternal(solved.E0, centre, region);
    addCoupled(solved.E0, neighbourA, neighbourK, centre, region, load);

    for (const label celli : region.cells)
    {
        const row& one = rows_[celli];

        load.addResponseRow(one.sum, one.sumR, centres[celli] - centre);
        weight_[celli] = 0;
    }
}


void Foam::bandResponse::addInternal
(
    const fvVectorMatrix& E0,
    const point& centre,
    const bodyRegion& region
)
{
    const vectorField& centres = mesh_.cellCentres();
    const scalarField& lower = E0.lower();
    const scalarField& upper = E0.upper();

    for (const label facei : region.faces)
    {
        if (mesh_.isInternalFace(facei))
        {
            const label own = mesh_.faceOwner()[facei];
            const label nei = mesh_.faceNeighbour()[facei];
            const scalar w = weight_[own]*weight_[nei];

            if (w > 0)
            {
                rows_[own].add(w*upper[facei], centres[nei] - centre);
                rows_[nei].add(w*lower[facei], centres[own] - centre);
            }
        }
    }
}


void Foam::bandResponse::addCoupled
(
    const fvVectorMatrix& E0,
    const List<scalarField>& neighbourA,
    const List<scalarField>& neighbourK,
    const point& centre,
    const bodyRegion& region,
    bodyLoad& load
) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    for (const label facei : region.faces)
    {
        if (mesh_.isInternalFace(facei))
        {
            continue;
        }

        const label patchi = patches.patchID()[facei - mesh_.nInternalFaces()];
        const label i = facei - patches[patchi].start();
        const label celli = mesh_.faceOwner()[facei];

        const scalar K = neighbourK[patchi][i];
        const scalar A = neighbourA[patchi][i];
        const scalar w = weight_[celli]*K/(A + K);
        const vector r(mesh_.cellCentres()[celli] - centre);

        load.addResponse
        (
            -w*E0.boundaryCoeffs()[patchi][i].x(),
            r,
            r + delta_[patchi][i]
        );
    }
}
