// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"

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
    if (iteration_.first() || !plan_.layersPay())
    {
        return 0;
    }

    const scalar change = bodies_.resolved().pressure().update(p_, drive, dt);

    // The second one is compared with nothing of this time step; from the third
    // one on added mass helps
    return plan_.beyondPlain() ? lag*change : 0;
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
        solved, free && iteration_.first(), plan_.addedMass()
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
        iteration_.setReach(plan_.viscousReach());
    }

    iteration_.note(change, bodySpeed(), free, plan_.posed(), plan_.rate());
    if (plan_.oneSuffices())
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
         && !plan_.crowdFollows()
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
