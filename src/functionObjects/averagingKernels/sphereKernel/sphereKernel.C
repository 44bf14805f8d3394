// SPDX-License-Identifier: GPL-3.0-or-later

#include "sphereKernel.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace averagingKernels
{
    defineTypeNameAndDebug(sphereKernel, 0);
    addToRunTimeSelectionTable(averagingKernel, sphereKernel, dictionary);
}
}


Foam::averagingKernels::sphereKernel::sphereKernel
(
    const scalar radius,
    const bool twoD
)
:
    twoD_(twoD),
    R_(radius),
    g_
    (
        twoD
      ? 1/(constant::mathematical::pi*sqr(radius))
      : 0.75/(constant::mathematical::pi*pow3(radius))
    )
{}


Foam::scalar Foam::averagingKernels::sphereKernel::secondMoment() const
{
    return sqr(R_)/(twoD_ ? 4 : 5);
}


void Foam::averagingKernels::sphereKernel::values
(
    const UList<vector>& r,
    UList<scalar>& g
) const
{
    const scalar limit = sqr(inner*R_);

    forAll(r, i)
    {
        g[i] = magSqr(r[i]) < limit ? g_ : 0;
    }
}
