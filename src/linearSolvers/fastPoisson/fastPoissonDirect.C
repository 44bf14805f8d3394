// SPDX-License-Identifier: GPL-3.0-or-later

#include "fastPoisson.H"
#include "compatMesh.H"
#include "neighbourSum.H"
#include "PstreamReduceOps.H"
#include "rowSample.H"
#include "sumInParts.H"
#include <algorithm>

namespace
{
    bool anyNonZero(const Foam::scalarField& psi)
    {
        const bool any = std::any_of
        (
            psi.begin(), psi.end(), [](const Foam::scalar x){ return x != 0; }
        );

        return Foam::returnReduce(any, Foam::orOp<bool>());
    }
}


Foam::fastPoisson::solution::solution
(
    scalarField& psi,
    const scalarField& source,
    const direction cmpt,
    const label sample,
    const solverPerformance& performance
)
:
    psi(psi),
    source(source),
    cmpt(cmpt),
    start(anyNonZero(psi) ? new scalarField(psi) : nullptr),
    residual(psi.size()),
    norm(1),
    sample(sample),
    performance(performance)
{}


Foam::scalar Foam::fastPoisson::setResidual(solution& x) const
{
    matrix_.residual
    (
        x.residual,
        x.psi,
        x.source,
        interfaceBouCoeffs_,
        interfaces_,
        x.cmpt
    );

    return gSumMag(x.residual)/x.norm;
}


Foam::scalar Foam::fastPoisson::estimateResidual(solution& x) const
{
    const rowSample sample(x.psi.size(), x.sample);
    const neighbourSum neighbours(matrix_);
    const scalarField& diag = matrix_.diag();
    scalar sum = 0;

    for (const label celli : sample.rows())
    {
        x.residual[celli] = x.source[celli];
    }

    compat::subtractCoupled
    (
        matrix_, interfaceBouCoeffs_, interfaces_, x.psi, x.residual, x.cmpt
    );

    forAll(sample.rows(), i)
    {
        const label celli = sample.rows()[i];

        sum += sample.standsFor(i)*mag
        (
            x.residual[celli]
          - diag[celli]*x.psi[celli]
          - neighbours(celli, x.psi)
        );
    }

    return returnReduce(sum, sumOp<scalar>())/x.norm;
}


bool Foam::fastPoisson::check(const bool estimate, solution& x) const
{
    if (estimate)
    {
        x.performance.finalResidual() = estimateResidual(x);

        if (x.performance.checkConvergence(tolerance_, relTol_))
        {
            return true;
        }
    }

    x.performance.finalResidual() = setResidual(x);

    return x.performance.checkConvergence(tolerance_, relTol_);
}


void Foam::fastPoisson::begin(solution& x) const
{
    if (x.start.valid())
    {
        scalarField work(x.psi.size());

        matrix_.Amul
        (
            x.residual, x.psi, interfaceBouCoeffs_, interfaces_, x.cmpt
        );
        x.norm = normFactor(x.psi, x.source, x.residual, work);
        x.residual = x.source - x.residual;
        x.performance.initialResidual() = gSumMag(x.residual)/x.norm;
    }
    else
    {
        // The same without the products with zero
        x.residual = x.source;

        const scalar sum =
            returnReduce(magnitudeSum(x.source), sumOp<scalar>());

        x.norm = sum + solverPerformance::small_;
        x.performance.initialResidual() = sum/x.norm;
    }

    x.performance.finalResidual() = x.performance.initialResidual();
}


void Foam::fastPoisson::beginAgain(solution& x) const
{
    if (x.start.valid())
    {
        x.psi = x.start();
        x.performance.finalResidual() = setResidual(x);
    }
    else
    {
        x.psi = Zero;
        x.residual = x.source;
        x.performance.finalResidual() = x.performance.initialResidual();
    }
}


Foam::scalar Foam::fastPoisson::attainable
(
    const boxSolver& direct,
    const solution& x
) const
{
    const scalar rounding = 1e-14*gSum(mag(matrix_.diag()*x.psi)());
    const scalar inconsistency = direct.floating() ? mag(gSum(x.source)) : 0;

    return 1.01*(rounding + inconsistency)/x.norm;
}


bool Foam::fastPoisson::refine
(
    const boxSolver& direct,
    const bool known,
    solution& x
) const
{
    const label maxSolutions = 4;
    scalarField correction;

    for (label i = 0; i < maxSolutions; ++i)
    {
        const scalar before = x.performance.finalResidual();

        if (i == 0 && !x.start.valid())
        {
            direct.solve(matrix_, x.residual, x.psi);
        }
        else
        {
            correction.resize(x.psi.size());
            direct.solve(matrix_, x.residual, correction);
            x.psi += correction;
        }

        ++x.performance.nIterations();

        if (check(known, x))
        {
            return true;
        }

        if (!(x.performance.finalResidual() < 0.01*before))
        {
            return x.performance.finalResidual() < attainable(direct, x);
        }
    }

    return true;
}


bool Foam::fastPoisson::solveDirectly(const polyMesh& mesh, solution& x) const
{
    const boxSolverCache& cache = boxSolverCache::New(mesh);
    const boxSolver* direct = cache.find(fieldName_);

    if (direct)
    {
        if (refine(*direct, true, x))
        {
            return true;
        }

        // Made for other conditions?
        beginAgain(x);
    }

    direct = cache.make(*this);

    if (!direct || refine(*direct, false, x))
    {
        return direct;
    }

    cache.refuse(fieldName_, "no convergence");
    beginAgain(x);

    return false;
}
