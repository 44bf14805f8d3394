// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxLaplacian.H"
#include "compat.H"
#include "LeesEdwardsPolyPatch.H"
#include "PstreamReduceOps.H"
#include "SubField.H"
#include <numeric>


Foam::scalar Foam::boxLaplacian::sample(const lduMatrix& matrix)
{
    const scalarField& upper = matrix.upper();
    const label n = min(upper.size(), 1000);

    return returnReduce
    (
        std::accumulate(upper.begin(), upper.begin() + n, scalar(0)),
        sumOp<scalar>()
    );
}


bool Foam::boxLaplacian::makeLine
(
    const tensorGrid& grid,
    const label direction,
    const coefficients& found
)
{
    const label n = grid.n(direction);
    const scalar layer = grid.nCells()/n;
    scalarField values(n + 2, Zero);

    forAll(values, i)
    {
        // Each link is seen from both cells, except at the ends
        const scalar full = (i < n ? 2 : 1)*layer;

        if (found.n[i] == 0)
        {
            // Nothing links the last cell to the first, or a side is empty
            if (i < n - 1)
            {
                return false;
            }
            continue;
        }

        if (found.n[i] != full )
        {
            return false;
        }

        values[i] = 0.5*(found.low[i] + found.high[i]);

        if (found.high[i] - found.low[i] > 1e-4*mag(values[i]) || values[i] < 0)
        {
            return false;
        }
    }

    lines_[direction] = lineOperator
    (
        grid.widths(direction),
        SubField<scalar>(values, n),
        values[n],
        values[n + 1],
        found.n[n - 1] > 0
    );

    return true;
}


void Foam::boxLaplacian::checkDiagonal
(
    const lduMatrix& matrix,
    const tensorGrid& grid
)
{
    const scalarField& diag = matrix.diag();
    label nDifferent = 0;

    forAll(diag, celli)
    {
        const labelVector& index = grid.index()[celli];
        scalar expected = 0;

        for (label d = 0; d < 3; ++d)
        {
            expected += lines_[d].sumLinks(index[d])*grid.area(index, d);
        }

        expected *= -sign(sum_);

        if (mag(diag[celli] - expected) > 1e-3*mag(expected))
        {
            ++nDifferent;

            // Fixed only if it adds to the diagonal
            if (diag[celli]/expected > 1)
            {
                referenceCell_ = celli;
                referenceDiag_ = expected;
            }
        }
    }

    const label nReferences = referenceCell_ < 0 ? 0 : 1;
    reduce(nDifferent, sumOp<label>());
    const label n = returnReduce(nReferences, sumOp<label>());
    referenced_ = n > 0;

    if (nDifferent > (singular() ? n : 0) || n > 1)
    {
        reason_ = "its diagonal is not that of a Laplacian";
    }
}


Foam::boxLaplacian::boxLaplacian
(
    const lduMatrix::solver& solver,
    const polyMesh& mesh,
    const tensorGrid& grid
)
:
    sliding_(LeesEdwardsPolyPatch::findPair(mesh)),
    sum_(sample(solver.matrix())),
    referenceCell_(-1),
    referenceDiag_(0),
    referenced_(false)
{
    FixedList<coefficients, 3> found;

    for (label d = 0; d < 3; ++d)
    {
        const label n = grid.n(d) + 2;
        found[d].low.setSize(n, GREAT);
        found[d].high.setSize(n, -GREAT);
        found[d].n.setSize(n, 0);
    }

    // Some meshes have links that are no faces
    bool valid =
        sum_ != 0
     && solver.matrix().upper().size() == mesh.nInternalFaces()
     && readInternal(solver.matrix(), grid, found)
     && readPatches(solver, mesh, grid, found);

    reduce(valid, andOp<bool>());

    for (label d = 0; d < 3; ++d)
    {
        compat::allReduce(found[d].low, minEqOp<scalar>());
        compat::allReduce(found[d].high, maxEqOp<scalar>());
        compat::allReduce(found[d].n, plusEqOp<scalar>());

        valid = valid && makeLine(grid, d, found[d]);
    }

    if (!valid)
    {
        reason_ =
            "the coefficient is not constant, or a side has conditions of"
            " several kinds";
        return;
    }

    checkDiagonal(solver.matrix(), grid);
}


bool Foam::boxLaplacian::singular() const
{
    return
        lines_[0].singular() && lines_[1].singular() && lines_[2].singular();
}


Foam::scalar Foam::boxLaplacian::referenceCoefficient
(
    const lduMatrix& matrix,
    const scalar s
) const
{
    return
        referenceCell_ < 0
      ? 0 : matrix.diag()[referenceCell_] - s*referenceDiag_;
}


Foam::scalar Foam::boxLaplacian::factor(const lduMatrix& matrix) const
{
    return sample(matrix)/sum_;
}
