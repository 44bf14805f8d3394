// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "bodyContacts.H"

namespace
{
    //- Courant number up to which iterations are accelerated
    const Foam::scalar maxAccelerated = 2;

    //- Part of the tolerance down to which they are, as slow ones have to go
    //  that far, and the relative change below which linear solvers are seen
    const Foam::scalar farEnough = 0.1;
    const Foam::scalar noise = 1e-5;

    //- Way, over that allowed in a time step, on which no iteration sends a
    //  body that is to converge: contact would take as many steps of its own
    const Foam::scalar lostWay = 5;

    //- Part of what a change of the pressure would do to a body that the next
    //  iteration may: what its load has not seen, in the layer
    const Foam::scalar lag = 0.3;
}


Foam::scalar Foam::flowSolvers::immersedFluid::fluidSpeed() const
{
    return CoNum*bodies_.minCellSize()/runTime_.deltaTValue();
}


Foam::scalar Foam::flowSolvers::immersedFluid::speedLimit
(
    const scalar change
) const
{
    // In a window the Courant number is that relative to it
    const scalar speed = max
    (
        fluidSpeed() + mag(bodies_.window().velocity()),
        max(change, bodies_.list().contactSpeed())
    );

    // From rest only the first iteration knows how fast it will be
    return CoNum < SMALL
      ? max(speed, gMax(mag(U_.primitiveField())()))
      : speed;
}


Foam::scalar Foam::flowSolvers::immersedFluid::bodySpeed() const
{
    // A body that hardly moves yet is compared with the fluid, one at rest on
    // others with what keeps it there
    return max
    (
        max(bodies_.list().maxSpeed(), bodies_.list().contactSpeed()),
        0.01*fluidSpeed()
    );
}


bool Foam::flowSolvers::immersedFluid::oneSuffices() const
{
    return !bodies_.moving()
     || bodies_.list().atRest()
     || !bodies_.list().anyResolved()
     || bodies_.steady().active();
}


bool Foam::flowSolvers::immersedFluid::crowdFollows() const
{
    // What the first iteration leaves in the loads is smoothed by the mass of
    // bodies that are free, and of no others
    return
        bodies_.crowd().active() && !bodies_.crowd().towed()
     && layers_.active();
}


bool Foam::flowSolvers::immersedFluid::posed() const
{
    // Through the mesh the first iteration knows the pressure of the old poses
    // only, unless that of the layers has been found
    return
        !iteration_.first()
     || bodies_.window().comoving()
     || crowdFollows();
}


Foam::outerIteration::rate Foam::flowSolvers::immersedFluid::rate() const
{
    return
        acceleration_.active() ? outerIteration::rate::slow
      : crowdFollows() ? outerIteration::rate::third
      : outerIteration::rate::measured;
}


Foam::scalar Foam::flowSolvers::immersedFluid::addedMass() const
{
    // Of a disc or sphere that is alone in potential flow
    const scalar alone = bodies_.space().twoD() ? 1 : 0.5;

    if (bodies_.crowd().active())
    {
        return bodies_.crowd().goesOn() ? alone : 0;
    }

    // Velocities that converge in two iterations do so to a smaller error
    // without; others do so fastest half way between alone and at a wall
    const bool struggles = suddenStart() || iteration_.number() > nPlain;

    if (!layersPay() || !(struggles || CoNum < SMALL))
    {
        return 0;
    }

    // A group that is swept along a channel has more: from the second iteration
    // of a sudden start on its changes would grow
    const scalar halfWay = 0.5*(alone + bodies_.contacts().addedMass());

    return suddenStart() && iteration_.grown() ? 2*halfWay : halfWay;
}


Foam::scalar Foam::flowSolvers::immersedFluid::pressureChange
(
    const scalar dt
)
{
    const vector drive(flowRate_ ? flowRate_->acceleration() : vector::zero);

    if (bodies_.crowd().active())
    {
        return bodies_.resolved().correctCrowd(p_, drive, dt);
    }
    if (iteration_.first() || !layersPay())
    {
        return 0;
    }

    const scalar change = bodies_.resolved().pressure().update(p_, drive, dt);

    // The second one is compared with nothing of this time step; from the third
    // one on added mass helps
    return iteration_.number() > nPlain ? lag*change : 0;
}


void Foam::flowSolvers::immersedFluid::bodyCorrector
(
    const ddtCoefficients& ddt
)
{
    const bool free = bodies_.list().anyFree();
    const tmp<vectorField> tdrive(momentum_.drive(correction_.gradP()));
    const solvedMomentum solved
    {
        ddt, momentum_.matrix(), momentum_.A(), U_, tdrive(), correction_.dU()
    };
    const scalar ofBodies = bodies_.resolved().correct
    (
        solved, free && iteration_.first(), addedMass()
    );
    iteration_.noteVelocities(ofBodies);

    const scalar change = max
    (
        max(ofBodies, pressureChange(1/ddt.c)),
        acceleration_.jump()
    );

    if (iteration_.first())
    {
        iteration_.setLimit(speedLimit(change));
        iteration_.setReach(viscousReach_);
    }

    iteration_.note(change, bodySpeed(), free, posed(), rate());
    if (oneSuffices())
    {
        iteration_.end();
    }
    if (free && iteration_.many())
    {
        iteration_.noteFastest(gMax(mag(U_.primitiveField())()));
    }
    if (free && way() > lostWay)
    {
        iteration_.lose();
    }
    watchChanges(free);
}


void Foam::flowSolvers::immersedFluid::watchChanges(const bool free)
{
    // What is combined has no flux: of that which iterations change little. One
    // that has converged is combined if those before it were: slow parts of
    // what is left are larger than what it has changed. Those of a crowd are of
    // other bodies each time.
    if (!iteration_.converged())
    {
        acceleration_.watch
        (
            iteration_.number(),
            free
         && iteration_.more()
         && CoNum < maxAccelerated
         && !crowdFollows()
          ? iteration_.change()
          : 0,
            max(farEnough*iteration_.tolerance(), noise),
            layers_.active()
        );
    }
}


void Foam::flowSolvers::immersedFluid::accelerate(const vectorField& changes)
{
    if (!acceleration_.active())
    {
        return;
    }

    const vector before(bodies_.window().velocity());

    acceleration_.apply(changes, correction_.dU(), bodies_, p_);
    correction_.updateGradP();
    makeRelative(bodies_.window().velocity() - before);
}
