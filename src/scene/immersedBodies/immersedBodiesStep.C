// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "bodyPassage.H"
#include "comovingDerivative.H"
#include "compat.H"
#include "contactModel.H"
#include "meshProperties.H"
#include "profiling.H"
#include "unresolvedCoupling.H"

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
    region_.updateGeometry(bodies_);
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

    addContact();
}


void Foam::immersedBodies::predict(const bool again, const scalar enough)
{
    addProfiling(predict, "immersedBodies::predict");

    predictPoses();
    if (enough > 0)
    {
        region_.select(crowd_.unsettled(enough));
    }
    else
    {
        region_.selectAll();
    }
    region_.updateGeometry(bodies_, false, again);
    unresolved_->update(bodies_, h_);
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


Foam::comovingDerivative& Foam::immersedBodies::frame()
{
    return frame_();
}


void Foam::immersedBodies::shareState()
{
    if (!Pstream::parRun())
    {
        return;
    }

    const label n = 5;
    vectorField packed(n*bodies_.size());

    forAll(bodies_, bodyi)
    {
        const bodyState& state = bodies_[bodyi].state();
        vector* to = &packed[n*bodyi];

        to[0] = state.position;
        to[1] = state.orientation.v();
        to[2] = vector(state.orientation.w(), 0, 0);
        to[3] = state.U;
        to[4] = state.omega;
    }

    compat::broadcast(packed);

    forAll(bodies_, bodyi)
    {
        bodyState state;
        const vector* from = &packed[n*bodyi];

        state.position = from[0];
        state.orientation = quaternion(from[2].x(), from[1]);
        state.U = from[3];
        state.omega = from[4];

        bodies_[bodyi].setState(state);
    }
}


bool Foam::immersedBodies::endStep()
{
    addProfiling(endStep, "immersedBodies::endStep");

    // The poses that go with the last correction of the velocities
    predictPoses();
    shareState();
    contact_->endStep();

    for (immersedBody& body : bodies_)
    {
        body.endStep(stepRatio(), crowd_.active());
    }

    if (sleep_.active())
    {
        sleep_.update
        (
            bodies_, periodicity_, walls_(), mesh_.time().deltaTValue()
        );
    }

    bool good = leave();

    if (proximity_.check(bodies_, region_, h_))
    {
        good = false;
    }

    // The regions go with the positions so far
    wrapPositions();

    return good;
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
