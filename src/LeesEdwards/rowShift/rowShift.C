// SPDX-License-Identifier: GPL-3.0-or-later

#include "rowShift.H"
#include "mathematicalConstants.H"
#include <algorithm>

Foam::rowShift::rowShift(const label nCells, const label nRows)
:
    nCells_(nCells),
    nRows_(nRows),
    forward_(nullptr),
    backward_(nullptr),
    rows_(fftw_alloc_real(max(size_t(nCells)*nRows, size_t(1)))),
    lastShift_(0)
{
    const auto plan = [&](const fftw_r2r_kind kind)
    {
        const int n = nCells_;

        return fftw_plan_many_r2r
        (
            1, &n, nRows_, rows_, nullptr, 1, n, rows_, nullptr, 1, n, &kind,
            FFTW_ESTIMATE
        );
    };

    if (nRows_ > 0)
    {
        forward_ = plan(FFTW_R2HC);
        backward_ = plan(FFTW_HC2R);
    }
}


Foam::rowShift::~rowShift()
{
    if (nRows_ > 0)
    {
        fftw_destroy_plan(forward_);
        fftw_destroy_plan(backward_);
    }
    fftw_free(rows_);
}


Foam::scalar Foam::rowShift::rounded(const scalar shift)
{
    const scalar whole = std::round(shift);

    return mag(shift - whole) < 1e-9 ? whole : shift;
}


Foam::complex Foam::rowShift::phase
(
    const label k,
    const label n,
    const scalar shift
)
{
    using constant::mathematical::twoPi;

    if (2*k == n)
    {
        const bool odd = std::fmod(mag(std::round(shift)), scalar(2)) > 0.5;

        return complex(odd ? -1 : 1, 0);
    }

    const scalar angle = twoPi*std::fmod(k*rounded(shift), scalar(n))/n;

    return complex(std::cos(angle), std::sin(angle));
}


void Foam::rowShift::setPhases(const scalar shift) const
{
    if (phases_.size() && shift == lastShift_)
    {
        return;
    }

    lastShift_ = shift;
    phases_.setSize(nCells_/2 + 1);

    forAll(phases_, k)
    {
        phases_[k] = phase(k, nCells_, shift)/scalar(nCells_);
    }
}


void Foam::rowShift::multiply(const scalar shift) const
{
    setPhases(shift);

    forAll(phases_, k)
    {
        const complex& factor = phases_[k];
        double* re = rows_ + k;
        double* im = rows_ + nCells_ - k;
        const bool real = k == 0 || 2*k == nCells_;

        for (label row = 0; row < nRows_; ++row)
        {
            if (real)
            {
                *re *= factor.Re();
            }
            else
            {
                const double r = *re;

                *re = factor.Re()*r - factor.Im()*(*im);
                *im = factor.Im()*r + factor.Re()*(*im);
            }
            re += nCells_;
            im += nCells_;
        }
    }
}


void Foam::rowShift::move(const scalar shift, UList<scalar>& values) const
{
    const scalar s = rounded(shift);

    if (nRows_ == 0)
    {
        return;
    }
    if (s == std::round(s))
    {
        const label n = nCells_;
        const label first = label(std::fmod(s, scalar(n)) + n) % n;

        for (label row = 0; row < nRows_; ++row)
        {
            auto begin = values.begin() + row*n;

            std::rotate(begin, begin + first, begin + n);
        }
        return;
    }

    std::copy(values.begin(), values.end(), rows_);
    fftw_execute(forward_);
    multiply(s);
    fftw_execute(backward_);
    std::copy_n(rows_, values.size(), values.begin());
}
