// SPDX-License-Identifier: GPL-3.0-or-later

#include "directStokes.H"

void Foam::directStokes::add
(
    const label celli,
    const label k,
    const scalar coeff
)
{
    label& column = columnOf_[celli];

    if (column < 0)
    {
        column = columnCells_.size();
        columnCells_.append(celli);
    }

    // Once per row
    for (label i = starts_.last(); i < columns_.size(); ++i)
    {
        if (columns_[i] == 3*column + k)
        {
            coeffs_[i] += coeff;
            return;
        }
    }
    columns_.append(3*column + k);
    coeffs_.append(coeff);
}


void Foam::directStokes::addStencil
(
    const label result,
    const label i,
    const label j,
    const scalar factor
)
{
    const label reach = tubeStencils::reach;

    for (label dj = -reach; dj <= reach; ++dj)
    {
        if (j + dj < 0 || j + dj >= grid_.ny())
        {
            continue;
        }
        for (label di = -reach; di <= reach; ++di)
        {
            for (label k = 0; k < 3; ++k)
            {
                const scalar coeff = stencils_(result, k, j + dj, -di, -dj);

                if (coeff != 0)
                {
                    add(grid_.cell(i + di, j + dj), k, factor*coeff);
                }
            }
        }
    }
}


void Foam::directStokes::addMomentum(const label celli)
{
    const scalar A0 = equations_.A0()[celli];
    const scalar K = equations_.bodies()->K()[celli];
    const scalar shield = equations_.bodies()->shield()[celli];

    for (label k = 0; k < 2 && (K > 0 || shield > 0); ++k)
    {
        rowCells_.append(celli);
        rowKinds_.append(k);
        starts_.append(columns_.size());
        add(celli, k, K/A0);
        addStencil
        (
            tubeStencils::gradP + k,
            grid_.column(celli),
            grid_.row(celli),
            -shield/A0
        );
    }
}


void Foam::directStokes::addFlux
(
    const label result,
    const label i,
    const label j,
    const scalar factor
)
{
    const bool east = result == tubeStencils::east;
    const label facei = east ? grid_.east(i, j) : grid_.north(i, j);
    const scalar s =
        facei < 0 ? 0 : equations_.bodies()->faceShield()[facei];

    if (s > 0)
    {
        const scalar leak = stokesFlow::onFace(equations_.leak(), facei);

        addStencil(result, i, j, -factor*s);
        add(grid_.cell(i, j), 2, factor*s*leak);
        add
        (
            east ? grid_.cell(i + 1, j) : grid_.cell(i, j + 1),
            2,
            -factor*s*leak
        );
    }
}


void Foam::directStokes::addContinuity(const label celli)
{
    const label i = grid_.column(celli), j = grid_.row(celli);
    const scalar scale = 1/equations_.area()[celli];

    starts_.append(columns_.size());
    addFlux(tubeStencils::east, i, j, scale);
    addFlux(tubeStencils::east, i - 1, j, -scale);
    addFlux(tubeStencils::north, i, j, scale);
    addFlux(tubeStencils::north, i, j - 1, -scale);

    // Nothing there
    if (columns_.size() == starts_.last())
    {
        starts_.remove();
        return;
    }
    rowCells_.append(celli);
    rowKinds_.append(2);
}


void Foam::directStokes::findRows()
{
    const immersedRegion& region = equations_.bodies()->region();
    DynamicList<label> cells;

    for (const label celli : columnCells_)
    {
        columnOf_[celli] = -1;
    }
    columnCells_.clear();
    rowCells_.clear();
    rowKinds_.clear();
    starts_.clear();
    columns_.clear();
    coeffs_.clear();

    // Faces of the bands may belong to cells outside of them
    labelHashSet found;

    for (const label celli : region.cells())
    {
        const label i = grid_.column(celli), j = grid_.row(celli);

        for (label dj = -1; dj <= 1; ++dj)
        {
            for (label di = -1; di <= 1; ++di)
            {
                if
                (
                    j + dj >= 0 && j + dj < grid_.ny()
                 && found.insert(grid_.cell(i + di, j + dj))
                )
                {
                    cells.append(grid_.cell(i + di, j + dj));
                }
            }
        }
    }

    for (const label celli : cells)
    {
        addMomentum(celli);
        addContinuity(celli);
    }
    starts_.append(columns_.size());
}


Foam::scalarField Foam::directStokes::multiply(const scalarField& x) const
{
    const label n = equations_.mesh().nCells();
    scalarField y(rowCells_.size(), Zero);

    forAll(y, row)
    {
        for (label i = starts_[row]; i < starts_[row + 1]; ++i)
        {
            const label celli = columnCells_[columns_[i]/3];

            y[row] += coeffs_[i]*x[(columns_[i] % 3)*n + celli];
        }
    }

    return y;
}
