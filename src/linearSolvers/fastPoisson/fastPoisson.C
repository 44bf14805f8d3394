// SPDX-License-Identifier: GPL-3.0-or-later

#include "fastPoisson.H"

namespace Foam
{
    defineTypeNameAndDebug(fastPoisson, 0);

    lduMatrix::solver::addsymMatrixConstructorToTable<fastPoisson>
        addfastPoissonSymMatrixConstructorToTable_;
}


Foam::solverPerformance Foam::fastPoisson::solveOtherwise
(
    scalarField& psi,
    const scalarField& source,
    const direction cmpt
) const
{
    dictionary controls(controlDict_.subOrEmptyDict("fallback"));

    for (const char* key : {"tolerance", "relTol", "minIter", "maxIter"})
    {
        if (controlDict_.found(key) && !controls.found(key))
        {
            controls.add(*controlDict_.findEntry(key));
        }
    }

    if (!controls.found("solver"))
    {
        controls.add("solver", word("GAMG"));
        controls.add("smoother", word("GaussSeidel"));
    }

    if (controls.get<word>("solver") == typeName)
    {
        FatalIOErrorInFunction(controlDict_)
            << "'fallback' of " << fieldName_ << " must be another solver than "
            << typeName << exit(FatalIOError);
    }

    return lduMatrix::solver::New
    (
        fieldName_,
        matrix_,
        interfaceBouCoeffs_,
        interfaceIntCoeffs_,
        interfaces_,
        controls
    )->solve(psi, source, cmpt);
}


Foam::fastPoisson::fastPoisson
(
    const word& fieldName,
    const lduMatrix& matrix,
    const FieldField<Field, scalar>& interfaceBouCoeffs,
    const FieldField<Field, scalar>& interfaceIntCoeffs,
    const lduInterfaceFieldPtrsList& interfaces,
    const dictionary& solverControls
)
:
    lduMatrix::solver
    (
        fieldName,
        matrix,
        interfaceBouCoeffs,
        interfaceIntCoeffs,
        interfaces,
        solverControls
    )
{
    for (const entry& e : controlDict_)
    {
        if (e.isDict() && e.keyword() != "fallback")
        {
            FatalIOErrorInFunction(controlDict_)
                << "Unknown keyword '" << e.keyword() << "' in '"
                << controlDict_.dictName() << "'; the only dictionary there is"
                << " 'fallback', another solver" << nl << exit(FatalIOError);
        }
    }
}


Foam::solverPerformance Foam::fastPoisson::solve
(
    scalarField& psi,
    const scalarField& source,
    const direction cmpt
) const
{
    // Agglomerated meshes are none
    const polyMesh* mesh = dynamic_cast<const polyMesh*>(&matrix_.mesh());

    if (!mesh)
    {
        return solveOtherwise(psi, source, cmpt);
    }

    solution x
    (
        psi, source, cmpt, mesh->time().timeIndex(),
        solverPerformance(typeName, fieldName_)
    );

    begin(x);

    if (minIter_ <= 0 && x.performance.checkConvergence(tolerance_, relTol_))
    {
        // fastPoissonPreconditioner of other fields may need it next
        boxSolverCache::New(*mesh).prepare(*this);
        return x.performance;
    }

    return
        solveDirectly(*mesh, x)
      ? x.performance
      : solveOtherwise(psi, source, cmpt);
}
