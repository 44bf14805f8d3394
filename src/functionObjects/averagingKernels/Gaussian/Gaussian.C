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
    twoD_(twoD),
    s_(radius),
    norm_
    (
        twoD
      ? constant::mathematical::twoPi*sqr(radius)*(1 - Foam::exp(-8.0))
      : pow3(Foam::sqrt(constant::mathematical::twoPi)*radius)
       *(
            Foam::erf(Foam::sqrt(8.0))
          - 8/Foam::sqrt(constant::mathematical::twoPi)*Foam::exp(-8.0)
        )
    )
{}


Foam::scalar Foam::averagingKernels::Gaussian::secondMoment() const
{
    // By parts, of r^2 over n; x = r/s
    const scalar e = Foam::exp(-8.0);

    if (twoD_)
    {
        return sqr(s_)*(1 - 9*e)/(1 - e);
    }

    const scalar a = Foam::sqrt(2/constant::mathematical::pi)*4*e;
    const scalar inside = Foam::erf(Foam::sqrt(8.0)) - a;

    return sqr(s_)*(inside - 16*a/3)/inside;
}


void Foam::averagingKernels::Gaussian::values
(
    const UList<vector>& r,
    UList<scalar>& g
) const
{
    const scalar limit = sqr(inner*reach());
    const scalar scale = -0.5/sqr(s_);

    forAll(r, i)
    {
        const scalar r2 = magSqr(r[i]);

        g[i] = r2 < limit ? Foam::exp(scale*r2)/norm_ : 0;
    }
}
