// SPDX-License-Identifier: GPL-3.0-or-later

#include "velocityCorrection.H"
#include "comovingDerivative.H"
#include "fvcGrad.H"
#include "pairGradient.H"

Foam::velocityCorrection::velocityCorrection
(
    const volScalarField& p,
    const volScalarField& dp,
    volVectorField& U,
    const immersedRegion& region,
    const bool moving
)
:
    p_(p),
    dp_(dp),
    U_(U),
    paired_(pairGradient::serves(p.mesh(), "grad(p)")),
    waits_(false)
{
    if (moving)
    {
        pending_.reset(new pendingCorrection(region, dp));
    }
}


void Foam::velocityCorrection::updateGradP()
{
    gradP_ = fvc::grad(p_);
}


void Foam::velocityCorrection::follow
(
    const comovingDerivative& frame,
    const scalar part,
    volScalarField& p
)
{
    frame.follow(part, p, gradP_.ref());

    if (!paired_)
    {
        updateGradP();
    }
}


bool Foam::velocityCorrection::outdated() const
{
    return pending_.valid() && pending_->active() && pending_->outdated();
}


void Foam::velocityCorrection::find(const scalar tau, const bool mayWait)
{
    const bool together = paired_ && gradP_.valid();

    waits_ = mayWait && together && pending_.valid() && pending_->begin();

    if (waits_)
    {
        pending_->add(p_, dp_, tau, gradP_.ref(), dU_);
    }
    else if (together)
    {
        pairGradient::set(p_, dp_, tau, gradP_.ref(), dU_);
    }
    else
    {
        updateGradP();
        dU_ = tau*fvc::grad(dp_, "grad(p)")().primitiveField();
    }
}


void Foam::velocityCorrection::apply()
{
    if (waits_)
    {
        pending_->correct(dU_, U_);
    }
    else
    {
        U_.primitiveFieldRef() -= dU_;
    }
    U_.correctBoundaryConditions();
}


void Foam::velocityCorrection::complete(const scalar tau)
{
    if (pending_.valid() && pending_->active())
    {
        pending_->complete(p_, tau, gradP_.ref(), dU_, U_);
        U_.correctBoundaryConditions();
    }
}


void Foam::velocityCorrection::reset()
{
    gradP_.clear();

    if (pending_.valid())
    {
        pending_->cancel();
    }
}
