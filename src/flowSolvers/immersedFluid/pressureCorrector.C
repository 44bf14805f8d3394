// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "adjustPhi.H"
#include "constrainPressure.H"
#include "findRefCell.H"
#include "fvcDiv.H"
#include "fvcGrad.H"
#include "pairGradient.H"
#include "profiling.H"
#include "smoothedFlux.H"


Foam::tmp<Foam::surfaceScalarField>
Foam::flowSolvers::immersedFluid::predictImmersedFlux()
{
    // Part of the usual pressure smoothing: enough against wiggles, and what
    // it leaks through the bodies is below the error of the layer
    const scalar smoothing = 0.1;
    const volScalarField tau(smoothing/A0_());

    const smoothedFlux flux(U_, p_, gradP_(), tau);

    tmp<surfaceScalarField> tphi(new surfaceScalarField("phiHbyA", phi_));

    if (bandOnly_)
    {
        DynamicList<label> faces;
        bodies_->region().bandFaces(faces);
        flux.set(faces, tphi.ref());
    }
    else
    {
        flux.set(tphi.ref());
    }

    MRF.makeRelative(tphi.ref());
    bodies_->region().shieldFlux(tphi.ref());

    if (p_.needReference())
    {
        adjustPhi(tphi.ref(), U_, p_);
    }

    constrainPressure(p_, U_, tphi(), tau, MRF);

    return tphi;
}


void Foam::flowSolvers::immersedFluid::project
(
    const dimensionedScalar& tau,
    const surfaceScalarField& phiHbyA,
    const volScalarField& divPhi
)
{
    projection_->begin();

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
            projection_->correctFlux(tau, phiHbyA, phi_);
        }
    }
}


void Foam::flowSolvers::immersedFluid::setGradients
(
    const scalar tau,
    vectorField& dU
)
{
    const volScalarField& dp = projection_->dp();

    if (pairOfGradients_ && gradP_.valid())
    {
        pairGradient::set(p_, dp, gradP_.ref(), dU);
        dU *= tau;
        return;
    }

    gradP_ = fvc::grad(p_);
    dU = tau*fvc::grad(dp, "grad(p)")().primitiveField();
}


void Foam::flowSolvers::immersedFluid::holdFlowRate
(
    const scalar tau,
    vectorField& dU
)
{
    if (flowRate_)
    {
        const vector old(flowRate_->acceleration());

        dU -= flowRate_->correctFlux(tau, phi_);
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

    const ddtCoefficients ddt(mesh_, U_.name());
    const dimensionedScalar tau("tau", dimTime, 1/ddt.c);
    const volScalarField& dp = projection_->dp();

    const tmp<surfaceScalarField> tphiHbyA(predictImmersedFlux());
    const surfaceScalarField& phiHbyA = tphiHbyA();
    const volScalarField divPhi(fvc::div(phiHbyA));

    project(tau, phiHbyA, divPhi);

    p_.primitiveFieldRef() += dp.primitiveField()
      - viscosity().primitiveField()*divPhi.primitiveField();
    p_.correctBoundaryConditions();

    vectorField dU;
    setGradients(tau.value(), dU);
    holdFlowRate(tau.value(), dU);

    bodyCorrector(ddt, dU);
    makeRelative();

    U_.primitiveFieldRef() -= dU;
    U_.correctBoundaryConditions();
    fvOptions.correct(U_);
}
