// SPDX-License-Identifier: GPL-3.0-or-later

#include "vectorOverRelaxation.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
    defineTypeNameAndDebug(vectorOverRelaxation, 0);
    addToRunTimeSelectionTable
    (
        vectorSmoothSolver,
        vectorOverRelaxation,
        equation
    );
}

namespace
{
    inline Foam::vector scaled(const Foam::vector& v, const Foam::scalar d)
    {
        return d*v;
    }

    inline Foam::vector scaled(const Foam::vector& v, const Foam::vector& d)
    {
        return Foam::cmptMultiply(v, d);
    }

    inline Foam::vector divided(const Foam::vector& v, const Foam::scalar d)
    {
        return v/d;
    }

    inline Foam::vector divided(const Foam::vector& v, const Foam::vector& d)
    {
        return Foam::cmptDivide(v, d);
    }
}


Foam::vectorOverRelaxation::vectorOverRelaxation
(
    const fvVectorMatrix& matrix,
    volVectorField& psi
)
:
    vectorSmoothSolver("overRelaxation", matrix, psi),
    omega_(matrix.diag().size(), Zero)
{
    setFactors();
}


Foam::scalar Foam::vectorOverRelaxation::rDiagonal(const label celli) const
{
    return rDiags_.empty() ? rDiag_[celli] : cmptMax(rDiags_[celli]);
}


void Foam::vectorOverRelaxation::setFactors()
{
    const labelUList& l = matrix_.lduAddr().lowerAddr();
    const labelUList& u = matrix_.lduAddr().upperAddr();
    const scalarField& lower = matrix_.lower();
    const scalarField& upper = matrix_.upper();
    scalarField& mu = omega_;

    forAll(u, facei)
    {
        const scalar part = Foam::sqrt
        (
            max(lower[facei]*upper[facei], scalar(0))
           *rDiagonal(l[facei])*rDiagonal(u[facei])
        );

        mu[l[facei]] += part;
        mu[u[facei]] += part;
    }

    // Above 1 without a dominant diagonal
    for (scalar& factor : omega_)
    {
        factor = 2/(1 + Foam::sqrt(max(1 - sqr(factor), scalar(0.01))));
    }
}


Foam::vector Foam::vectorOverRelaxation::begin()
{
    const vector norm(vectorSmoothSolver::begin());

    work_ = source_ - work_;
    before_ = coupledProducts();

    return norm;
}


template<class Diagonal>
void Foam::vectorOverRelaxation::sweep(const Field<Diagonal>& rDiag)
{
    const label* const __restrict__ u =
        matrix_.lduAddr().upperAddr().begin();
    const label* const __restrict__ start =
        matrix_.lduAddr().ownerStartAddr().begin();
    const scalar* const __restrict__ lower = matrix_.lower().begin();
    const scalar* const __restrict__ upper = matrix_.upper().begin();
    const scalar* const __restrict__ omega = omega_.begin();
    const Diagonal* const __restrict__ rD = rDiag.begin();
    vector* const __restrict__ b = work_.begin();
    vector* const __restrict__ r = residual_.begin();
    vector* const psi = psi_.primitiveFieldRef().begin();

    for (label celli = work_.size() - 1; celli >= 0; --celli)
    {
        vector sum(Zero);

        for (label facei = start[celli + 1] - 1; facei >= start[celli]; --facei)
        {
            sum += upper[facei]*psi[u[facei]];
        }

        const vector full(scaled(b[celli] - sum, rD[celli]) - psi[celli]);
        const vector change(omega[celli]*full);

        // What is left of it, but for later changes of b
        r[celli] = divided(full - change, rD[celli]) - b[celli];
        psi[celli] += change;

        for (label facei = start[celli]; facei < start[celli + 1]; ++facei)
        {
            b[u[facei]] -= lower[facei]*change;
        }
    }

    updateCoupled();
    List<vectorField> now(coupledProducts());

    addCoupled(-1, before_, work_);
    addCoupled(1, now, work_);
    before_.transfer(now);
    residual_ += work_;
}


void Foam::vectorOverRelaxation::sweep()
{
    if (rDiags_.empty())
    {
        sweep(rDiag_);
    }
    else
    {
        sweep(rDiags_);
    }
}
