// SPDX-License-Identifier: GPL-3.0-or-later

#include "vectorOverRelaxation.H"
#include "addToRunTimeSelectionTable.H"
#include "rowProducts.H"

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
    inline Foam::scalar largest(const Foam::scalar d)
    {
        return d;
    }

    inline Foam::scalar largest(const Foam::vector& d)
    {
        return Foam::cmptMax(d);
    }
}


Foam::vectorOverRelaxation::vectorOverRelaxation
(
    const fvVectorMatrix& matrix,
    volVectorField& psi
)
:
    vectorSmoothSolver("overRelaxation", matrix, psi),
    omega_(matrix.diag().size())
{}


template<class Diagonal>
void Foam::vectorOverRelaxation::setRows(const Field<Diagonal>& rDiag)
{
    const labelUList& u = matrix_.lduAddr().upperAddr();
    const labelUList& start = matrix_.lduAddr().ownerStartAddr();
    const scalarField& lower = matrix_.lower();
    const scalarField& upper = matrix_.upper();
    const vectorField& psi = psi_;
    scalarField& mu = omega_;

    // By the turn of a row those of its lower neighbours have been added
    forAll(mu, celli)
    {
        const scalar rD = largest(rDiag[celli]);
        const vector x(psi[celli]);
        scalar sum = 0;

        for (label facei = start[celli]; facei < start[celli + 1]; ++facei)
        {
            const label n = u[facei];
            const scalar squared =
                lower[facei]*upper[facei]*(rD*largest(rDiag[n]));
            const scalar part = Foam::sqrt(max(squared, scalar(0)));

            sum += part;
            mu[n] += part;
            work_[n] -= lower[facei]*x;
        }

        // Above 1 without a dominant diagonal
        const scalar rest = max(1 - sqr(mu[celli] + sum), scalar(0.01));

        omega_[celli] = 2/(1 + Foam::sqrt(rest));
    }
}


Foam::vector Foam::vectorOverRelaxation::begin()
{
    const vector norm(vectorSmoothSolver::begin());

    before_ = coupledProducts();

    // Only sweeps need the source from here on
    work_.swap(source_);
    addCoupled(1, before_, work_);
    omega_ = Zero;

    if (rDiags_.empty())
    {
        setRows(rDiag_);
    }
    else
    {
        setRows(rDiags_);
    }

    return norm;
}


template<class Diagonal>
void Foam::vectorOverRelaxation::sweepRows(const Field<Diagonal>& rDiag)
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
    vector* const psi = psi_.primitiveFieldRef().begin();

    for (label celli = work_.size() - 1; celli >= 0; --celli)
    {
        const label first = start[celli];
        const label last = start[celli + 1] - 1;
        const scalar w = omega[celli];
        const vector before(psi[celli]);
        vector rest(b[celli]);

        for (label facei = last; facei > first; --facei)
        {
            rest -= upper[facei]*psi[u[facei]];
        }

        vector x((1 - w)*before + scaled(w*rest, rD[celli]));

        // The neighbour that was set just before comes last, for the processor
        // not to wait for it
        if (first <= last)
        {
            x -= scaled((w*upper[first])*psi[u[first]], rD[celli]);
        }

        const vector change(x - before);

        psi[celli] = x;

        for (label facei = first; facei <= last; ++facei)
        {
            b[u[facei]] -= lower[facei]*change;
        }
    }
}


template<class Diagonal>
void Foam::vectorOverRelaxation::measure
(
    const rowSample& sample,
    const Field<Diagonal>& diag
)
{
    const labelUList& u = matrix_.lduAddr().upperAddr();
    const labelUList& start = matrix_.lduAddr().ownerStartAddr();
    const scalarField& upper = matrix_.upper();
    const vectorField& psi = psi_;

    sumMag_ = Zero;

    forAll(sample.rows(), i)
    {
        const label celli = sample.rows()[i];
        vector rest(work_[celli] - scaled(psi[celli], diag[celli]));

        for (label facei = start[celli]; facei < start[celli + 1]; ++facei)
        {
            rest -= upper[facei]*psi[u[facei]];
        }

        sumMag_ += sample.standsFor(i)*weight(celli)*cmptMag(rest);
    }
}


void Foam::vectorOverRelaxation::measure(const rowSample& sample)
{
    if (rDiags_.empty())
    {
        measure(sample, diag_);
    }
    else
    {
        measure(sample, diags_);
    }
}


void Foam::vectorOverRelaxation::sweep(const bool measured)
{
    if (rDiags_.empty())
    {
        sweepRows(rDiag_);
    }
    else
    {
        sweepRows(rDiags_);
    }

    updateCoupled();
    List<vectorField> now(coupledProducts());

    addCoupled(-1, before_, work_);
    addCoupled(1, now, work_);
    before_.transfer(now);

    if (measured)
    {
        measure(sample_());
    }
}


void Foam::vectorOverRelaxation::measureAll()
{
    if (sample_->rows().size() < psi_.size())
    {
        measure(rowSample::all(psi_.size()));
    }
}
