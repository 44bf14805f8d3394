// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "carrierFlow.H"
#include "fvcGrad.H"

namespace
{
    //- Last outer iteration that is made for loads only, where no body follows
    //  them: most of what an acceleration makes them lag by is gone then, and
    //  the rest would take many more
    const Foam::label lastLoadOuter = 4;

    //- Courant number up to which iterations are accelerated, and the part of
    //  the tolerance down to which: slow ones have to go that far
    const Foam::scalar maxAccelerated = 2;
    const Foam::scalar leastAccelerated = 0.1;
}


Foam::scalar Foam::flowSolvers::immersedFluid::fluidSpeed() const
{
    return CoNum*bodies_->minCellSize()/runTime_.deltaTValue();
}


void Foam::flowSolvers::immersedFluid::correctUnresolved
(
    const ddtCoefficients& ddt
)
{
    if (!bodies_->nUnresolved())
    {
        return;
    }

    tmp<volScalarField> tk, tepsilon;

    if (bodies_->disperse())
    {
        tk = momentumTransport->k();
        tepsilon = momentumTransport->epsilon();
    }

    const tmp<volScalarField> tnu(momentumTransport->nu());
    const carrierFlow flow
    {
        U_,
        tnu().primitiveField(),
        viscosity(),
        tk.valid() ? &tk().primitiveField() : nullptr,
        tepsilon.valid() ? &tepsilon().primitiveField() : nullptr
    };
    const tmp<vectorField> tchange(bodies_->correctUnresolved(ddt, flow));

    if (bodies_->frozen())
    {
        return;
    }

    force_ += tchange();
    U_.primitiveFieldRef() += tchange()/ddt.c;
    U_.correctBoundaryConditions();
}


void Foam::flowSolvers::immersedFluid::bodyCorrector
(
    const ddtCoefficients& ddt,
    const vectorField& dU
)
{
    const bool free = bodies_->anyFree();

    const scalar change = max
    (
        bodies_->correct
        (
            ddt,
            tUEqn(),
            A0_(),
            U_,
            drive()(),
            dU,
            free && outer_ == 1
        ),
        acceleration_.jump()
    );

    // A body that hardly moves yet is compared with the fluid, one at rest on
    // others with what keeps it there
    const scalar speed = max
    (
        max(bodies_->maxSpeed(), bodies_->contactSpeed()),
        0.01*fluidSpeed()
    );

    change_ = change/max(speed, VSMALL);
    if (outer_ == 1)
    {
        firstChange_ = change_;

        // In a window the Courant number is that relative to it
        speedScale_ = max
        (
            fluidSpeed() + mag(bodies_->window().velocity()),
            max(change, bodies_->contactSpeed())
        );

        // From rest only the first iteration knows how fast it will be
        if (CoNum < SMALL)
        {
            speedScale_ =
                max(speedScale_, gMax(mag(U_.primitiveField())()));
        }
    }

    // Through the mesh, the first iteration knows the pressure of the old pose
    // only. Steps on the way to a steady state need not converge.
    const bool posed =
        (outer_ > 1 || bodies_->window().comoving())
     && outer_ >= bodies_->minOuterCorrectors();

    converged_ = !bodies_->moving()
     || bodies_->atRest()
     || !bodies_->nResolved()
     || bodies_->steady().active()
     || (posed && change <= bodies_->tolerance()*speed)
     || (posed && !free && outer_ >= lastLoadOuter);

    // Seldom needed: most steps take two iterations
    if (free && !converged_ && outer_ > 2)
    {
        const scalar fastest = gMax(mag(U_.primitiveField())());

        lost_ = !(max(change, fastest) < 10*speedScale_);
    }

    // What is combined has no flux: of that which iterations change little
    const bool more =
        !converged_ && !lost_ && outer_ < bodies_->nOuterCorrectors();

    acceleration_.watch
    (
        outer_,
        free && more && CoNum < maxAccelerated ? change_ : 0,
        leastAccelerated*bodies_->tolerance()
    );
}


void Foam::flowSolvers::immersedFluid::accelerate(const vectorField& changes)
{
    if (!acceleration_.active())
    {
        return;
    }

    const vector before(bodies_->window().velocity());

    acceleration_.apply(changes, dU_, *bodies_, p_);
    gradP_ = fvc::grad(p_);
    makeRelative(bodies_->window().velocity() - before);
}
