// SPDX-License-Identifier: GPL-3.0-or-later

#include "denseFluid.H"
#include "adjustPhi.H"
#include "constrainPressure.H"
#include "findRefCell.H"
#include "fvcGrad.H"
#include "fvmLaplacian.H"
#include "meshProperties.H"
#include "profiling.H"
#include "smoothedFlux.H"
#include "surfaceInterpolate.H"
#include "unresolvedBodies.H"

void Foam::flowSolvers::denseFluid::project
(
    const volScalarField& mobility,
    const scalarField& imbalance
)
{
    const surfaceScalarField tau(fvc::interpolate(mobility));
    const label n = pimple_.nNonOrthCorr();

    dp_ = dimensionedScalar(dp_.dimensions(), Zero);

    for (label i = 0; i <= n; ++i)
    {
        fvScalarMatrix eqn
        (
            fvm::laplacian(tau, dp_, "laplacian((1|A(U)),p)")
        );

        eqn.source() += mesh_.V()*imbalance;
        eqn.setReference
        (
            pRefCell, pRefValue - getRefCellValue(p_, pRefCell)
        );
        eqn.solve(mesh_.solver(p_.select(true)));

        if (i == n)
        {
            phi_ -= eqn.flux();
        }
    }
}


void Foam::flowSolvers::denseFluid::pressureCorrector()
{
    addProfiling(pressure, "pressureCorrector");

    const scalarField response(part_/inertia());
    volScalarField mobility
    (
        IOobject("(1|A(U))", runTime_.timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimTime, Zero),
        "zeroGradient"
    );

    mobility.primitiveFieldRef() = void_.primitiveField()*response;
    mobility.correctBoundaryConditions();

    smoothedFlux(void_*U_, p_, gradP_(), smoothing_()).set(phi_);
    if (p_.needReference())
    {
        adjustPhi(phi_, U_, p_);
    }
    constrainPressure(p_, U_, phi_, mobility, MRF);

    scalarField lost(imbalance());

    // What a limit of the void fraction takes off has no place to go
    if (limited_ && p_.needReference())
    {
        lost -= gSum(mesh_.V()*lost)/gSum(mesh_.V());
    }

    project(mobility, lost);

    const tmp<volVectorField> tgrad(fvc::grad(dp_));
    const tmp<volScalarField> tnu(momentumTransport->nu());

    a_ -= tgrad().primitiveField();
    U_.primitiveFieldRef() -= response*tgrad().primitiveField();
    U_.correctBoundaryConditions();
    fvOptions.correct(U_);

    p_.primitiveFieldRef() +=
        dp_.primitiveField() - tnu().primitiveField()*lost;
    p_.correctBoundaryConditions();
    gradP_.clear();
    smoothing_.clear();

    bodies_.unresolved().advance(meshProperties::ddt(mesh_, U_.name()), U_, a_);
}
