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


void Foam::flowSolvers::immersedFluid::momentumPredictor()
{
    if (!immersed())
    {
        incompressibleFluid::momentumPredictor();
        return;
    }

    tUEqn = assembleMomentum();
    A0_ = tUEqn().A();
    bodies_->updateResistance(A0_(), momentumTransport->nuEff()());

    if (outer_ == 1)
    {
        p_.correctBoundaryConditions();
        gradP_ = fvc::grad(p_);
    }

    fvVectorMatrix UEqn(tUEqn());

    UEqn.source() -= mesh_.V()*gradP_();
    bodies_->region().penalise(A0_(), gradP_(), UEqn);
    UEqn.solve(mesh_.solver(U_.select(true)));

    fvOptions.correct(U_);
}
