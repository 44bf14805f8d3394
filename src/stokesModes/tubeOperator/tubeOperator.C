// SPDX-License-Identifier: GPL-3.0-or-later

#include "tubeOperator.H"
#include "mathematicalConstants.H"

extern "C"
{

void dgbtrf_
(
    const int* m, const int* n, const int* nLower, const int* nUpper,
    double* A, const int* ldA, int* pivots, int* info
);

void dgbtrs_
(
    const char* trans, const int* n, const int* nLower, const int* nUpper,
    const int* nRhs, const double* A, const int* ldA, const int* pivots,
    double* B, const int* ldB, int* info
);

}

namespace
{
    //- Diagonals on each side, and rows of LAPACK's form of a band
    const int nBeside = 3*Foam::tubeStencils::reach + 2;
    const int nBand = 3*nBeside + 1;
}


Foam::tubeOperator::tubeOperator
(
    const tubeGrid& grid,
    const tubeStencils& stencils
)
:
    grid_(grid),
    nx_(grid.nx()),
    n_(3*grid.ny()),
    nWaves_(nx_/2 + 1),
    factors_(size_t(nWaves_)*n_*nBand, 0.0),
    pivots_(size_t(nWaves_)*n_),
    lines_(size_t(3)*n_*nx_),
    waves_(size_t(3)*n_*nWaves_)
{
    fftw_complex* waves = reinterpret_cast<fftw_complex*>(waves_.data());

    forward_ = fftw_plan_many_dft_r2c
    (
        1, &nx_, n_, lines_.data(), nullptr, 1, nx_, waves, nullptr, 1,
        nWaves_, FFTW_ESTIMATE
    );
    backward_ = fftw_plan_many_dft_c2r
    (
        1, &nx_, n_, waves, nullptr, 1, nWaves_, lines_.data(), nullptr, 1,
        nx_, FFTW_ESTIMATE
    );
    backwardTable_ = fftw_plan_many_dft_c2r
    (
        1, &nx_, 3*n_, waves, nullptr, 1, nWaves_, lines_.data(), nullptr, 1,
        nx_, FFTW_ESTIMATE
    );

    for (int wave = 0; wave < nWaves_; ++wave)
    {
        factorise(stencils, wave);
    }
    tabulate();
}


Foam::tubeOperator::~tubeOperator()
{
    fftw_destroy_plan(forward_);
    fftw_destroy_plan(backward_);
    fftw_destroy_plan(backwardTable_);
}


void Foam::tubeOperator::factorise
(
    const tubeStencils& stencils,
    const int wave
)
{
    const int reach = tubeStencils::reach;
    const scalar theta = constant::mathematical::twoPi*wave/nx_;
    double* A = &factors_[size_t(wave)*n_*nBand];

    for (label col = 0; col < n_; ++col)
    {
        const label j = col/3, k = col % 3;

        for (label dj = -reach; dj <= reach; ++dj)
        {
            for (label l = 0; l < 3; ++l)
            {
                const label row = 3*(j + dj) + l;
                scalar sum = 0;

                for (label di = -reach; di <= reach; ++di)
                {
                    // u is i times a real number, in its row as well
                    const scalar part =
                        (k == 0) == (l == 0) ? cos(theta*di)
                      : l == 0 ? -sin(theta*di) : sin(theta*di);

                    sum += part*stencils(tubeStencils::rows + l, k, j, di, dj);
                }
                if (row >= 0 && row < n_)
                {
                    A[2*nBeside + row - col + size_t(col)*nBand] = sum;
                }
            }
        }
    }

    // The level of the pressure
    if (wave == 0)
    {
        A[2*nBeside + size_t(2)*nBand] +=
            mag(stencils(tubeStencils::rows + 2, 2, 0, 0, 0));
    }

    int info = 0;
    dgbtrf_
    (
        &n_, &n_, &nBeside, &nBeside, A, &nBand, &pivots_[size_t(wave)*n_],
        &info
    );

    if (info != 0)
    {
        FatalErrorInFunction
            << "The Stokes equations without bodies are singular: has the mesh"
            << " walls?" << exit(FatalError);
    }
}


void Foam::tubeOperator::solveWave
(
    const int wave,
    double* x,
    const int nRhs
) const
{
    int info = 0;

    dgbtrs_
    (
        "N", &n_, &nBeside, &nBeside, &nRhs,
        &factors_[size_t(wave)*n_*nBand], &nBand,
        &pivots_[size_t(wave)*n_], x, &n_, &info
    );
}


void Foam::tubeOperator::solve(scalarField& x) const
{
    const label nCells = nx_*grid_.ny();
    std::vector<double> parts(2*n_);

    for (label celli = 0; celli < nCells; ++celli)
    {
        const size_t line = 3*grid_.row(celli);

        for (label k = 0; k < 3; ++k)
        {
            lines_[(line + k)*nx_ + grid_.column(celli)] = x[k*nCells + celli];
        }
    }

    fftw_execute(forward_);

    for (int wave = 0; wave < nWaves_; ++wave)
    {
        for (label row = 0; row < n_; ++row)
        {
            const complexNumber b = waves_[size_t(row)*nWaves_ + wave]
               *(row % 3 == 0 ? complexNumber(0, -1) : complexNumber(1, 0));

            parts[row] = b.real();
            parts[n_ + row] = b.imag();
        }

        solveWave(wave, parts.data(), 2);

        for (label row = 0; row < n_; ++row)
        {
            waves_[size_t(row)*nWaves_ + wave] =
                complexNumber(parts[row], parts[n_ + row])
               *(row % 3 == 0 ? complexNumber(0, 1) : complexNumber(1, 0));
        }
    }

    fftw_execute(backward_);

    for (label celli = 0; celli < nCells; ++celli)
    {
        const size_t line = 3*grid_.row(celli);

        for (label k = 0; k < 3; ++k)
        {
            x[k*nCells + celli] =
                lines_[(line + k)*nx_ + grid_.column(celli)]/nx_;
        }
    }
}
