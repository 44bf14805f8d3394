// SPDX-License-Identifier: GPL-3.0-or-later

#include "bandRows.H"
#include "cellSearch.H"

void Foam::bandRows::addBoundary
(
    const label row,
    const label patchi,
    const label i,
    vector& diag
)
{
    diag += matrix_.internalCoeffs()[patchi][i];

    if (matrix_.psi().boundaryField()[patchi].coupled())
    {
        coupled_.append(coupledFace{row, patchi, i});
    }
    else
    {
        source_[row] += matrix_.boundaryCoeffs()[patchi][i];
    }
}


Foam::bandRows::bandRows
(
    const fvVectorMatrix& E0,
    const cellNeighbours& neighbours,
    const labelUList& cells,
    const scalarField& K,
    const vectorField& f
)
:
    matrix_(E0),
    cells_(cells),
    start_(cells.size() + 1),
    source_(E0.source(), cells),
    rDiag_(cells.size())
{
    const scalarField& V = E0.psi().mesh().V();
    const scalarField& lower = E0.lower();
    const scalarField& upper = E0.upper();

    columns_.reserve(6*cells.size());
    coeffs_.reserve(6*cells.size());

    forAll(cells, row)
    {
        const label celli = cells[row];
        vector diag(vector::uniform(E0.diag()[celli] + V[celli]*K[celli]));

        start_[row] = columns_.size();
        source_[row] += V[celli]*f[row];

        for (const auto& n : neighbours.of(celli))
        {
            columns_.append(n.cell());
            coeffs_.append((n.owner() ? upper : lower)[n.face()]);
        }

        for (const auto& face : neighbours.onPatches(celli))
        {
            addBoundary(row, face.patch, face.face, diag);
        }

        rDiag_[row] = cmptDivide(vector::one, diag);
    }
    start_.last() = columns_.size();
    b_ = source_;
}


Foam::scalar Foam::bandRows::sweep(volVectorField& U, const bool back)
{
    const label n = cells_.size();
    vectorField& Ui = U.primitiveFieldRef();

    for (const coupledFace& face : coupled_)
    {
        b_[face.row] = source_[face.row];
    }

    List<vectorField> beyond(U.boundaryField().size());

    // On sliding patches they take all processors
    forAll(beyond, patchi)
    {
        const fvPatchVectorField& patch = U.boundaryField()[patchi];

        if (patch.coupled() && !cellSearch::matched(patch.patch().patch()))
        {
            beyond[patchi] = patch.patchNeighbourField();
        }
    }

    for (const coupledFace& face : coupled_)
    {
        vectorField& values = beyond[face.patchi];

        if (values.empty())
        {
            values = U.boundaryField()[face.patchi].patchNeighbourField();
        }
        b_[face.row] += cmptMultiply
        (
            matrix_.boundaryCoeffs()[face.patchi][face.facei],
            values[face.facei]
        );
    }

    scalar change = 0;

    for (label j = 0; j < n; ++j)
    {
        const label row = back ? n - 1 - j : j;
        vector x(b_[row]);

        for (label k = start_[row]; k < start_[row + 1]; ++k)
        {
            x -= coeffs_[k]*Ui[columns_[k]];
        }
        x = cmptMultiply(x, rDiag_[row]);

        change = max(change, magSqr(x - Ui[cells_[row]]));
        Ui[cells_[row]] = x;
    }

    return Foam::sqrt(change);
}
