// SPDX-License-Identifier: GPL-3.0-or-later

#include "topHat.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace averagingKernels
{
    defineTypeNameAndDebug(topHat, 0);
    addToRunTimeSelectionTable(averagingKernel, topHat, dictionary);
}
}


Foam::averagingKernels::topHat::topHat
(
    const scalar radius,
    const bool twoD
)
:
    R_(radius),
    g_(1/(twoD ? sqr(2*radius) : pow3(2*radius)))
{}


Foam::scalar Foam::averagingKernels::topHat::secondMoment() const
{
    return sqr(R_)/3;
}


Foam::scalar Foam::averagingKernels::topHat::factor(const scalar x) const
{
    return mag(x) < inner*R_ ? 1 : 0;
}


void Foam::averagingKernels::topHat::values
(
    const UList<vector>& r,
    UList<scalar>& g
) const
{
    const scalar limit = inner*R_;

    forAll(r, i)
    {
        g[i] = cmptMax(cmptMag(r[i])) < limit ? g_ : 0;
    }
}
