// SPDX-License-Identifier: GPL-3.0-or-later

#include "residualTarget.H"

namespace
{
    //- Part of a right side that is left at most: bodies are moved by the
    //  solution
    const Foam::scalar loosest = 0.02;
}


bool Foam::residualTarget::applies(const dictionary& solver)
{
    return solver.found("tolerance")
        && solver.found("relTol")
        && solver.lookupOrDefault<word>("type", "segregated") == "segregated";
}


void Foam::residualTarget::set
(
    const dictionary& solver,
    const scalar residual
)
{
    target_ = applies(solver) ? solver.get<scalar>("relTol")*residual : 0;
}


Foam::scalar Foam::residualTarget::tolerance(const dictionary& solver)
{
    return applies(solver) ? solver.get<scalar>("tolerance") : 1e-9;
}


Foam::scalar Foam::residualTarget::relTol(const dictionary& solver)
{
    return applies(solver) ? solver.get<scalar>("relTol") : 1e-3;
}


Foam::dictionary Foam::residualTarget::controls
(
    const dictionary& solver
) const
{
    dictionary controls(solver);

    if (applies(solver))
    {
        controls.set
        (
            "tolerance",
            max(target_, solver.get<scalar>("tolerance"))
        );
    }

    return controls;
}


Foam::dictionary Foam::residualTarget::controls
(
    const dictionary& solver,
    const scalar ratio
)
{
    dictionary controls(solver);

    if (applies(solver))
    {
        const scalar tolerance = solver.get<scalar>("tolerance");
        const scalar first = max(tolerance, solver.get<scalar>("relTol"));

        controls.set
        (
            "tolerance",
            max(tolerance, min(first*ratio, loosest))
        );
    }

    return controls;
}
