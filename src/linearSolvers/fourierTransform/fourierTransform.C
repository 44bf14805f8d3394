// SPDX-License-Identifier: GPL-3.0-or-later

#include "fourierTransform.H"
#include "mathematicalConstants.H"

namespace
{

using namespace Foam;
using basis = lineOperator::basis;

//- FFTW's names: REDFT even, RODFT odd at the low end; 10 is type II, 01 its
//- inverse, 11 type IV
fftw_r2r_kind forwardKind(const basis b)
{
    switch (b)
    {
        case basis::cc: return FFTW_REDFT10;
        case basis::ss: return FFTW_RODFT10;
        case basis::cs: return FFTW_REDFT11;
        case basis::sc: return FFTW_RODFT11;
        default: return FFTW_R2HC;
    }
}


fftw_r2r_kind backwardKind(const basis b)
{
    switch (b)
    {
        case basis::cc: return FFTW_REDFT01;
        case basis::ss: return FFTW_RODFT01;
        case basis::cs: return FFTW_REDFT11;
        case basis::sc: return FFTW_RODFT11;
        default: return FFTW_HC2R;
    }
}


scalar angle(const basis b, const label k, const label n)
{
    using constant::mathematical::pi;

    switch (b)
    {
        case basis::cc: return pi*k/n;
        case basis::ss: return pi*(k + 1)/n;
        case basis::periodic: return 2*pi*min(k, n - k)/n;
        default: return pi*(k + 0.5)/n;
    }
}

} // End anonymous namespace


fftw_plan Foam::fourierTransform::plan(const fftw_r2r_kind kind) const
{
    const fftw_iodim line = {int(n_), int(inner_), int(inner_)};
    const int step = n_*inner_;
    const fftw_iodim lines[2] =
    {
        {int(outer_), step, step}, {int(inner_), 1, 1}
    };

    // Only for its alignment: estimating a plan touches no data
    scalar* v = fftw_alloc_real(size_t(step)*outer_);
    fftw_plan p =
        fftw_plan_guru_r2r(1, &line, 2, lines, v, v, &kind, FFTW_ESTIMATE);
    fftw_free(v);

    return p;
}


Foam::fourierTransform::fourierTransform
(
    const lineOperator& line,
    const label inner,
    const label outer
)
:
    lineTransform(line.size(), inner, outer),
    basis_(line.trigonometric()),
    forward_(plan(forwardKind(basis_))),
    backward_(plan(backwardKind(basis_)))
{
    eigenvalues_.setSize(n_);

    forAll(eigenvalues_, k)
    {
        eigenvalues_[k] = 4*line.scale()*sqr(sin(0.5*angle(basis_, k, n_)));
    }
}


Foam::fourierTransform::~fourierTransform()
{
    fftw_destroy_plan(forward_);
    fftw_destroy_plan(backward_);
}


Foam::scalar Foam::fourierTransform::norm() const
{
    return basis_ == basis::periodic ? n_ : 2*n_;
}


void Foam::fourierTransform::forward(scalar*& v, scalar*&) const
{
    fftw_execute_r2r(forward_, v, v);
}


void Foam::fourierTransform::backward(scalar*& v, scalar*&) const
{
    fftw_execute_r2r(backward_, v, v);
}


std::string Foam::fourierTransform::description() const
{
    switch (basis_)
    {
        case basis::cc: return "cosine transform";
        case basis::ss: return "sine transform";
        case basis::periodic: return "Fourier transform";
        default: return "quarter-wave transform";
    }
}
