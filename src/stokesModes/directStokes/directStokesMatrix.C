// SPDX-License-Identifier: GPL-3.0-or-later

#include "directStokes.H"

extern "C"
{

void dgetrf_
(
    const int* m, const int* n, double* A, const int* ldA, int* pivots,
    int* info
);

}


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


std::vector<double> Foam::directStokes::signature() const
{
    // Digits that a shift of all places leaves
    const scalar digits = 1e9;
    std::vector<double> values;
    const label first =
        rowCells_.empty() ? 0 : grid_.column(rowCells_[0]);

    forAll(rowCells_, row)
    {
        values.push_back(grid_.wrap(grid_.column(rowCells_[row]) - first));
        values.push_back(grid_.row(rowCells_[row]));
        values.push_back(rowKinds_[row]);
    }
    for (const scalar coeff : coeffs_)
    {
        values.push_back(round(coeff*digits)/digits);
    }

    return values;
}


void Foam::directStokes::setColumns
(
    const label celli,
    const label rows[3],
    std::vector<double>& answers
)
{
    const label nx = grid_.nx();
    const label i0 = grid_.column(celli), j0 = grid_.row(celli);

    forAll(columnCells_, c)
    {
        const label other = columnCells_[c];
        const label di = grid_.wrap(grid_.column(other) - i0);
        const bool before = di > nx/2;
        const double* from = inverse_.responses
        (
            j0,
            grid_.row(other),
            before ? nx - di : di
        );
        double* to = &answers[9*c];

        for (label l = 0; l < 9; ++l)
        {
            to[l] = from[l];
        }
        if (before)
        {
            // Of u to the others, and of the others to u
            for (const label l : {1, 2, 3, 6})
            {
                to[l] = -to[l];
            }
        }
    }

    const label nRows = rowCells_.size();

    for (label row = 0; row < nRows; ++row)
    {
        double sums[3] = {0, 0, 0};

        for (label i = starts_[row]; i < starts_[row + 1]; ++i)
        {
            const double* answer = &answers[3*columns_[i]];

            for (label k = 0; k < 3; ++k)
            {
                sums[k] += coeffs_[i]*answer[k];
            }
        }
        for (label k = 0; k < 3; ++k)
        {
            if (rows[k] >= 0)
            {
                matrix_[size_t(rows[k])*nRows + row] =
                    sums[k] + (rows[k] == row ? 1 : 0);
            }
        }
    }
}


void Foam::directStokes::makeMatrix()
{
    const int n = rowCells_.size();
    std::vector<double> answers(9*columnCells_.size());

    matrix_.resize(size_t(n)*n);
    pivots_.resize(n);

    // Rows of a cell follow each other
    for (label row = 0; row < n; )
    {
        const label celli = rowCells_[row];
        label rows[3] = {-1, -1, -1};

        for (; row < n && rowCells_[row] == celli; ++row)
        {
            rows[rowKinds_[row]] = row;
        }
        setColumns(celli, rows, answers);
    }

    int info = 0;
    dgetrf_(&n, &n, matrix_.data(), &n, pivots_.data(), &info);

    if (info != 0)
    {
        FatalErrorInFunction
            << "The equations of the Stokes flow around the bodies are"
            << " singular" << exit(FatalError);
    }
}
