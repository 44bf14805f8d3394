// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "ambientFlow.H"
#include "compat.H"
#include "fvcGrad.H"

bool Foam::immersedBodies::setAmbientOfTube(const volVectorField& U)
{
    for (const fvPatchVectorField& Up : U.boundaryField())
    {
        const ambientFlow* flow = dynamic_cast<const ambientFlow*>(&Up);

        if (flow)
        {
            for (immersedBody& body : bodies_)
            {
                const point& x = body.state().position;

                body.setAmbient
                (
                    flow->ambientVelocity(x),
                    0.5*flow->ambientVorticity(x)
                );
            }

            return true;
        }
    }

    return false;
}


void Foam::immersedBodies::setAmbient(const volVectorField& U)
{
    bool needed = false;

    for (const immersedBody& body : bodies_)
    {
        needed = needed || body.needsAmbient();
    }

    if (!needed)
    {
        window_.follow(bodies_);
        return;
    }

    if (setAmbientOfTube(U))
    {
        window_.follow(bodies_);
        return;
    }

    // Gradients at the cell with the centre, in the mean of those on both sides
    // of a face: the flow as it is at the centre, and half its vorticity
    const volTensorField gradU(fvc::grad(U));
    vectorField centreU(bodies_.size(), Zero), spin(bodies_.size(), Zero);
    labelList found(bodies_.size(), 0);

    forAll(bodies_, bodyi)
    {
        const point& centre = bodies_[bodyi].state().position;

        for (const auto& im : periodicity_.localImages(centre, 0))
        {
            const point x(centre + im.shift);

            for (const label celli : region_.search().cellsAt(x))
            {
                const tensor& G = gradU[celli];

                ++found[bodyi];
                centreU[bodyi] += U[celli] + ((x - mesh_.C()[celli]) & G)
                  - im.velocity;
                spin[bodyi] += 0.5*vector
                (
                    G.yz() - G.zy(), G.zx() - G.xz(), G.xy() - G.yx()
                );
            }
        }
    }

    compat::allReduce(centreU, plusEqOp<vector>());
    compat::allReduce(spin, plusEqOp<vector>());
    compat::allReduce(found, plusEqOp<label>());

    forAll(bodies_, bodyi)
    {
        // Cells of several processors, and beyond cyclic patches
        const scalar n = max(found[bodyi], 1);

        bodies_[bodyi].setAmbient(centreU[bodyi]/n, spin[bodyi]/n);
    }
    window_.follow(bodies_);
}


void Foam::immersedBodies::setRigidMotion(volVectorField& U) const
{
    region_.interior().setRigidMotion(bodies_, U.primitiveFieldRef());

    if (U.nOldTimes())
    {
        region_.interior().setRigidMotion(bodies_, U.oldTime().primitiveFieldRef());
    }
    U.correctBoundaryConditions();
}
