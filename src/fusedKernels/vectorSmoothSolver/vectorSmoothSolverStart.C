// SPDX-License-Identifier: GPL-3.0-or-later

#include "vectorSmoothSolver.H"
#include "faceSums.H"
#include "rowProducts.H"


Foam::List<Foam::vectorField> Foam::vectorSmoothSolver::productsWithTrend()
{
    vectorField& psi = psi_.primitiveFieldRef();
    const labelList beside(besidePatches(psi_.mesh()).toc());
    const vectorField given(psi, beside);

    for (const label celli : beside)
    {
        psi[celli] += trend_()[celli];
    }
    updateCoupled();

    List<vectorField> products(coupledProducts());

    UIndirectList<vector>(psi, beside) = given;

    return products;
}


void Foam::vectorSmoothSolver::addCoupledRows(scalarField& sumA) const
{
    forAll(psi_.boundaryField(), patchi)
    {
        if (psi_.boundaryField()[patchi].coupled())
        {
            const labelUList& cells = matrix_.lduAddr().patchAddr(patchi);
            const vectorField& coeffs = matrix_.boundaryCoeffs()[patchi];

            // The same for all components where patches are coupled
            forAll(coeffs, i)
            {
                sumA[cells[i]] -= coeffs[i].x();
            }
        }
    }
}


template<bool follows, class Diagonal>
Foam::vector Foam::vectorSmoothSolver::begin
(
    const Field<Diagonal>& diag,
    const vectorField& trend,
    vector& sumGiven
)
{
    const labelUList& u = matrix_.lduAddr().upperAddr();
    const labelUList& start = matrix_.lduAddr().ownerStartAddr();
    const scalarField& lower = matrix_.lower();
    const scalarField& upper = matrix_.upper();
    vectorField& psi = psi_.primitiveFieldRef();
    const vector mean(gAverage(psi));
    scalarField sumA(psi.size(), Zero);
    vector sum(Zero);

    // Of psi as given and, if different, with the trend
    vectorField& given = follows ? residual_ : work_;

    addCoupledRows(sumA);
    sumGiven = sumMag_ = Zero;

    // Faces are in the order of their owners: when its turn comes a row has got
    // all that its lower neighbours add to it, and none of them needs its psi
    // any more
    forAll(sumA, celli)
    {
        const vector x(psi[celli]);
        const vector y(follows ? x + trend[celli] : x);
        vector Ax(given[celli] + scaled(x, diag[celli]));
        vector Ay(work_[celli] + scaled(y, diag[celli]));
        scalar rowSum = sumA[celli];

        for (label facei = start[celli]; facei < start[celli + 1]; ++facei)
        {
            const label n = u[facei];

            Ax += upper[facei]*psi[n];
            given[n] += lower[facei]*x;
            rowSum += upper[facei];
            sumA[n] += lower[facei];

            if (follows)
            {
                Ay += upper[facei]*(psi[n] + trend[n]);
                work_[n] += lower[facei]*y;
            }
        }

        const vector reference(rowSum*mean + scaled(mean, diag[celli]));

        addMag(sum, weight(celli)*(Ax - reference));
        addMag(sum, weight(celli)*(source_[celli] - reference));
        addMag(sumGiven, weight(celli)*(source_[celli] - Ax));

        if (follows)
        {
            addMag(sumMag_, weight(celli)*(source_[celli] - Ay));
            psi[celli] = y;
        }
    }

    return returnReduce(sum, sumOp<vector>())
      + vector::uniform(solverPerformance::small_);
}


template<class Diagonal>
Foam::vector Foam::vectorSmoothSolver::begin(const Field<Diagonal>& diag)
{
    vector sumGiven;

    work_ = Zero;
    addCoupled(-1, coupledProducts(), work_);

    if (!trend_.valid())
    {
        const vector norm(begin<false>(diag, vectorField::null(), sumGiven));

        sumMag_ = sumGiven;
        performance_.initialResidual() = scaledResidual(sumGiven, norm);
        performance_.finalResidual() = performance_.initialResidual();

        return norm;
    }

    residual_ = work_;
    work_ = Zero;
    addCoupled(-1, productsWithTrend(), work_);

    const vector norm(begin<true>(diag, trend_(), sumGiven));

    performance_.initialResidual() = scaledResidual(sumGiven, norm);
    performance_.finalResidual() = scaledResidual(sumMag_, norm);

    // Also if one of them is not a number
    if
    (
       !(
            cmptSum(performance_.finalResidual())
          < cmptSum(performance_.initialResidual())
        )
    )
    {
        performance_.finalResidual() = performance_.initialResidual();
        sumMag_ = sumGiven;
        psi_.primitiveFieldRef() -= trend_();
        updateCoupled();
        work_ = residual_;
    }

    return norm;
}


Foam::vector Foam::vectorSmoothSolver::begin()
{
    return diags_.empty() ? begin(diag_) : begin(diags_);
}
