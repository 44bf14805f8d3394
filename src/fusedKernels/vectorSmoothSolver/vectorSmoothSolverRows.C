// SPDX-License-Identifier: GPL-3.0-or-later

#include "vectorSmoothSolver.H"

namespace
{
    //- Components of |v|
    inline void addMag(Foam::vector& sum, const Foam::vector& v)
    {
        sum += Foam::cmptMag(v);
    }


    // The diagonal of a row: one number, or one for each component

    inline Foam::scalar reciprocal(const Foam::scalar d)
    {
        return 1/d;
    }

    inline Foam::vector reciprocal(const Foam::vector& d)
    {
        return Foam::cmptDivide(Foam::vector::one, d);
    }

    inline void increase(Foam::scalar& d, const Foam::vector& part)
    {
        d += part.x();
    }

    inline void increase(Foam::vector& d, const Foam::vector& part)
    {
        d += part;
    }

    inline Foam::vector scaled(const Foam::vector& v, const Foam::scalar d)
    {
        return d*v;
    }

    inline Foam::vector scaled(const Foam::vector& v, const Foam::vector& d)
    {
        return Foam::cmptMultiply(v, d);
    }
}


template<class Diagonal>
void Foam::vectorSmoothSolver::setDiagonal
(
    Field<Diagonal>& diag,
    Field<Diagonal>& rDiag
) const
{
    const scalarField& internal = matrix_.diag();

    diag.resize(internal.size());
    rDiag.resize(internal.size());

    forAll(diag, celli)
    {
        diag[celli] = pTraits<Diagonal>::one*internal[celli];
    }

    forAll(psi_.boundaryField(), patchi)
    {
        const labelUList& cells = matrix_.lduAddr().patchAddr(patchi);
        const vectorField& onPatch = matrix_.internalCoeffs()[patchi];

        forAll(onPatch, i)
        {
            increase(diag[cells[i]], onPatch[i]);
        }
    }

    forAll(diag, celli)
    {
        rDiag[celli] = reciprocal(diag[celli]);
    }
}


void Foam::vectorSmoothSolver::setDiagonal()
{
    bool same = true;

    for (const vectorField& internal : matrix_.internalCoeffs())
    {
        for (const vector& v : internal)
        {
            same = same && v.x() == v.y() && v.x() == v.z();
        }
    }

    if (same)
    {
        setDiagonal(diag_, rDiag_);
    }
    else
    {
        setDiagonal(diags_, rDiags_);
    }
}


template<class Diagonal>
Foam::vector Foam::vectorSmoothSolver::begin(const Field<Diagonal>& diag)
{
    const labelUList& u = matrix_.lduAddr().upperAddr();
    const labelUList& start = matrix_.lduAddr().ownerStartAddr();
    const scalarField& lower = matrix_.lower();
    const scalarField& upper = matrix_.upper();
    const vectorField& psi = psi_.primitiveField();
    const vector mean(gAverage(psi));
    scalarField sumA(work_.size(), Zero);

    work_ = Zero;
    addCoupled(-1, coupledProducts(), work_);

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

    vector sum(Zero);
    sumMag_ = Zero;

    // Faces are in the order of their owners: when its turn comes a row has got
    // all that its lower neighbours add to it
    forAll(sumA, celli)
    {
        const vector& x = psi[celli];
        vector Ax(work_[celli] + scaled(x, diag[celli]));
        scalar rowSum = sumA[celli];

        for (label facei = start[celli]; facei < start[celli + 1]; ++facei)
        {
            const label n = u[facei];

            Ax += upper[facei]*psi[n];
            rowSum += upper[facei];
            work_[n] += lower[facei]*x;
            sumA[n] += lower[facei];
        }

        const vector reference(rowSum*mean + scaled(mean, diag[celli]));

        addMag(sum, weight(celli)*(Ax - reference));
        addMag(sum, weight(celli)*(source_[celli] - reference));
        addMag(sumMag_, weight(celli)*(source_[celli] - Ax));
    }

    return returnReduce(sum, sumOp<vector>())
      + vector::uniform(solverPerformance::small_);
}


Foam::vector Foam::vectorSmoothSolver::begin()
{
    return diags_.empty() ? begin(diag_) : begin(diags_);
}


template<class Diagonal>
void Foam::vectorSmoothSolver::sweep(const Field<Diagonal>& rDiag)
{
    const label nCells = work_.size();
    const List<vectorField> before(coupledProducts());

    work_ = source_;
    addCoupled(1, before, work_);

    const label* const __restrict__ u =
        matrix_.lduAddr().upperAddr().begin();
    const label* const __restrict__ start =
        matrix_.lduAddr().ownerStartAddr().begin();
    const scalar* const __restrict__ lower = matrix_.lower().begin();
    const scalar* const __restrict__ upper = matrix_.upper().begin();
    const Diagonal* const __restrict__ rD = rDiag.begin();
    vector* const __restrict__ b = work_.begin();
    vector* const __restrict__ r = residual_.begin();
    vector* const psi = psi_.primitiveFieldRef().begin();

    // The row's own unknown, from those of its upper neighbours and what the
    // lower ones have taken off b. What was set just before comes last, for
    // the processor not to wait for it.
    const auto solution = [=](const label celli)
    {
        vector sum(Zero);

        for (label facei = start[celli + 1] - 1; facei >= start[celli]; --facei)
        {
            sum += upper[facei]*psi[u[facei]];
        }

        return scaled(b[celli] - sum, rD[celli]);
    };

    for (label celli = 0; celli < nCells; ++celli)
    {
        const vector x(solution(celli));

        for (label facei = start[celli]; facei < start[celli + 1]; ++facei)
        {
            b[u[facei]] -= lower[facei]*x;
        }
        psi[celli] = x;
    }

    // What the lower neighbours have taken off b stands until they change
    for (label celli = nCells - 1; celli >= 0; --celli)
    {
        const vector x(solution(celli));
        const vector change(psi[celli] - x);

        r[celli] = Zero;

        for (label facei = start[celli]; facei < start[celli + 1]; ++facei)
        {
            r[u[facei]] += lower[facei]*change;
        }
        psi[celli] = x;
    }

    updateCoupled();
    addCoupled(-1, before, residual_);
    addCoupled(1, coupledProducts(), residual_);

    sumMag_ = Zero;

    forAll(residual_, celli)
    {
        addMag(sumMag_, weight(celli)*residual_[celli]);
    }
}


void Foam::vectorSmoothSolver::sweep()
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
