// SPDX-License-Identifier: GPL-3.0-or-later

#include "fastPoissonPreconditioner.H"
#include "boxSolverCache.H"

namespace Foam
{
    defineTypeNameAndDebug(fastPoissonPreconditioner, 0);

    lduMatrix::preconditioner::
        addsymMatrixConstructorToTable<fastPoissonPreconditioner>
        addfastPoissonPreconditionerSymMatrixConstructorToTable_;
}


namespace
{
    //- The solver of a field, null if there is none
    const Foam::boxSolver* solverOf
    (
        const Foam::lduMesh& lduMesh,
        const Foam::word& fieldName
    )
    {
        const Foam::polyMesh* mesh =
            dynamic_cast<const Foam::polyMesh*>(&lduMesh);

        return
            mesh
          ? Foam::boxSolverCache::New(*mesh).find(fieldName)
          : nullptr;
    }
}


bool Foam::fastPoissonPreconditioner::serves
(
    const lduMesh& mesh,
    const word& fieldName
)
{
    return solverOf(mesh, fieldName);
}


const Foam::boxSolver& Foam::fastPoissonPreconditioner::find
(
    const lduMatrix& matrix,
    const dictionary& dict
)
{
    const word fieldName(dict.get<word>("field"));
    const boxSolver* direct = solverOf(matrix.mesh(), fieldName);

    if (!direct)
    {
        FatalIOErrorInFunction(dict)
            << "'field " << fieldName << "' of the preconditioner " << typeName
            << " has not been solved for by the solver " << typeName
            << nl << exit(FatalIOError);
    }

    return *direct;
}


Foam::fastPoissonPreconditioner::fastPoissonPreconditioner
(
    const lduMatrix::solver& solver,
    const dictionary& dict
)
:
    lduMatrix::preconditioner(solver),
    direct_(find(solver.matrix(), dict))
{}


void Foam::fastPoissonPreconditioner::precondition
(
    scalarField& w,
    const scalarField& r,
    const direction
) const
{
    b_ = r;
    direct_.precondition(solver_.matrix(), b_, w);
}
