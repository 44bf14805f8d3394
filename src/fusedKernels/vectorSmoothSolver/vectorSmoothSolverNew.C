// SPDX-License-Identifier: GPL-3.0-or-later

#include "vectorSmoothSolver.H"
#include "addToRunTimeSelectionTable.H"
#include "fusedKernels.H"
#include "Switch.H"

namespace Foam
{
    defineTypeNameAndDebug(vectorSmoothSolver, 0);
    defineRunTimeSelectionTable(vectorSmoothSolver, equation);
    addToRunTimeSelectionTable
    (
        vectorSmoothSolver,
        vectorSmoothSolver,
        equation
    );
}


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
    const word type
    (
        controls.lookupOrDefault<Switch>("overRelaxation", false)
      ? "vectorOverRelaxation"
      : typeName
    );

    return equationConstructorTablePtr_->cfind(type)()(matrix, psi);
}


Foam::vectorSmoothSolver::vectorSmoothSolver
(
    const fvVectorMatrix& matrix,
    volVectorField& psi
)
:
    vectorSmoothSolver("smoothSolver", matrix, psi)
{}
