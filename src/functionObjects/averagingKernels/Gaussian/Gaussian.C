// SPDX-License-Identifier: GPL-3.0-or-later

#include "Gaussian.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace averagingKernels
{
    defineTypeNameAndDebug(Gaussian, 0);
    addToRunTimeSelectionTable(averagingKernel, Gaussian, dictionary);
}
}


Foam::averagingKernels::Gaussian::Gaussian
(
    const scalar radius,
    const bool twoD
)
:
    s_(radius),
    norm_
    (
        Foam::pow
        (
            Foam::sqrt(constant::mathematical::twoPi)*radius
           *Foam::erf(Foam::sqrt(8.0)),
            twoD ? 2 : 3
        )
    )
{}


Foam::scalar Foam::averagingKernels::Gaussian::secondMoment() const
{
    // By parts
    return sqr(s_)
       *(
            1
          - 8*Foam::exp(-8.0)
           /(
                Foam::sqrt(constant::mathematical::twoPi)
               *Foam::erf(Foam::sqrt(8.0))
            )
        );
}


Foam::scalar Foam::averagingKernels::Gaussian::factor(const scalar x) const
{
    return mag(x) < inner*reach() ? Foam::exp(-0.5*sqr(x/s_)) : 0;
}


void Foam::averagingKernels::Gaussian::values
(
    const UList<vector>& r,
    UList<scalar>& g
) const
{
    const scalar limit = inner*reach();
    const scalar scale = -0.5/sqr(s_);

    forAll(r, i)
    {
        g[i] = cmptMax(cmptMag(r[i])) < limit
          ? Foam::exp(scale*magSqr(r[i]))/norm_
          : 0;
    }
}
