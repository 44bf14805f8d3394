// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "adjustPhi.H"
#include "constrainPressure.H"
#include "faceSums.H"
#include "findRefCell.H"
#include "fvcGrad.H"
#include "inletOutletFvPatchFields.H"
#include "meshProperties.H"
#include "pairGradient.H"
#include "profiling.H"
#include "smoothedFlux.H"

namespace
{
    //- Does anything flow through a patch that is not coupled
    bool crossesPatches(const Foam::surfaceScalarField& phi)
    {
        bool any = false;

        for (const Foam::fvsPatchScalarField& patch : phi.boundaryField())
        {
            for (const Foam::scalar flux : patch)
            {
                any = any || (!patch.coupled() && flux != 0);
            }
        }

        return Foam::returnReduce(any, Foam::orOp<bool>());
    }


    //- Swap the values of two fluxes, without copies
    void swapValues
    (
        Foam::surfaceScalarField& one,
        Foam::surfaceScalarField& other
    )
    {
        one.primitiveFieldRef().swap(other.primitiveFieldRef());

        forAll(one.boundaryField(), patchi)
        {
            one.boundaryFieldRef()[patchi].swap
            (
                other.boundaryFieldRef()[patchi]
            );
        }
    }
}


bool Foam::flowSolvers::immersedFluid::openPatches() const
{
    for (const fvPatchVectorField& patch : U_.boundaryField())
    {
        // As adjustPhi() has it
        if
        (
            !patch.coupled()
         && (
                !patch.fixesValue()
             || isA<inletOutletFvPatchVectorField>(patch)
            )
        )
        {
            return true;
        }
    }

    return false;
}


void Foam::flowSolvers::immersedFluid::predictImmersedFlux()
{
    const smoothedFlux flux(U_, p_, gradP_(), smoothing_());

    if (bandOnly_)
    {
        DynamicList<label> faces;
        bodies_->region().bandFaces(faces);
        flux.set(faces, phi_);
    }
    else
    {
        if (convecting_.valid())
        {
            swapValues(phi_, convecting_());
        }
        flux.set(phi_);
    }

    MRF.makeRelative(phi_);
    bodies_->region().shieldFlux(phi_);

    // In the bands of bodies it is the same as before
    if
    (
        p_.needReference()
     && (!bandOnly_ || openPatches())
     && crossesPatches(phi_)
    )
    {
        adjustPhi(phi_, U_, p_);
    }

    constrainPressure(p_, U_, phi_, smoothing_(), MRF);
}


void Foam::flowSolvers::immersedFluid::project
(
    const dimensionedScalar& tau,
    const scalarField& divPhi
)
{
    projection_->begin(outer_ == 1);

    while (pimple_.correctNonOrthogonal())
    {
        projection_->solve
        (
            mesh_.solver(p_.select(true)),
            divPhi,
            tau,
            pRefValue - getRefCellValue(p_, pRefCell)
        );

        if (pimple_.finalNonOrthogonalIter())
        {
            projection_->correctFlux(tau, phi_);
        }
    }
}


void Foam::flowSolvers::immersedFluid::setGradients
(
    const scalar tau,
    const bool wait
)
{
    const volScalarField& dp = projection_->dp();

    if (wait)
    {
        pending_->add(p_, dp, tau, gradP_.ref(), dU_);
    }
    else if (pairOfGradients_ && gradP_.valid())
    {
        pairGradient::set(p_, dp, tau, gradP_.ref(), dU_);
    }
    else
    {
        gradP_ = fvc::grad(p_);
        dU_ = tau*fvc::grad(dp, "grad(p)")().primitiveField();
    }
}


void Foam::flowSolvers::immersedFluid::correctVelocity(const bool wait)
{
    if (wait)
    {
        pending_->correct(dU_, U_);
    }
    else
    {
        U_.primitiveFieldRef() -= dU_;
    }
    U_.correctBoundaryConditions();
    fvOptions.correct(U_);
}


void Foam::flowSolvers::immersedFluid::endWait(const scalar tau)
{
    if (pending_.valid() && pending_->active())
    {
        pending_->complete(p_, tau, gradP_.ref(), dU_, U_);
        U_.correctBoundaryConditions();
    }
}


void Foam::flowSolvers::immersedFluid::holdFlowRate(const scalar tau)
{
    if (flowRate_)
    {
        const vector old(flowRate_->acceleration());

        dU_ -= flowRate_->correctFlux(tau, phi_);
        force_ += flowRate_->acceleration() - old;
    }
}


void Foam::flowSolvers::immersedFluid::pressureCorrector()
{
    if (!immersed())
    {
        incompressibleFluid::pressureCorrector();
        return;
    }

    if (bodies_->frozen())
    {
        converged_ = true;
        return;
    }

    addProfiling(pressure, "pressureCorrector");

    const ddtCoefficients ddt(meshProperties::ddt(mesh_, U_.name()));
    const dimensionedScalar tau("tau", dimTime, 1/ddt.c);
    const volScalarField& dp = projection_->dp();

    predictImmersedFlux();

    const scalarField divPhi(divergence(phi_));

    project(tau, divPhi);

    const scalarField& nu = viscosity();
    scalarField& p = p_.primitiveFieldRef();

    forAll(p, celli)
    {
        p[celli] += dp[celli] - nu[celli]*divPhi[celli];
    }
    p_.correctBoundaryConditions();

    const bool wait = canWait() && pending_->begin();

    setGradients(tau.value(), wait);
    holdFlowRate(tau.value());

    const vectorField before(bodies_->velocities());

    bodyCorrector(ddt, dU_);
    makeRelative(bodies_->window().velocity());
    correctVelocity(wait);

    accelerate(bodies_->velocities() - before);

    if (!bandsFollow())
    {
        endWait(tau.value());
    }
}
