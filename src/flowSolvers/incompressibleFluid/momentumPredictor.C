// SPDX-License-Identifier: GPL-3.0-or-later

#include "incompressibleFluid.H"
#include "fvcGrad.H"
#include "fvmDdt.H"
#include "fvmDiv.H"
#include "profiling.H"


Foam::tmp<Foam::fvVectorMatrix>
Foam::flowSolvers::incompressibleFluid::divDevSigma()
{
    return momentumTransport->divDevReff(U_);
}


Foam::tmp<Foam::fvVectorMatrix>
Foam::flowSolvers::incompressibleFluid::assembleMomentum()
{
    MRF.correctBoundaryVelocity(U_);

    tmp<fvVectorMatrix> tEqn
    (
        fvm::ddt(U_) + fvm::div(phi_, U_)
      + MRF.DDt(U_)
      + divDevSigma()
     ==
        fvOptions(U_)
    );
    fvVectorMatrix& eqn = tEqn.ref();

    eqn.relax();

    fvOptions.constrain(eqn);

    return tEqn;
}


void Foam::flowSolvers::incompressibleFluid::momentumPredictor()
{
    addProfiling(momentum, "momentumPredictor");

    tUEqn = assembleMomentum();

    if (pimple_.momentumPredictor())
    {
        solve(tUEqn.ref() == -fvc::grad(p_));

        fvOptions.correct(U_);
    }
}
