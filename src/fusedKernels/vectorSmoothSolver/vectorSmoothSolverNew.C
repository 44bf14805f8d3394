// SPDX-License-Identifier: GPL-3.0-or-later

#include "vectorOverRelaxation.H"
#include "fusedKernels.H"
#include "Switch.H"

bool Foam::vectorSmoothSolver::serves(const dictionary& controls)
{
    return fusedKernels::active
        && controls.lookupOrDefault<word>("type", "segregated") == "segregated"
        && controls.lookupOrDefault<word>("solver", "none") == "smoothSolver"
        && !controls.isDict("smoother")
        && controls.lookupOrDefault<word>("smoother", "none")
        == "symGaussSeidel"
        && controls.lookupOrDefault<label>("nSweeps", 1) > 0;
}


Foam::autoPtr<Foam::vectorSmoothSolver> Foam::vectorSmoothSolver::New
(
    const fvVectorMatrix& matrix,
    volVectorField& psi,
    const dictionary& controls
)
{
    if (controls.lookupOrDefault<Switch>("overRelaxation", false))
    {
        return autoPtr<vectorSmoothSolver>
        (
            new vectorOverRelaxation(matrix, psi)
        );
    }

    return autoPtr<vectorSmoothSolver>(new vectorSmoothSolver(matrix, psi));
}


Foam::vectorSmoothSolver::vectorSmoothSolver
(
    const fvVectorMatrix& matrix,
    volVectorField& psi
)
:
    vectorSmoothSolver("smoothSolver", matrix, psi)
{}
