// SPDX-License-Identifier: GPL-3.0-or-later

#include "ambientVelocities.H"
#include "ambientFlow.H"
#include "bodyShare.H"
#include "fvcGrad.H"

namespace Foam
{
namespace
{

//- The boundary condition of U that knows the flow without bodies; null if
//  there is none
const ambientFlow* findFlow(const volVectorField& U)
{
    for (const fvPatchVectorField& Up : U.boundaryField())
    {
        const ambientFlow* flow = dynamic_cast<const ambientFlow*>(&Up);

        if (flow)
        {
            return flow;
        }
    }

    return nullptr;
}


//- Set the velocities from the cells with the centres. Collective.
void setFromCells
(
    const volVectorField& U,
    const cellSearch& search,
    const periodicity& periods,
    bodyList& bodies
)
{
    // Gradients at the cell with the centre, in the mean of those on both sides
    // of a face: the flow as it is at the centre, and half its vorticity
    const volTensorField gradU(fvc::grad(U));
    const volVectorField& C = U.mesh().C();
    vectorField centreU(bodies.size(), Zero), spin(bodies.size(), Zero);
    labelList found(bodies.size(), 0);

    forAll(bodies, bodyi)
    {
        const point& centre = bodies[bodyi].state().position;

        for (const auto& im : periods.localImages(centre, 0))
        {
            const point x(centre + im.shift);

            for (const label celli : search.cellsAt(x))
            {
                const tensor& G = gradU[celli];

                ++found[bodyi];
                centreU[bodyi] += U[celli] + ((x - C[celli]) & G)
                  - im.velocity;
                spin[bodyi] += 0.5*vector
                (
                    G.yz() - G.zy(), G.zx() - G.xz(), G.xy() - G.yx()
                );
            }
        }
    }

    bodies.share().combine(centreU, plusEqOp<vector>());
    bodies.share().combine(spin, plusEqOp<vector>());
    bodies.share().combine(found, plusEqOp<label>());

    forAll(bodies, bodyi)
    {
        // Cells of several processors, and beyond cyclic patches
        const scalar n = max(found[bodyi], 1);

        bodies[bodyi].setAmbient(centreU[bodyi]/n, spin[bodyi]/n);
    }
}

} // End anonymous namespace
} // End namespace Foam


void Foam::ambientVelocities::set
(
    const volVectorField& U,
    const cellSearch& search,
    const periodicity& periods,
    bodyList& bodies
)
{
    bool needed = false;

    for (const immersedBody& body : bodies)
    {
        needed =
            needed || body.needsAmbientU() || body.needsAmbientOmega();
    }

    if (!bodies.share().any(needed))
    {
        return;
    }

    const ambientFlow* flow = findFlow(U);

    if (!flow)
    {
        setFromCells(U, search, periods, bodies);
        return;
    }

    for (immersedBody& body : bodies)
    {
        const point& x = body.state().position;

        body.setAmbient
        (
            flow->ambientVelocity(x), 0.5*flow->ambientVorticity(x)
        );
    }
}
