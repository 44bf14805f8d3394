// SPDX-License-Identifier: GPL-3.0-or-later

#include "andersonAcceleration.H"
#include "SVD.H"
#include "compat.H"

namespace
{
    //- Differences that depend on others to within this do not count
    const Foam::scalar minCondition = 1e-7;

    //- Where a combination has left a residual so many times larger than the
    //  smallest before, iterations are combined anew
    const Foam::scalar worse = 2;
}


Foam::andersonAcceleration::andersonAcceleration(const label depth)
:
    depth_(depth),
    dResult_(depth),
    dResidual_(depth),
    n_(0),
    next_(0),
    any_(false),
    smallest_(GREAT)
{}


void Foam::andersonAcceleration::clear()
{
    n_ = next_ = 0;
    any_ = false;
    smallest_ = GREAT;
}


Foam::scalarField Foam::andersonAcceleration::coefficients
(
    const scalarField& residual
) const
{
    // Products of all differences, and with the residual in the last column
    scalarField products(n_*(n_ + 1));

    for (label i = 0; i < n_; ++i)
    {
        for (label j = 0; j <= n_; ++j)
        {
            products[i*(n_ + 1) + j] =
                sumProd(dResidual_[i], j < n_ ? dResidual_[j] : residual);
        }
    }
    compat::allReduce(products, plusEqOp<scalar>());

    const auto product = [&](const label i, const label j)
    {
        return products[i*(n_ + 1) + j];
    };
    scalarField size(n_);
    scalarRectangularMatrix A(n_, n_, Zero);

    forAll(size, i)
    {
        size[i] = max(Foam::sqrt(product(i, i)), VSMALL);
    }
    forAll(size, i)
    {
        forAll(size, j)
        {
            A(i, j) = product(i, j)/(size[i]*size[j]);
        }
    }

    const scalarRectangularMatrix inverse(SVDinv(A, minCondition));
    scalarField c(n_, Zero);

    forAll(c, i)
    {
        forAll(c, j)
        {
            c[i] += inverse(i, j)*product(j, n_)/size[j];
        }
        c[i] /= size[i];
    }

    return c;
}


void Foam::andersonAcceleration::apply
(
    const scalarField& residual,
    scalarField& result
)
{
    const scalar size = Foam::sqrt(gSumSqr(residual));

    if (any_ && returnReduce(result.size() != result_.size(), orOp<bool>()))
    {
        clear();
    }
    if (n_ && size > worse*smallest_)
    {
        clear();
    }
    smallest_ = min(smallest_, size);

    if (any_)
    {
        dResult_.set(next_, new scalarField(result - result_));
        dResidual_.set(next_, new scalarField(residual - residual_));
        next_ = (next_ + 1) % depth_;
        n_ = min(n_ + 1, depth_);
    }

    any_ = true;
    result_ = result;
    residual_ = residual;

    if (n_)
    {
        const scalarField c(coefficients(residual));

        forAll(c, j)
        {
            result -= c[j]*dResult_[j];
        }
    }
}
