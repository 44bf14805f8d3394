// SPDX-License-Identifier: GPL-3.0-or-later

#include "fastPoisson.H"
#include "PstreamReduceOps.H"

namespace Foam
{
    defineTypeNameAndDebug(fastPoisson, 0);

    lduMatrix::solver::addsymMatrixConstructorToTable<fastPoisson>
        addfastPoissonSymMatrixConstructorToTable_;
}


namespace
{
    bool anyNonZero(const Foam::scalarField& psi)
    {
        for (const Foam::scalar x : psi)
        {
            if (x != 0)
            {
                return true;
            }
        }

        return false;
    }
}


Foam::scalar Foam::fastPoisson::setResidual
(
    const scalarField& psi,
    const scalarField& source,
    const direction cmpt,
    scalarField& residual
) const
{
    matrix_.residual
    (
        residual,
        psi,
        source,
        interfaceBouCoeffs_,
        interfaces_,
        cmpt
    );

    return gSumMag(residual);
}


Foam::scalar Foam::fastPoisson::attainable
(
    const boxSolver& direct,
    const scalarField& psi,
    const scalarField& source,
    const scalar normFactor
) const
{
    const scalar rounding = 1e-14*gSum(mag(matrix_.diag()*psi)());
    const scalar inconsistency = direct.floating() ? mag(gSum(source)) : 0;

    return 1.01*(rounding + inconsistency)/normFactor;
}


bool Foam::fastPoisson::refine
(
    const boxSolver& direct,
    scalarField& psi,
    const scalarField& source,
    scalarField& residual,
    const scalar normFactor,
    const direction cmpt,
    solverPerformance& performance
) const
{
    const label maxSolutions = 4;
    scalarField correction(psi.size());

    for (label i = 0; i < maxSolutions; ++i)
    {
        const scalar before = performance.finalResidual();

        direct.solve(matrix_, residual, correction);
        psi += correction;
        performance.finalResidual() =
            setResidual(psi, source, cmpt, residual)/normFactor;
        ++performance.nIterations();

        if (performance.checkConvergence(tolerance_, relTol_))
        {
            return true;
        }

        if (!(performance.finalResidual() < 0.01*before))
        {
            return performance.finalResidual()
              < attainable(direct, psi, source, normFactor);
        }
    }

    return true;
}


bool Foam::fastPoisson::solveDirectly
(
    const polyMesh& mesh,
    scalarField& psi,
    const scalarField& source,
    scalarField& residual,
    const scalar normFactor,
    const direction cmpt,
    solverPerformance& performance
) const
{
    const boxSolverCache& cache = boxSolverCache::New(mesh);
    const boxSolver* direct = cache.find(fieldName_);
    const scalarField start(psi);

    auto solved = [&]()
    {
        return refine
        (
            *direct, psi, source, residual, normFactor, cmpt, performance
        );
    };

    if (direct)
    {
        if (solved())
        {
            return true;
        }

        // Made for other conditions?
        psi = start;
        performance.finalResidual() =
            setResidual(psi, source, cmpt, residual)/normFactor;
    }

    direct = cache.make(*this);

    if (!direct || solved())
    {
        return direct;
    }

    cache.refuse(fieldName_, "no convergence");
    psi = start;

    return false;
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


Foam::scalar Foam::fastPoisson::begin
(
    const scalarField& psi,
    const scalarField& source,
    const direction cmpt,
    scalarField& residual,
    solverPerformance& performance
) const
{
    if (returnReduce(anyNonZero(psi), orOp<bool>()))
    {
        scalarField work(psi.size());

        matrix_.Amul(residual, psi, interfaceBouCoeffs_, interfaces_, cmpt);

        const scalar norm = normFactor(psi, source, residual, work);
        residual = source - residual;
        performance.initialResidual() = gSumMag(residual)/norm;

        return norm;
    }

    // The same without the products with zero
    scalar sum = 0;

    forAll(residual, celli)
    {
        residual[celli] = source[celli];
        sum += mag(source[celli]);
    }
    reduce(sum, sumOp<scalar>());

    const scalar norm = sum + solverPerformance::small_;
    performance.initialResidual() = sum/norm;

    return norm;
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

    solverPerformance performance(typeName, fieldName_);
    scalarField residual(psi.size());
    const scalar normFactor = begin(psi, source, cmpt, residual, performance);

    performance.finalResidual() = performance.initialResidual();

    if (minIter_ <= 0 && performance.checkConvergence(tolerance_, relTol_))
    {
        // fastPoissonPreconditioner of other fields may need it next
        boxSolverCache::New(*mesh).prepare(*this);
        return performance;
    }

    if
    (
        solveDirectly
        (
            *mesh, psi, source, residual, normFactor, cmpt, performance
        )
    )
    {
        return performance;
    }

    return solveOtherwise(psi, source, cmpt);
}
