// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxSolver.H"
#include "sumInParts.H"

void Foam::boxSolver::apply
(
    const scalarField& b,
    const scalar factor,
    scalarField& x
) const
{
    map_().toSlab(b, v_);

    forAll(transforms_, i)
    {
        transforms_[i].forward(v_, other_);
    }

    systems_().solve(v_);

    forAllReverse(transforms_, i)
    {
        transforms_[i].backward(v_, other_);
    }

    map_().fromSlab(v_, factor/norm_, x);
}


void Foam::boxSolver::setLevel
(
    const lduMatrix& matrix,
    const scalar factor,
    const scalar excess,
    scalarField& x
) const
{
    scalar level = 0;

    if (floating())
    {
        level = -sumProd(volumeShare_, x);
    }
    else if (laplacian_.referenceCell() >= 0)
    {
        level =
            excess/laplacian_.referenceCoefficient(matrix, factor)
          - x[laplacian_.referenceCell()];
    }

    reduce(level, sumOp<scalar>());
    x += level;
}


void Foam::boxSolver::solve
(
    const lduMatrix& matrix,
    scalarField& b,
    scalarField& x
) const
{
    const scalar factor = laplacian_.factor(matrix);

    if (!laplacian_.singular())
    {
        apply(b, -1/factor, x);
        return;
    }

    // The sum of the equations: without the reference 0, else its equation
    const scalar excess = returnReduce
    (
        sumInParts(b.size(), [&](const label i) { return b[i]; }),
        sumOp<scalar>()
    );

    if (floating())
    {
        forAll(b, celli)
        {
            b[celli] -= excess*volumeShare_[celli];
        }
    }
    else if (laplacian_.referenceCell() >= 0)
    {
        b[laplacian_.referenceCell()] -= excess;
    }

    apply(b, -1/factor, x);
    setLevel(matrix, factor, excess, x);
}


void Foam::boxSolver::precondition
(
    const lduMatrix& matrix,
    scalarField& b,
    scalarField& x
) const
{
    if (laplacian_.singular())
    {
        b -= gSum(b)*volumeShare_;
    }

    apply(b, -1/laplacian_.factor(matrix), x);

    if (laplacian_.singular())
    {
        x -= gSumProd(volumeShare_, x);
    }
}
