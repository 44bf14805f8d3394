// SPDX-License-Identifier: GPL-3.0-or-later

#include "velocityCorrection.H"
#include "comovingDerivative.H"
#include "faceSums.H"
#include "fvcGrad.H"
#include "pairGradient.H"

Foam::velocityCorrection::velocityCorrection
(
    projection& projection,
    const volScalarField& p,
    surfaceScalarField& phi,
    volVectorField& U,
    const immersedRegion& region,
    const bool moving
)
:
    projection_(projection),
    p_(p),
    dp_(projection.dp()),
    phi_(phi),
    U_(U),
    paired_(pairGradient::serves(p.mesh(), "grad(p)")),
    waits_(false)
{
    if (moving)
    {
        pending_.reset(new pendingCorrection(region, dp_));
    }
}


void Foam::velocityCorrection::updateGradP()
{
    if (!paired_ || !gradP_.valid())
    {
        gradP_ = fvc::grad(p_);
    }

    // To the last digit as later, which a restart has to be
    if (paired_)
    {
        pairGradient::set(p_, gradP_.ref());
    }
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


bool Foam::velocityCorrection::waiting() const
{
    return pending_.valid() && pending_->active();
}


bool Foam::velocityCorrection::outdated() const
{
    return waiting() && pending_->outdated();
}


Foam::scalarField Foam::velocityCorrection::divergence() const
{
    // What waits is free of it but for the pressure of which it waits
    return
        waiting() && projection_.compact()
      ? pending_->divergence(phi_)
      : Foam::divergence(phi_);
}


void Foam::velocityCorrection::correctFlux
(
    const dimensionedScalar& tau,
    const bool mayWait
)
{
    waits_ = mayWait && paired_ && gradP_.valid() && pending_.valid()
     && pending_->begin();

    if (waits_ && projection_.compact())
    {
        projection_.correctFlux(tau.value(), pending_->faces(), phi_);
    }
    else
    {
        projection_.correctFlux(tau, phi_);
    }
}


void Foam::velocityCorrection::find(const scalar tau)
{
    if (waits_)
    {
        pending_->add(p_, dp_, tau, gradP_.ref(), dU_);
    }
    else if (paired_ && gradP_.valid())
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
    if (!waiting())
    {
        return;
    }

    if (projection_.compact())
    {
        projection_.correctOtherFluxes
        (
            tau, pending_->sum(), pending_->faces(), phi_
        );
    }
    pending_->complete(p_, tau, gradP_.ref(), dU_, U_);
    U_.correctBoundaryConditions();
}


void Foam::velocityCorrection::reset()
{
    gradP_.clear();

    if (pending_.valid())
    {
        pending_->cancel();
    }
}
