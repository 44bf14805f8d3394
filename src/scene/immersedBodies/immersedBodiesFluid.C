// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "ambientVelocities.H"
#include "comovingDerivative.H"
#include "freeVelocities.H"
#include "profiling.H"
#include "unresolvedBodies.H"

void Foam::immersedBodies::setAmbient(const volVectorField& U)
{
    ambientVelocities::set(U, region_.search(), periodicity_, bodies_);
    window_.follow(bodies_);
}


void Foam::immersedBodies::setRigidMotion(volVectorField& U) const
{
    const bodyInterior& interior = region_.interior();

    interior.setRigidMotion(bodies_, U.primitiveFieldRef());

    if (U.nOldTimes())
    {
        interior.setRigidMotion(bodies_, U.oldTime().primitiveFieldRef());
    }
    U.correctBoundaryConditions();
}


Foam::tmp<Foam::volScalarField> Foam::immersedBodies::bodyFraction() const
{
    tmp<volScalarField> tfraction(region_.interior().fraction());

    unresolved_->coupling().addFraction(tfraction.ref().primitiveFieldRef());
    tfraction.ref().correctBoundaryConditions();

    return tfraction;
}


void Foam::immersedBodies::updateFrame
(
    const ddtCoefficients& ddt,
    const volScalarField& nu
)
{
    addProfiling(frame, "immersedBodies::updateFrame");

    const scalarField inBands(nu.primitiveField(), region_.cells());

    frame_->update
    (
        region_.regions(),
        bodies_,
        region_.search(),
        h_,
        region_.resistance().bandWidth(),
        periodicity_,
        gMin(inBands),
        ddt
    );
}


void Foam::immersedBodies::updateResistance
(
    const ddtCoefficients& ddt,
    const scalarField& A0,
    const scalarField& nu,
    const bool again
)
{
    addProfiling(resistance, "immersedBodies::updateResistance");

    region_.updateResistance(bodies_, A0, nu, again);
    region_.updateVelocity(bodies_, ddt);

    forAll(bodies_, bodyi)
    {
        if (crowd_.active() && region_.selected(bodyi))
        {
            crowd_.give(bodyi);
        }
    }
}


Foam::scalar Foam::immersedBodies::correct
(
    const solvedMomentum& solved,
    const bool response,
    const scalar addedMass
)
{
    addProfiling(correct, "immersedBodies::correct");

    if (bodies_.nResolved())
    {
        loads_.measure(solved, response, region_);
    }

    scalar most = 0;

    forAll(bodies_, bodyi)
    {
        immersedBody& body = bodies_[bodyi];

        if (!body.resolved() || !region_.selected(bodyi))
        {
            // unresolvedBodies has moved it on, or it stays as it is
            continue;
        }

        // One that is all but outside the mesh has nothing to go by
        const scalar change = !body.isFree() || loads_.inMesh(bodyi)
          ? body.correctVelocity(loads_[bodyi], solved.ddt, g(), addedMass)
          : 0;

        crowd_.note(bodyi, change);
        most = max(most, change);
    }

    window_.follow(bodies_);

    return most;
}


Foam::scalar Foam::immersedBodies::correctCrowd
(
    const scalarField& p,
    const vector& drive,
    const scalar dt
)
{
    const vectorField gradP(pressure_.gradients(p, drive));
    scalar most = 0;

    forAll(bodies_, bodyi)
    {
        if (region_.selected(bodyi))
        {
            pressure_.set(bodyi, gradP[bodyi]);
        }
        else if (bodies_[bodyi].resolved())
        {
            const scalar change =
                pressure_.speedChange(bodyi, gradP[bodyi], dt);

            crowd_.note(bodyi, change);
            most = max(most, change);
        }
    }

    return most;
}


void Foam::immersedBodies::setVelocities(const UList<vector>& velocities)
{
    freeVelocities::set(velocities, bodies_);
    window_.follow(bodies_);
}
