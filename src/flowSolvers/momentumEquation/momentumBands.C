// SPDX-License-Identifier: GPL-3.0-or-later

#include "momentumEquation.H"
#include "profiling.H"

void Foam::momentumEquation::keepFlux()
{
    if (!convecting_.valid())
    {
        return;
    }

    // Without copies
    phi_.primitiveFieldRef().swap(convecting_->primitiveFieldRef());

    forAll(phi_.boundaryField(), patchi)
    {
        phi_.boundaryFieldRef()[patchi].swap
        (
            convecting_->boundaryFieldRef()[patchi]
        );
    }
}


bool Foam::momentumEquation::solveInBands
(
    const ddtCoefficients& ddt,
    const vectorField& gradP,
    const scalar speed
)
{
    addProfiling(bands, "momentumEquation::solveInBands");

    if (!stokes_)
    {
        bands_.correctConvection
        (
            phi_, convecting_(), U_, eqn_.ref().source()
        );
    }

    bodies_.resolved().updateResistance(ddt, A_(), viscosity(), true);

    const dictionary& solver = U_.mesh().solver(U_.select(true));
    const label nSweeps = bands_.relax
    (
        eqn_.ref(),
        drive(gradP)(),
        residualTarget::tolerance(solver)*speed,
        residualTarget::relTol(solver),
        U_
    );

    inBands_ = nSweeps > 0;

    if (inBands_)
    {
        Info<< "Gauss-Seidel:  Solving for U in the bands of bodies, "
            << "No Iterations " << nSweeps << endl;

        options_.correct(U_);
    }

    return inBands_;
}
