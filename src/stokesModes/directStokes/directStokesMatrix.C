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
