// SPDX-License-Identifier: GPL-3.0-or-later

#include "vectorSmoothSolver.H"
#include "compat.H"
#include "profiling.H"

namespace
{
    //- Components of |v|
    inline void addMag(Foam::vector& sum, const Foam::vector& v)
    {
        sum += Foam::cmptMag(v);
    }
}


Foam::vectorSmoothSolver::vectorSmoothSolver
(
    const fvVectorMatrix& matrix,
    volVectorField& psi
)
:
    matrix_(matrix),
    psi_(psi),
    source_(matrix.source()),
    rDiag_(matrix.diag().size()),
    work_(matrix.diag().size()),
    residual_(matrix.diag().size()),
    performance_("smoothSolver", psi.name())
{
    const scalarField& diag = matrix.diag();

    forAll(rDiag_, celli)
    {
        rDiag_[celli] = vector::uniform(diag[celli]);
    }

    forAll(psi.boundaryField(), patchi)
    {
        const labelUList& cells = matrix.lduAddr().patchAddr(patchi);
        const vectorField& internal = matrix.internalCoeffs()[patchi];
        const vectorField& boundary = matrix.boundaryCoeffs()[patchi];
        const bool coupled = psi.boundaryField()[patchi].coupled();

        forAll(internal, i)
        {
            rDiag_[cells[i]] += internal[i];
            if (!coupled)
            {
                source_[cells[i]] += boundary[i];
            }
        }
    }

    for (vector& d : rDiag_)
    {
        d = cmptDivide(vector::one, d);
    }

    const Vector<label> valid(psi.mesh().validComponents<vector>());

    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        solved_[cmpt] = valid[cmpt] == -1 ? 0 : 1;
    }
}


bool Foam::vectorSmoothSolver::serves(const dictionary& controls)
{
    return controls.lookupOrDefault<word>("type", "segregated") == "segregated"
        && controls.lookupOrDefault<word>("solver", "none") == "smoothSolver"
        && !controls.isDict("smoother")
        && controls.lookupOrDefault<word>("smoother", "none")
        == "symGaussSeidel"
        && controls.lookupOrDefault<label>("nSweeps", 1) > 0;
}


void Foam::vectorSmoothSolver::updateCoupled()
{
    volVectorField::Boundary& patches = psi_.boundaryFieldRef();
    const label nRequests = Pstream::nRequests();

    for (fvPatchVectorField& patch : patches)
    {
        if (patch.coupled())
        {
            patch.initEvaluate(Pstream::commsTypes::nonBlocking);
        }
    }

    if (Pstream::parRun())
    {
        Pstream::waitRequests(nRequests);
    }

    for (fvPatchVectorField& patch : patches)
    {
        if (patch.coupled())
        {
            patch.evaluate(Pstream::commsTypes::nonBlocking);
        }
    }
}


void Foam::vectorSmoothSolver::addCoupled
(
    const scalar factor,
    const bool one,
    vectorField& b
) const
{
    forAll(psi_.boundaryField(), patchi)
    {
        if (!psi_.boundaryField()[patchi].coupled())
        {
            continue;
        }

        const labelUList& cells = matrix_.lduAddr().patchAddr(patchi);
        const vectorField& coeffs = matrix_.boundaryCoeffs()[patchi];
        const tmp<vectorField> tbeyond
        (
            one
          ? tmp<vectorField>(new vectorField(coeffs.size(), vector::one))
          : psi_.boundaryField()[patchi].patchNeighbourField()
        );

        forAll(coeffs, i)
        {
            b[cells[i]] += factor*cmptMultiply(coeffs[i], tbeyond()[i]);
        }
    }
}


void Foam::vectorSmoothSolver::multiply(vectorField& sumA)
{
    const labelUList& l = matrix_.lduAddr().lowerAddr();
    const labelUList& u = matrix_.lduAddr().upperAddr();
    const scalarField& lower = matrix_.lower();
    const scalarField& upper = matrix_.upper();
    const vectorField& psi = psi_.primitiveField();

    forAll(work_, celli)
    {
        const vector diag(cmptDivide(vector::one, rDiag_[celli]));

        work_[celli] = cmptMultiply(diag, psi[celli]);
        sumA[celli] = diag;
    }
    addCoupled(-1, false, work_);
    addCoupled(-1, true, sumA);

    forAll(l, facei)
    {
        const label o = l[facei];
        const label n = u[facei];

        work_[o] += upper[facei]*psi[n];
        work_[n] += lower[facei]*psi[o];
        sumA[o] += vector::uniform(upper[facei]);
        sumA[n] += vector::uniform(lower[facei]);
    }
}


