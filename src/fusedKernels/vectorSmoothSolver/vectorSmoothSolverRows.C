// SPDX-License-Identifier: GPL-3.0-or-later

#include "vectorSmoothSolver.H"
#include "rowProducts.H"

namespace
{
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
void Foam::vectorSmoothSolver::sweep
(
    const bool measured,
    const Field<Diagonal>& rDiag
)
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

        if (measured)
        {
            const vector change(psi[celli] - x);

            r[celli] = Zero;

            for (label facei = start[celli]; facei < start[celli + 1]; ++facei)
            {
                r[u[facei]] += lower[facei]*change;
            }
        }
        psi[celli] = x;
    }

    updateCoupled();

    if (!measured)
    {
        return;
    }

    addCoupled(-1, before, residual_);
    addCoupled(1, coupledProducts(), residual_);

    sumMag_ = Zero;

    forAll(residual_, celli)
    {
        addMag(sumMag_, weight(celli)*residual_[celli]);
    }
}


void Foam::vectorSmoothSolver::sweep(const bool measured)
{
    if (rDiags_.empty())
    {
        sweep(measured, rDiag_);
    }
    else
    {
        sweep(measured, rDiags_);
    }
}
