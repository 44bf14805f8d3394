// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "bodyContacts.H"
#include "bodyHandover.H"
#include "bodyPassage.H"
#include "bodyResolution.H"
#include "bodyTraffic.H"
#include "meshProperties.H"
#include "profiling.H"
#include "unresolvedBodies.H"

Foam::scalar Foam::immersedBodies::stepRatio() const
{
    return mesh_.time().deltaTValue()/mesh_.time().deltaT0Value();
}


void Foam::immersedBodies::beginStep()
{
    clock_ += mesh_.time().deltaTValue();
    meshProperties::slide(mesh_, periodicity_);
    passage_->beginStep();
    handover_->beginStep(mesh_.time().deltaTValue());
    oldH_ = h_;

    for (immersedBody& body : bodies_)
    {
        body.beginStep(steady_.active() ? 0 : stepRatio(), crowd_.active());
        body.prescribe(clock_);
    }

    // At once, where it follows a body with a prescribed velocity
    window_.beginStep();
    window_.follow(bodies_);
}


void Foam::immersedBodies::undoStep()
{
    clock_ -= mesh_.time().deltaTValue();

    for (immersedBody& body : bodies_)
    {
        body.undoStep();
    }
    h_ = oldH_;
    window_.undoStep();
    resolved_->region().updateGeometry(bodies_);
}


bool Foam::immersedBodies::predictPoses()
{
    const scalar dt = mesh_.time().deltaTValue();
    bool extended = false, again = false;

    window_.move(dt);

    // Those that go further than expected may meet bodies that are not here
    do
    {
        for (immersedBody& body : bodies_)
        {
            body.predictPose
            (
                dt, window_.meanVelocity(), window_.displacement()
            );
        }

        contacts_->advance(bodies_, h_, dt, window_.meanVelocity());
        again = handover_->extend(contacts_->model().wayWanted());
        extended = extended || again;
    }
    while (again);

    return extended;
}


void Foam::immersedBodies::predict
(
    const bool again,
    const scalar enough,
    const bool inBands
)
{
    addProfiling(predict, "immersedBodies::predict");

    // Where bodies are new, all take part
    const bool extended = predictPoses();

    resolved_->update(extended ? 0 : enough, again);
    if (!inBands)
    {
        unresolved_->update();
    }
    else if (extended)
    {
        unresolved_->outdate();
    }
}


void Foam::immersedBodies::wrapPositions()
{
    if (!periodicity_.active())
    {
        return;
    }

    for (immersedBody& body : bodies_)
    {
        const periodicity::image im
        (
            periodicity_.wrap(body.state().position)
        );

        // Else rounding of nothing
        if (im.key != vector::zero)
        {
            body.wrap(im.shift, im.velocity, mesh_.time().deltaTValue());
        }
    }
}


bool Foam::immersedBodies::endStep()
{
    addProfiling(endStep, "immersedBodies::endStep");

    // The poses that go with the last correction of the velocities
    predictPoses();
    handover_->shareStates();

    for (immersedBody& body : bodies_)
    {
        body.endStep(stepRatio(), crowd_.active());
    }

    resolved_->loads().noteUnresolved(unresolved_->coupling());

    // Contact knows the bodies as they are before any leave
    contacts_->updateMoments(loads(), mesh_.time().deltaTValue());

    const bool overlap = contacts_->overlap(bodies_, region(), h_);
    const bool good = traffic_->leave() && !overlap;

    // The regions go with the positions so far
    wrapPositions();

    if (mesh_.time().writeTime())
    {
        handover_->lookAgain();
    }
    handover_->hand(mesh_.time().deltaTValue());
    contacts_->endStep();
    handover_->drop();
    contacts_->updateSleep(mesh_.time().deltaTValue());

    return good;
}


void Foam::immersedBodies::enter(volVectorField& U)
{
    // A body that is due at the end of the step must not miss it by rounding
    traffic_->enter(clock_ + 1e-6*mesh_.time().deltaTValue(), U);
    resolution_->select(U);
}


void Foam::immersedBodies::compareStep(const scalar speed, const scalar nu)
{
    const scalar T = steadyMonitor::timeScale
    (
        mesh_.bounds().span(),
        space_.translation(),
        speed,
        nu
    );
    const scalar dt = mesh_.time().deltaTValue();

    steady_.update(bodies_, window_.velocity(), speed, nu, T, dt);
}
