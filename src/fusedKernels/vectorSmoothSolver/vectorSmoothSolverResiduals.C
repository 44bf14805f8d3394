// SPDX-License-Identifier: GPL-3.0-or-later

#include "vectorSmoothSolver.H"
#include "compatMesh.H"

namespace
{
    //- Rows with weights are all looked at if they are less than this part of
    //  them; the sample stands for more as well
    const Foam::scalar mostAsked = 0.25;
}


void Foam::vectorSmoothSolver::weigh
(
    const labelUList& cells,
    const UList<scalar>& weights
)
{
    weights_.resize(residual_.size(), 1);
    UIndirectList<scalar>(weights_, cells) = weights;

    if (cells.size() < mostAsked*residual_.size())
    {
        asked_.resize(residual_.size());
        asked_.set(cells);
    }
}


Foam::vector Foam::vectorSmoothSolver::scaledResidual
(
    const vector& sumMag,
    const vector& norm
) const
{
    const vector sum(returnReduce(sumMag, sumOp<vector>()));

    return cmptDivide(cmptMultiply(sum, solved_), norm);
}


Foam::scalar Foam::vectorSmoothSolver::excess
(
    const scalar tolerance,
    const scalar relTol
) const
{
    scalar largest = 0;

    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        const scalar enough = max
        (
            max(tolerance, relTol*performance_.initialResidual()[cmpt]),
            ROOTVSMALL
        );

        const scalar part = performance_.finalResidual()[cmpt]/enough;

        // Also if it is not a number
        if (!(part < GREAT))
        {
            return GREAT;
        }
        largest = max(largest, part);
    }

    return largest;
}


Foam::scalar Foam::vectorSmoothSolver::look
(
    const scalar tolerance,
    const scalar relTol,
    const vector& norm
)
{
    performance_.finalResidual() = scaledResidual(sumMag_, norm);

    return excess(tolerance, relTol);
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
