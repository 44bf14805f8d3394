// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "adjustPhi.H"
#include "constrainPressure.H"
#include "findRefCell.H"
#include "fvcDiv.H"
#include "fvcGrad.H"
#include "fvmLaplacian.H"
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

    if (dp_->needReference())
    {
        adjustPhi(tphi.ref(), U_, dp_());
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
    volScalarField& dp = dp_();

    // In later iterations the increment is small: its last value is no guess
    dp = dimensionedScalar(dp.dimensions(), Zero);

    while (pimple_.correctNonOrthogonal())
    {
        fvScalarMatrix dpEqn
        (
            fvm::laplacian(tau, dp, "laplacian((1|A(U)),p)") == divPhi
        );

        dpEqn.setReference
        (
            pRefCell,
            pRefValue - getRefCellValue(p_, pRefCell)
        );
        dpEqn.solve(mesh_.solver(p_.select(true)));

        if (pimple_.finalNonOrthogonalIter())
        {
            phi_ = phiHbyA - dpEqn.flux();
        }
    }
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

    addProfiling(pressure, "pressureCorrector");

    const ddtCoefficients ddt(mesh_, U_.name());
    const dimensionedScalar tau("tau", dimTime, 1/ddt.c);
    const volScalarField& dp = dp_();

    const tmp<surfaceScalarField> tphiHbyA(predictImmersedFlux());
    const surfaceScalarField& phiHbyA = tphiHbyA();
    const volScalarField divPhi(fvc::div(phiHbyA));

    project(tau, phiHbyA, divPhi);

    p_.primitiveFieldRef() += dp.primitiveField()
      - viscosity().primitiveField()*divPhi.primitiveField();
    p_.correctBoundaryConditions();
    gradP_ = fvc::grad(p_);

    vectorField dU
    (
        tau.value()*fvc::grad(dp, "grad(p)")().primitiveField()
    );
    holdFlowRate(tau.value(), dU);

    bodyCorrector(ddt, dU);
    makeRelative();

    U_.primitiveFieldRef() -= dU;
    U_.correctBoundaryConditions();
    fvOptions.correct(U_);
}
