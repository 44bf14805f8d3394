// SPDX-License-Identifier: GPL-3.0-or-later

#include "incompressibleFluid.H"
#include "adjustPhi.H"
#include "constrainHbyA.H"
#include "constrainPressure.H"
#include "fvcDdt.H"
#include "fvcFlux.H"
#include "fvcGrad.H"
#include "fvcMeshPhi.H"
#include "fvcSnGrad.H"
#include "fvmLaplacian.H"
#include "LeesEdwardsFlux.H"
#include "profiling.H"


void Foam::flowSolvers::incompressibleFluid::continuityErrors()
{
    continuityErrors(fluxSums_.continuity());
}


void Foam::flowSolvers::incompressibleFluid::continuityErrors
(
    const vector& ofProcessor
)
{
    const vector sums(returnReduce(ofProcessor, sumOp<vector>()));

    const scalar sumLocal = runTime_.deltaTValue()*sums[0]/sums[2];
    const scalar global = runTime_.deltaTValue()*sums[1]/sums[2];

    cumulativeContErr.value() += global;

    Info<< "time step continuity errors : sum local = " << sumLocal
        << ", global = " << global
        << ", cumulative = " << cumulativeContErr.value() << endl;
}


Foam::tmp<Foam::surfaceScalarField>
Foam::flowSolvers::incompressibleFluid::predictFlux
(
    const volScalarField& rAU,
    const volVectorField& HbyA
)
{
    tmp<surfaceScalarField> tphiHbyA
    (
        new surfaceScalarField("phiHbyA", fvc::flux(HbyA))
    );
    surfaceScalarField& phiHbyA = tphiHbyA.ref();

    // The default is what the versions without this switch do
    if (pimple_.dict().lookupOrDefault("ddtCorr", true))
    {
        tmp<surfaceScalarField> tcorr
        (
            MRF.zeroFilter
            (
                fvc::interpolate(rAU)*fvc::ddtCorr(U_, phi_, Uf)
            )
        );

        LeesEdwards::clear(mesh_, tcorr.ref());
        phiHbyA += tcorr;
    }

    MRF.makeRelative(phiHbyA);

    if (p_.needReference())
    {
        fvc::makeRelative(phiHbyA, U_);
        adjustPhi(phiHbyA, U_, p_);
        fvc::makeAbsolute(phiHbyA, U_);
    }

    return tphiHbyA;
}


void Foam::flowSolvers::incompressibleFluid::correctPressure()
{
    fvVectorMatrix& UEqn = tUEqn.ref();

    volScalarField rAU(1.0/UEqn.A());
    volVectorField HbyA(constrainHbyA(rAU*UEqn.H(), U_, p_));
    tmp<surfaceScalarField> tphiHbyA(predictFlux(rAU, HbyA));
    surfaceScalarField& phiHbyA = tphiHbyA.ref();

    tmp<volScalarField> rAtU(rAU);

    // SIMPLEC: the neighbours' corrections go to the diagonal; the bound
    // keeps it positive
    if (pimple_.consistent())
    {
        rAtU = 1.0/max(1.0/rAU - UEqn.H1(), 0.1/rAU);
        phiHbyA +=
            fvc::interpolate(rAtU() - rAU)*fvc::snGrad(p_)*mesh_.magSf();
        HbyA -= (rAU - rAtU())*fvc::grad(p_);
    }

    // Frees memory before the linear solver needs it
    if (pimple_.nCorrPISO() <= 1)
    {
        tUEqn.clear();
    }

    constrainPressure(p_, U_, phiHbyA, rAtU(), MRF);

    while (pimple_.correctNonOrthogonal())
    {
        fvScalarMatrix pEqn
        (
            fvm::laplacian(rAtU(), p_) == fvc::div(phiHbyA)
        );

        pEqn.setReference(pRefCell, pRefValue);

        pEqn.solve(mesh_.solver(p_.select(pimple_.finalInnerIter())));

        if (pimple_.finalNonOrthogonalIter())
        {
            phi_ = phiHbyA - pEqn.flux();
        }
    }

    continuityErrors();

    // For the next momentum equation only: the flux keeps the full pressure
    p_.relax();

    U_ = HbyA - rAtU*fvc::grad(p_);
    U_.correctBoundaryConditions();
    fvOptions.correct(U_);

    fvc::correctUf(Uf, U_, phi_);

    fvc::makeRelative(phi_, U_);
}


void Foam::flowSolvers::incompressibleFluid::pressureCorrector()
{
    addProfiling(pressure, "pressureCorrector");

    while (pimple_.correct())
    {
        correctPressure();
    }

    tUEqn.clear();
}
