// SPDX-License-Identifier: GPL-3.0-or-later

#include "resolvedBodies.H"
#include "bodyShare.H"
#include "profiling.H"

Foam::resolvedBodies::resolvedBodies
(
    const dictionary& dict,
    const fvMesh& mesh,
    const geometricSpace& space,
    const periodicity& periods,
    meshWindow& window,
    bodyCrowd& crowd,
    const vector& g,
    const bool moving,
    bodyList& bodies,
    const bodyCellSizes& h
)
:
    bodies_(bodies),
    h_(h),
    periods_(periods),
    window_(window),
    crowd_(crowd),
    g_(g),
    region_
    (
        mesh,
        space,
        periods,
        dict.subOrEmptyDict("resistance"),
        bodies,
        moving
    ),
    frame_(mesh, region_.neighbours()),
    loads_(mesh, dict.subOrEmptyDict("bodies"), bodies),
    pressure_(bodies, region_, loads_, periods)
{}


void Foam::resolvedBodies::setRigidMotion(volVectorField& U) const
{
    const bodyInterior& interior = region_.interior();

    interior.setRigidMotion(bodies_, U.primitiveFieldRef());

    if (U.nOldTimes())
    {
        interior.setRigidMotion(bodies_, U.oldTime().primitiveFieldRef());
    }
    U.correctBoundaryConditions();
}


void Foam::resolvedBodies::update(const scalar enough, const bool again)
{
    if (enough > 0)
    {
        region_.select(crowd_.unsettled(enough));
    }
    else
    {
        region_.selectAll();
    }
    region_.updateGeometry(bodies_, false, again);
}


void Foam::resolvedBodies::updateFrame
(
    const ddtCoefficients& ddt,
    const volScalarField& nu
)
{
    addProfiling(frame, "resolvedBodies::updateFrame");

    const scalarField inBands(nu.primitiveField(), region_.cells());

    frame_.update
    (
        region_.regions(),
        bodies_,
        region_.search(),
        h_,
        region_.resistance().bandWidth(),
        periods_,
        gMin(inBands),
        ddt
    );
}


void Foam::resolvedBodies::updateResistance
(
    const ddtCoefficients& ddt,
    const scalarField& A0,
    const scalarField& nu,
    const bool again
)
{
    addProfiling(resistance, "resolvedBodies::updateResistance");

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


Foam::scalar Foam::resolvedBodies::correct
(
    const solvedMomentum& solved,
    const bool response,
    const scalar addedMass
)
{
    addProfiling(correct, "resolvedBodies::correct");

    if (bodies_.anyResolved())
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

        // One outside the mesh, or nearly so, has nothing to go by
        const scalar change = !body.isFree() || loads_.known(bodyi)
          ? body.correctVelocity(loads_[bodyi], solved.ddt, g_, addedMass)
          : 0;

        crowd_.note(bodyi, change);
        most = max(most, change);
    }

    window_.follow(bodies_);

    return bodies_.share().largest(most);
}


Foam::scalar Foam::resolvedBodies::correctCrowd
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

    return bodies_.share().largest(most);
}
