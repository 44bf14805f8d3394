// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "fvcGrad.H"
#include "fvmDdt.H"
#include "fvmLaplacian.H"


Foam::tmp<Foam::fvVectorMatrix>
Foam::flowSolvers::immersedFluid::divDevSigma()
{
    // The transposed gradient contributes nothing to a uniform viscosity, but
    // its discrete form does where the velocity bends, at the bodies
    if (immersed() && uniformViscosity_)
    {
        return -fvm::laplacian(momentumTransport->nuEff(), U_);
    }

    return incompressibleFluid::divDevSigma();
}


Foam::tmp<Foam::fvVectorMatrix>
Foam::flowSolvers::immersedFluid::assembleMomentum()
{
    if (!stokes_)
    {
        return incompressibleFluid::assembleMomentum();
    }

    tmp<fvVectorMatrix> tEqn
    (
        fvm::ddt(U_) + divDevSigma() == fvOptions(U_)
    );

    tEqn.ref().relax();
    fvOptions.constrain(tEqn.ref());

    return tEqn;
}


void Foam::flowSolvers::immersedFluid::extrapolatePressure()
{
    // The first step of a run has one previous level only
    const scalar ratio =
        runTime_.timeIndex() < 2
      ? 0
      : runTime_.deltaTValue()/runTime_.deltaT0Value();

    if (bodies_->moving())
    {
        const volScalarField& p0 = p_.oldTime();

        p_.primitiveFieldRef() +=
            ratio*(p0.primitiveField() - p0.oldTime().primitiveField());
    }

    p_.correctBoundaryConditions();
    gradP_ = fvc::grad(p_);
}


void Foam::flowSolvers::immersedFluid::momentumPredictor()
{
    if (!immersed())
    {
        incompressibleFluid::momentumPredictor();
        return;
    }

    if (outer_ == 1)
    {
        extrapolatePressure();
    }

    tUEqn = assembleMomentum();
    A0_ = tUEqn().A();
    bodies_->updateResistance(A0_(), momentumTransport->nuEff()());

    fvVectorMatrix UEqn(tUEqn());

    UEqn.source() -= mesh_.V()*gradP_();
    bodies_->region().penalise(A0_(), gradP_(), UEqn);
    UEqn.solve(mesh_.solver(U_.select(true)));

    fvOptions.correct(U_);
}