Foam::vector Foam::vectorSmoothSolver::begin()
{
    const vector mean(gAverage(psi_.primitiveField()));
    vectorField& sumA = residual_;

    multiply(sumA);

    vector sum(Zero);

    forAll(sumA, celli)
    {
        const vector reference(cmptMultiply(sumA[celli], mean));

        addMag(sum, work_[celli] - reference);
        addMag(sum, source_[celli] - reference);
        residual_[celli] = source_[celli] - work_[celli];
    }

    return returnReduce(sum, sumOp<vector>())
      + vector::uniform(solverPerformance::small_);
}


void Foam::vectorSmoothSolver::sweep()
{
    const label nCells = work_.size();
    work_ = source_;
    addCoupled(1, false, work_);
    residual_ = Zero;
    addCoupled(-1, false, residual_);

    const label* const __restrict__ u =
        matrix_.lduAddr().upperAddr().begin();
    const label* const __restrict__ start =
        matrix_.lduAddr().ownerStartAddr().begin();
    const scalar* const __restrict__ lower = matrix_.lower().begin();
    const scalar* const __restrict__ upper = matrix_.upper().begin();
    const vector* const __restrict__ rDiag = rDiag_.begin();
    vector* const __restrict__ b = work_.begin();
    vector* const __restrict__ r = residual_.begin();
    vector* const psi = psi_.primitiveFieldRef().begin();

    // The row's own unknown, from those of its upper neighbours and what the
    // lower ones have taken off b
    const auto solution = [=](const label celli)
    {
        vector x(b[celli]);

        for (label facei = start[celli]; facei < start[celli + 1]; ++facei)
        {
            x -= upper[facei]*psi[u[facei]];
        }

        return cmptMultiply(x, rDiag[celli]);
    };

    for (label celli = 0; celli < nCells; ++celli)
    {
        const vector x(solution(celli));

        for (label facei = start[celli]; facei < start[celli + 1]; ++facei)
        {
            b[u[facei]] -= lower[facei]*x;
        }
        psi[celli] = x;
    }

    // What the lower neighbours have taken off b stands until they change
    for (label celli = nCells - 1; celli >= 0; --celli)
    {
        const vector x(solution(celli));
        const vector change(psi[celli] - x);

        for (label facei = start[celli]; facei < start[celli + 1]; ++facei)
        {
            r[u[facei]] += lower[facei]*change;
        }
        psi[celli] = x;
    }

    updateCoupled();
    addCoupled(1, false, residual_);
}


Foam::vector Foam::vectorSmoothSolver::sumMag() const
{
    vector sum(Zero);

    for (const vector& r : residual_)
    {
        addMag(sum, r);
    }

    return cmptMultiply(returnReduce(sum, sumOp<vector>()), solved_);
}


bool Foam::vectorSmoothSolver::converged
(
    const scalar tolerance,
    const scalar relTol
) const
{
    bool all = true;

    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        const scalar residual = performance_.finalResidual()[cmpt];

        all = all
         && (
                residual < tolerance
             || residual < relTol*performance_.initialResidual()[cmpt]
            );
    }

    return all;
}


void Foam::vectorSmoothSolver::report() const
{
    const fvMesh& mesh = psi_.mesh();

    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (solved_[cmpt] > 0 && SolverPerformance<vector>::debug)
        {
            solverPerformance
            (
                performance_.solverName(),
                performance_.fieldName() + vector::componentNames[cmpt],
                performance_.initialResidual()[cmpt],
                performance_.finalResidual()[cmpt],
                performance_.nIterations()[cmpt]
            ).print(Info.masterStream(mesh.comm()));
        }
    }

    compat::setSolverPerformance(mesh, psi_.name(), performance_);
}


Foam::SolverPerformance<Foam::vector> Foam::vectorSmoothSolver::solve
(
    const dictionary& controls
)
{
    addProfiling(solve, "vectorSmoothSolver." + psi_.name());

    const scalar tolerance = controls.lookupOrDefault("tolerance", 1e-6);
    const scalar relTol = controls.lookupOrDefault<scalar>("relTol", 0);
    const label nSweeps = controls.lookupOrDefault<label>("nSweeps", 1);
    const label minIter = controls.lookupOrDefault<label>("minIter", 0);
    const label maxIter = controls.lookupOrDefault<label>("maxIter", 1000);

    updateCoupled();

    const vector norm(begin());
    label n = 0;

    while (true)
    {
        performance_.finalResidual() = cmptDivide(sumMag(), norm);

        if (n == 0)
        {
            performance_.initialResidual() = performance_.finalResidual();
        }

        if (n >= minIter && (n >= maxIter || converged(tolerance, relTol)))
        {
            break;
        }

        for (label i = 0; i < nSweeps; ++i)
        {
            sweep();
        }
        n += nSweeps;
    }

    performance_.nIterations() = Vector<label>::uniform(n);
    psi_.correctBoundaryConditions();
    report();

    return performance_;
}
