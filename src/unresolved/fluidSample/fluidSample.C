// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidSample.H"

Foam::fluidSample::fluidSample()
:
    sum_(0),
    r_(Zero),
    U_(Zero),
    rr_(Zero),
    rU_(Zero),
    ddtU_(Zero),
    nu_(0),
    nuEff_(0),
    selfKernel_(0),
    fraction_(0),
    crowd_(0),
    k_(0),
    epsilon_(0)
{}


Foam::tensor Foam::fluidSample::gradient() const
{
    const vector r(r_/sum_);
    symmTensor spread(rr_/sum_ - sqr(r));

    // A direction with one layer of cells has no gradient
    spread += 1e-9*tr(spread)*symmTensor::I;

    return inv(spread) & (rU_/sum_ - r*(U_/sum_));
}


Foam::vector Foam::fluidSample::velocity(const tensor& grad) const
{
    return U_/sum_ - ((r_/sum_) & grad);
}


void Foam::fluidSample::pack(UList<scalar>& data, const label start) const
{
    label i = start;

    data[i++] = sum_;
    for (direction k = 0; k < 3; ++k)
    {
        data[i++] = r_[k];
        data[i++] = U_[k];
        data[i++] = ddtU_[k];
    }
    for (direction k = 0; k < 6; ++k)
    {
        data[i++] = rr_[k];
    }
    for (direction k = 0; k < 9; ++k)
    {
        data[i++] = rU_[k];
    }
    for
    (
        const scalar s
      : {nu_, nuEff_, selfKernel_, fraction_, crowd_, k_, epsilon_}
    )
    {
        data[i++] = s;
    }
}


void Foam::fluidSample::unpack(const UList<scalar>& data, const label start)
{
    label i = start;

    sum_ = data[i++];
    for (direction k = 0; k < 3; ++k)
    {
        r_[k] = data[i++];
        U_[k] = data[i++];
        ddtU_[k] = data[i++];
    }
    for (direction k = 0; k < 6; ++k)
    {
        rr_[k] = data[i++];
    }
    for (direction k = 0; k < 9; ++k)
    {
        rU_[k] = data[i++];
    }
    for
    (
        scalar* s
      : {&nu_, &nuEff_, &selfKernel_, &fraction_, &crowd_, &k_, &epsilon_}
    )
    {
        *s = data[i++];
    }
}
