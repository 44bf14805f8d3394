// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "adjustPhi.H"
#include "constrainPressure.H"
#include "findRefCell.H"
#include "freeVelocities.H"
#include "inletOutletFvPatchFields.H"
#include "meshProperties.H"
#include "profiling.H"
#include "smoothedFlux.H"

namespace
{
    //- Response of the fluid in layers, at least. That to a pressure which
    //  alternates is momentumEquation::smoothingPart, and enough in a crowd,
    //  most of whose steps have one iteration. In narrow gaps the pressure is
    //  smooth, and converges slowly with as much.
    const Foam::scalar leastResponse = 0.01;

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
}


void Foam::flowSolvers::immersedFluid::pressureCorrector()
{
    addProfiling(pressure, "pressureCorrector");

    if (momentum_.diverged())
    {
        iteration_.lose();
        return;
    }

    const ddtCoefficients ddt(meshProperties::ddt(mesh_, U_.name()));
    const dimensionedScalar tau("tau", dimTime, 1/ddt.c);

    predictBodyFlux();

    const scalarField divPhi(correction_.divergence());

    layers_.begin(plan_.layersAhead());
    if (layers_.active())
    {
        if (iteration_.first() && projection_.isNew())
        {
            // Once in a run, which has to begin as it would have gone on
            solveProjection(tau, divPhi);
        }
        correction_.complete(tau.value());
        layers_.correct
        (
            tau,
            bodies_.crowd().active()
          ? momentumEquation::smoothingPart
          : leastResponse,
            divPhi,
            phi_,
            p_
        );
    }
    solveProjection(tau, layers_.active() ? correction_.divergence() : divPhi);
    correction_.correctFlux(tau, plan_.othersMayWait());
    updatePressure(divPhi);
    correction_.find(tau.value());
    if (layers_.active())
    {
        layers_.addVelocity(tau, correction_.dU());
    }
    holdFlowRate(tau.value());

    const vectorField before(freeVelocities::get(bodies_.list()));

    bodyCorrector(ddt);
    makeRelative(bodies_.window().velocity());
    correction_.apply();
    fvOptions.correct(U_);
    accelerate(freeVelocities::get(bodies_.list()) - before);

    if (!plan_.bandsFollow())
    {
        correction_.complete(tau.value());
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


void Foam::flowSolvers::immersedFluid::predictBodyFlux()
{
    const volScalarField& smoothing = momentum_.smoothing();
    const smoothedFlux flux(U_, p_, correction_.gradP(), smoothing);

    if (momentum_.inBands())
    {
        const immersedRegion& region = bodies_.region();
        DynamicList<label> faces;

        region.surroundings().faces(region.cells(), faces);
        flux.set(faces, phi_);
    }
    else
    {
        momentum_.keepFlux();
        flux.set(phi_);
    }

    MRF.makeRelative(phi_);
    bodies_.region().sums().shieldFlux(phi_);

    // In the bands of bodies it is the same as before
    if
    (
        p_.needReference()
     && (!momentum_.inBands() || openPatches())
     && crossesPatches(phi_)
    )
    {
        adjustPhi(phi_, U_, p_);
    }

    constrainPressure(p_, U_, phi_, smoothing, MRF);
}


void Foam::flowSolvers::immersedFluid::solveProjection
(
    const dimensionedScalar& tau,
    const scalarField& divPhi
)
{
    const label n = projection_.nCorrections(pimple_.nNonOrthCorr());

    projection_.begin(iteration_.first());

    for (label i = 0; i <= n; ++i)
    {
        projection_.solve
        (
            mesh_.solver(p_.select(true)),
            divPhi,
            tau,
            pRefValue - getRefCellValue(p_, pRefCell)
        );
    }
}


void Foam::flowSolvers::immersedFluid::updatePressure
(
    const scalarField& divPhi
)
{
    const volScalarField& dp = projection_.dp();
    const scalarField& nu = momentum_.viscosity();
    scalarField& p = p_.primitiveFieldRef();

    forAll(p, celli)
    {
        p[celli] += dp[celli] - nu[celli]*divPhi[celli];
    }
    p_.correctBoundaryConditions();
}


void Foam::flowSolvers::immersedFluid::holdFlowRate(const scalar tau)
{
    if (flowRate_)
    {
        const vector old(flowRate_->acceleration());

        correction_.dU() -= flowRate_->correctFlux(tau, phi_);
        momentum_.force() += flowRate_->acceleration() - old;
    }
}


void Foam::flowSolvers::immersedFluid::makeRelative(const vector& V)
{
    if (V != vector::zero)
    {
        phi_ -= dimensionedVector("V", dimVelocity, V) & mesh_.Sf();
    }
}
