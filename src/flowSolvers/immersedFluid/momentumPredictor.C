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
    if
    (
        bodies_->moving()
     && !bodies_->window().comoving()
     && uniformViscosity_
     && runTime_.timeIndex() > 1
    )
    {
        // How far viscosity reaches within the step, in cells, squared: the
        // extrapolation is stable where that is not little
        const scalar nu = gMax(momentumTransport->nu()().primitiveField());
        const scalar reach =
            nu*runTime_.deltaTValue()/sqr(bodies_->minCellSize());
        const scalar part = max(1 - 1/max(reach, SMALL), 0)
           *runTime_.deltaTValue()/runTime_.deltaT0Value();
        const volScalarField& p0 = p_.oldTime();

        if (part > 0)
        {
            p_.primitiveFieldRef() +=
                part*(p0.primitiveField() - p0.oldTime().primitiveField());
        }
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
