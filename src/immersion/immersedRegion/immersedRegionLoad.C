// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedRegion.H"
#include "coupledValues.H"

Foam::vector Foam::immersedRegion::rowH
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


void Foam::immersedRegion::setFluidPart
(
    const fvVectorMatrix& E0,
    const volVectorField& U,
    const vectorField& gradP
) const
{
    const List<vectorField> neighbourU(coupledValues(U));
    const scalarField& K = K_;

    for (const label celli : cells())
    {
        if (K[celli] > 0)
        {
            fluidPart_[celli] = (1 - shield_[celli])*gradP[celli]
              - shieldDU_[celli] - rowH(E0, U, neighbourU, celli);
        }
    }
}


void Foam::immersedRegion::load
(
    const PtrList<immersedBody>& bodies,
    const ddtCoefficients& ddt,
    const fvVectorMatrix& E0,
    const volScalarField& A0,
    const volVectorField& U,
    const vectorField& gradP,
    const vectorField& dU,
    const bool response,
    List<bodyLoad>& loads
)
{
    setFluidPart(E0, U, gradP);

    forAll(loads, bodyi)
    {
        if (selected(bodyi))
        {
            loads[bodyi].clearLoad();
        }
    }

    for (bodyRegion& region : regions_)
    {
        if (selected(region.body()))
        {
            addLoad
            (
                bodies[region.body()],
                ddt,
                A0,
                U,
                gradP,
                dU,
                region,
                loads[region.body()]
            );
        }
    }

    if (!response)
    {
        return;
    }

    const List<scalarField> neighbourA(coupledValues(A0));
    const List<scalarField> neighbourK(coupledValues(K_));

    for (bodyLoad& load : loads)
    {
        load.clearResponse();
    }

    for (const bodyRegion& region : regions_)
    {
        addResponse
        (
            ddt.c,
            E0,
            A0,
            neighbourA,
            neighbourK,
            region.centre(bodies[region.body()].state()),
            region,
            loads[region.body()]
        );
    }
}


void Foam::immersedRegion::addLoad
(
    const immersedBody& body,
    const ddtCoefficients& ddt,
    const volScalarField& A0,
    const vectorField& U,
    const vectorField& gradP,
    const vectorField& dU,
    bodyRegion& region,
    bodyLoad& load
) const
{
    const scalarField& V = mesh_.V();
    const scalarField& K = K_;
    const bodyState& state = body.state();
    const vector moving(state.U + region.slideVelocity());
    const rigidAcceleration acceleration(body.acceleration(ddt));

    region.force.setSize(keepForces_ ? region.cells.size() : 0);

    forAll(region.cells, i)
    {
        const label celli = region.cells[i];
        const vector r(region.x[i] - state.position);
        const vector Ub(moving + (state.omega^r));
        vector q(region.share[i]*(gradP[celli] + acceleration(r)));

        if (region.resistance[i] > 0)
        {
            const scalar A = A0[celli] + K[celli];

            // A0 and K apart: K U_b and its sum cancel exactly
            q += region.resistance[i]/A
               *(
                    A0[celli]*Ub + (K[celli]*Ub - KU_[celli])
                  + fluidPart_[celli]
                );
        }
        load.addForce(r, V[celli]*q);

        if (keepForces_)
        {
            region.force[i] = q;
        }

        load.volume += V[celli]*fractionInside(region, i);

        // Deeper than a cell, where the layer has come to an end
        if (region.distance[i] < -region.h[i])
        {
            load.slip += V[celli]*magSqr(U[celli] - dU[celli] - Ub);
        }
    }
}


Foam::displacedFluid Foam::immersedRegion::fluidInside
(
    const immersedBody& body,
    const bodyRegion& region,
    const vectorField& U
) const
{
    const point centre(region.centre(body.state()));
    displacedFluid fluid;

    forAll(region.cells, i)
    {
        const label celli = region.cells[i];
        const scalar inside = fractionInside(region, i);

        if (inside > 0)
        {
            fluid.add
            (
                mesh_.V()[celli]*inside,
                mesh_.cellCentres()[celli] - centre,
                U[celli] - region.slideVelocity()
            );
        }
    }

    fluid.reduce();

    return fluid;
}


Foam::displacedFluid Foam::immersedRegion::fluidAt
(
    const point& x,
    const vectorField& U
) const
{
    const label celli = search_.findCell(x);
    displacedFluid fluid;

    if (celli >= 0)
    {
        // As six parts, for an inertia
        const scalar V = mesh_.V()[celli]/6;
        const scalar r = 0.5*search_.h()[celli];

        for (direction k = 0; k < 3; ++k)
        {
            vector arm(Zero);
            arm[k] = r;

            fluid.add(V, arm, U[celli]);
            fluid.add(V, -arm, U[celli]);
        }
    }

    fluid.reduce();

    return fluid;
}


void Foam::immersedRegion::addResponse
(
    const scalar ddtCoeff,
    const fvVectorMatrix& E0,
    const volScalarField& A0,
    const List<scalarField>& neighbourA,
    const List<scalarField>& neighbourK,
    const point& centre,
    const bodyRegion& region,
    bodyLoad& load
) const
{
    const vectorField& centres = mesh_.cellCentres();
    const scalarField& K = K_;
    const scalarField& lower = E0.lower();
    const scalarField& upper = E0.upper();

    forAll(region.cells, i)
    {
        const label celli = region.cells[i];
        const vector r(centres[celli] - centre);
        const scalar w = region.resistance[i]/(A0[celli] + K[celli]);

        weight_[celli] = w;
        load.addResponse
        (
            mesh_.V()[celli]
           *(w*A0[celli] + (1 - w)*region.share[i]*ddtCoeff),
            r,
            r
        );
    }

    for (const label facei : region.faces)
    {
        if (mesh_.isInternalFace(facei))
        {
            const label own = mesh_.faceOwner()[facei];
            const label nei = mesh_.faceNeighbour()[facei];
            const scalar w = weight_[own]*weight_[nei];

            if (w > 0)
            {
                const vector ro(centres[own] - centre);
                const vector rn(centres[nei] - centre);

                load.addResponse(w*upper[facei], ro, rn);
                load.addResponse(w*lower[facei], rn, ro);
            }
        }
    }

    addCoupledResponse(E0, neighbourA, neighbourK, centre, region, load);

    for (const label celli : region.cells)
    {
        weight_[celli] = 0;
    }
}


void Foam::immersedRegion::addCoupledResponse
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

        const label patchi = patchOf(facei);
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
