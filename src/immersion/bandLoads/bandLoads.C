// SPDX-License-Identifier: GPL-3.0-or-later

#include "bandLoads.H"
#include "coupledValues.H"

Foam::bandLoads::bandLoads
(
    const fvMesh& mesh,
    const cellNeighbours& neighbours,
    bodyBands& bands,
    const bodySums& sums
)
:
    mesh_(mesh),
    neighbours_(neighbours),
    bands_(bands),
    sums_(sums),
    response_(mesh, neighbours, sums),
    fluidPart_(mesh.nCells()),
    keepForces_(false)
{}


Foam::vector Foam::bandLoads::rowH
(
    const fvVectorMatrix& E0,
    const vectorField& U,
    const List<vectorField>& neighbourU,
    const label celli
) const
{
    const scalarField& lower = E0.lower();
    const scalarField& upper = E0.upper();
    vector h(E0.source()[celli]);

    for (const auto& n : neighbours_.of(celli))
    {
        h -= (n.owner() ? upper : lower)[n.face()]*U[n.cell()];
    }

    for (const auto& face : neighbours_.onPatches(celli))
    {
        // As A0 has the mean of the components of the diagonal, their
        // differences belong here
        const vector& diag = E0.internalCoeffs()[face.patch][face.face];
        const vector& coeff = E0.boundaryCoeffs()[face.patch][face.face];

        h += cmptMultiply(vector::uniform(cmptAv(diag)) - diag, U[celli]);
        h += neighbourU[face.patch].size()
          ? vector(cmptMultiply(coeff, neighbourU[face.patch][face.face]))
          : coeff;
    }

    return h/mesh_.V()[celli];
}


void Foam::bandLoads::setFluidPart(const solvedMomentum& solved)
{
    const vectorField& U = solved.U;
    const List<vectorField> neighbourU(coupledValues(solved.U));
    const scalarField& K = sums_.K();
    const vectorField& shieldDU = sums_.shieldDU();
    const scalarField& shield = sums_.shield();

    for (const label celli : bands_.cells())
    {
        if (K[celli] > 0)
        {
            fluidPart_[celli] = (1 - shield[celli])*solved.gradP[celli]
              - shieldDU[celli] - rowH(solved.E0, U, neighbourU, celli);
        }
    }
}


void Foam::bandLoads::measure
(
    const PtrList<immersedBody>& bodies,
    const solvedMomentum& solved,
    const bool response,
    List<bodyLoad>& loads
)
{
    setFluidPart(solved);

    if (response)
    {
        response_.update(solved);
    }

    forAll(loads, bodyi)
    {
        if (bands_.selected(bodyi))
        {
            loads[bodyi].clear(response);
        }
    }

    for (bodyRegion& region : bands_.regions())
    {
        const label bodyi = region.body();

        if (!bands_.selected(bodyi))
        {
            continue;
        }
        if (response)
        {
            response_.begin(solved, region);
        }

        add(bodies[bodyi], solved, response, region, loads[bodyi]);

        if (response)
        {
            response_.end(region);
        }
    }
}


void Foam::bandLoads::add
(
    const immersedBody& body,
    const solvedMomentum& solved,
    const bool response,
    bodyRegion& region,
    bodyLoad& load
)
{
    const scalarField& V = mesh_.V();
    const scalarField& K = sums_.K();
    const vectorField& KU = sums_.KU();
    const scalarField& A0 = solved.A0;
    const vectorField& U = solved.U;
    const vectorField& gradP = solved.gradP;
    const bodyState& state = body.state();
    const vector moving(state.U + region.slideVelocity());
    const rigidAcceleration acceleration
    (
        body.motion().acceleration(solved.ddt)
    );

    region.force.setSize(keepForces_ ? region.cells.size() : 0);

    forAll(region.cells, i)
    {
        const label celli = region.cells[i];
        const vector r(region.x(i) - state.position);
        const vector Ub(moving + (state.omega^r));

        vector q(region.share[i]*(gradP[celli] + acceleration(r)));

        if (region.resistance[i] > 0)
        {
            const scalar A = A0[celli] + K[celli];

            // A0 and K apart: K U_b and its sum cancel exactly
            q += region.resistance[i]/A
               *(
                    A0[celli]*Ub + (K[celli]*Ub - KU[celli])
                  + fluidPart_[celli]
                );
        }

        load.addForce(r, V[celli]*q);

        if (response)
        {
            response_.addRow(solved, region, i, r, load);
        }

        if (keepForces_)
        {
            region.force[i] = q;
        }

        load.volume += V[celli]*region.fractionInside(i);

        // Deeper than a cell, where the layer has come to an end
        if (region.distance[i] < -region.h[i])
        {
            load.slip += V[celli]*magSqr(U[celli] - solved.dU[celli] - Ub);
        }
    }
}
