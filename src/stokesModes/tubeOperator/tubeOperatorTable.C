// SPDX-License-Identifier: GPL-3.0-or-later

#include "tubeOperator.H"

void Foam::tubeOperator::tabulate()
{
    const label ny = grid_.ny();
    std::vector<double> x(3*n_);

    table_.resize(size_t(ny)*ny*nWaves_*9);

    for (label j0 = 0; j0 < ny; ++j0)
    {
        for (int wave = 0; wave < nWaves_; ++wave)
        {
            std::fill(x.begin(), x.end(), 0.0);

            // A unit in row 0 is -i times i
            for (label k = 0; k < 3; ++k)
            {
                x[k*n_ + 3*j0 + k] = k == 0 ? -1 : 1;
            }
            solveWave(wave, x.data(), 3);

            for (label k = 0; k < 3; ++k)
            {
                for (label row = 0; row < n_; ++row)
                {
                    // Solutions of k = 0 are real parts times i, u of the
                    // others is i times them
                    const double value = x[k*n_ + row];
                    const bool u = row % 3 == 0;

                    waves_[size_t(k*n_ + row)*nWaves_ + wave] =
                        k == 0 ? (u ? complexNumber(-value, 0)
                                    : complexNumber(0, value))
                      : (u ? complexNumber(0, value)
                           : complexNumber(value, 0));
                }
            }
        }

        fftw_execute(backwardTable_);

        for (label k = 0; k < 3; ++k)
        {
            for (label row = 0; row < n_; ++row)
            {
                const size_t block = (size_t(j0)*ny + row/3)*nWaves_;
                double* to = &table_[9*block + 3*(row % 3) + k];
                const double* line = &lines_[size_t(k*n_ + row)*nx_];

                for (label di = 0; di < nWaves_; ++di)
                {
                    to[9*di] = line[di]/nx_;
                }
            }
        }
    }
}
