// SPDX-License-Identifier: GPL-3.0-or-later

#include "vectorSmoothSolver.H"
#include "faceSums.H"
#include "neighbourSum.H"
#include "rowProducts.H"

Foam::List<Foam::vectorField> Foam::vectorSmoothSolver::productsWithTrend()
{
    vectorField& psi = psi_.primitiveFieldRef();
    const labelList beside(besidePatches(psi_.mesh()).toc());
    const vectorField given(psi, beside);

    for (const label celli : beside)
    {
        psi[celli] += change(celli);
    }
    updateCoupled();

    List<vectorField> products(coupledProducts());

    UIndirectList<vector>(psi, beside) = given;

    return products;
}


void Foam::vectorSmoothSolver::setCoupled
(
    const List<vectorField>& products,
    vectorField& sums
) const
{
    UIndirectList<vector>(sums, sample_->rows()) = Zero;

    forAll(products, patchi)
    {
        if (products[patchi].size())
        {
            UIndirectList<vector>(sums, matrix_.lduAddr().patchAddr(patchi))
                = Zero;
        }
    }

    addCoupled(-1, products, sums);
}


template<class Diagonal>
Foam::vectorField Foam::vectorSmoothSolver::productsWithMean
(
    const Field<Diagonal>& diag
) const
{
    const rowSample& sample = sample_();
    const neighbourSum neighbours(matrix_);
    List<vectorField> coeffs(psi_.boundaryField().size());
    vectorField products(psi_.size());
    vector sum(Zero);
    scalar n = 0;

    forAll(coeffs, patchi)
    {
        if (psi_.boundaryField()[patchi].coupled())
        {
            coeffs[patchi] = matrix_.boundaryCoeffs()[patchi];
        }
    }
    setCoupled(coeffs, products);

    forAll(sample.rows(), i)
    {
        sum += sample.standsFor(i)*psi_[sample.rows()[i]];
        n += sample.standsFor(i);
    }
    reduce(sum, sumOp<vector>());
    reduce(n, sumOp<scalar>());

    const vector mean(sum/max(n, scalar(1)));

    for (const label celli : sample.rows())
    {
        products[celli] =
            cmptMultiply(products[celli], mean)
          + neighbours.coefficients(celli)*mean
          + scaled(mean, diag[celli]);
    }

    return products;
}


template<class Diagonal>
Foam::vector Foam::vectorSmoothSolver::sumStart
(
    const Field<Diagonal>& diag,
    vector& sumGiven
)
{
    const rowSample& sample = sample_();
    const vectorField ofMean(productsWithMean(diag));
    const neighbourSum neighbours(matrix_);
    vector sum(Zero);

    sumGiven = sumMag_ = Zero;
    setCoupled(coupledProducts(), residual_);

    if (follows())
    {
        setCoupled(productsWithTrend(), work_);
    }

    forAll(sample.rows(), i)
    {
        const label celli = sample.rows()[i];
        const scalar w = sample.standsFor(i)*weight(celli);
        const vector& b = source_[celli];
        const vector others
        (
            neighbours(celli, psi_) + scaled(psi_[celli], diag[celli])
        );
        const vector rest(b - others - residual_[celli]);

        addMag(sum, w*(b - rest - ofMean[celli]));
        addMag(sum, w*(b - ofMean[celli]));
        addMag(sumGiven, w*rest);

        if (follows())
        {
            const vector before(neighbours(celli, *trend_.from));
            const vector after(neighbours(celli, *trend_.to));
            const vector more
            (
                cmptMultiply(solved_, trend_.part*(after - before))
              + scaled(change(celli), diag[celli])
            );

            addMag(sumMag_, w*(b - others - more - work_[celli]));
        }
    }

    return returnReduce(sum, sumOp<vector>())
      + vector::uniform(solverPerformance::small_);
}


Foam::vector Foam::vectorSmoothSolver::begin()
{
    sample_.reset
    (
        new rowSample(psi_.size(), psi_.time().timeIndex(), asked_)
    );

    vector sumGiven;
    const vector norm
    (
        diags_.empty() ? sumStart(diag_, sumGiven) : sumStart(diags_, sumGiven)
    );

    performance_.initialResidual() = scaledResidual(sumGiven, norm);
    performance_.finalResidual() = performance_.initialResidual();

    if (!follows())
    {
        sumMag_ = sumGiven;
        return norm;
    }

    const vector followed(scaledResidual(sumMag_, norm));

    // Not if one of them is not a number
    if (cmptSum(followed) < cmptSum(performance_.initialResidual()))
    {
        performance_.finalResidual() = followed;
        vectorField& psi = psi_.primitiveFieldRef();

        forAll(psi, celli)
        {
            psi[celli] += change(celli);
        }
    }
    else
    {
        sumMag_ = sumGiven;
        updateCoupled();
    }

    return norm;
}
