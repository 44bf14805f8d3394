// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "bodyContacts.H"
#include "bodyPassage.H"
#include "bodyResolution.H"
#include "bodyTraffic.H"
#include "compat.H"
#include "Hasher.H"
#include "meshProperties.H"
#include "profiling.H"
#include "unresolvedBodies.H"

namespace
{

//- Does a list differ from that of another processor. Collective.
bool differs(const Foam::vectorField& list)
{
    const Foam::label hash
    (
        Foam::Hasher(list.cdata(), list.size()*sizeof(Foam::vector)) >> 1
    );

    return
        Foam::returnReduce(hash, Foam::minOp<Foam::label>())
     != Foam::returnReduce(hash, Foam::maxOp<Foam::label>());
}


//- Give all processors the states of the master: rounding on unlike machines
//  must not let the copies drift apart
void shareStates(Foam::bodyList& bodies)
{
    if (!Foam::Pstream::parRun())
    {
        return;
    }

    const Foam::label n = 5;
    Foam::vectorField packed(n*bodies.size());

    forAll(bodies, bodyi)
    {
        const Foam::bodyState& state = bodies[bodyi].state();
        Foam::vector* to = &packed[n*bodyi];

        to[0] = state.position;
        to[1] = state.orientation.v();
        to[2] = Foam::vector(state.orientation.w(), 0, 0);
        to[3] = state.U;
        to[4] = state.omega;
    }

    if (!differs(packed))
    {
        return;
    }

    Foam::compat::broadcast(packed);

    forAll(bodies, bodyi)
    {
        Foam::bodyState state;
        const Foam::vector* from = &packed[n*bodyi];

        state.position = from[0];
        state.orientation = Foam::quaternion(from[2].x(), from[1]);
        state.U = from[3];
        state.omega = from[4];

        bodies[bodyi].setState(state);
    }
}

} // End anonymous namespace


Foam::scalar Foam::immersedBodies::stepRatio() const
{
    return mesh_.time().deltaTValue()/mesh_.time().deltaT0Value();
}


void Foam::immersedBodies::beginStep()
{
    clock_ += mesh_.time().deltaTValue();
    meshProperties::slide(mesh_, periodicity_);
    passage_->beginStep();
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


void Foam::immersedBodies::predictPoses()
{
    const scalar dt = mesh_.time().deltaTValue();

    window_.move(dt);

    for (immersedBody& body : bodies_)
    {
        body.predictPose
        (
            dt, window_.meanVelocity(), window_.displacement()
        );
    }

    contacts_->advance(bodies_, h_, dt, window_.meanVelocity());
}


void Foam::immersedBodies::predict
(
    const bool again,
    const scalar enough,
    const bool inBands
)
{
    addProfiling(predict, "immersedBodies::predict");

    predictPoses();
    resolved_->update(enough, again);
    if (!inBands)
    {
        unresolved_->update();
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
    shareStates(bodies_);
    contacts_->endStep();

    for (immersedBody& body : bodies_)
    {
        body.endStep(stepRatio(), crowd_.active());
    }

    contacts_->updateSleep(bodies_, mesh_.time().deltaTValue());
    resolved_->loads().noteUnresolved(unresolved_->coupling());

    // Contact knows the bodies as they are before any leave
    const bool overlap = contacts_->overlap(bodies_, region(), h_);
    const bool good = traffic_->leave() && !overlap;

    // The regions go with the positions so far
    wrapPositions();

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
