// SPDX-License-Identifier: GPL-3.0-or-later

#include "bandMomentum.H"
#include "bandRows.H"
#include "coupledValues.H"
#include "profiling.H"

namespace
{
    //- Sweeps after which the rows are left as they are
    const Foam::label maxSweeps = 100;
}


Foam::bandMomentum::bandMomentum(const immersedRegion& region)
:
    region_(region)
{}


void Foam::bandMomentum::penalise
(
    const vectorField& gradP,
    fvVectorMatrix& E
)
{
    addProfiling(penalise, "immersedBodies::penalise");

    const labelUList& cells = region_.cells();
    const bodySums& sums = region_.sums();
    const scalarField& V = E.psi().mesh().V();
    const scalarField& K = sums.K();
    const vectorField& KU = sums.KU();
    const vectorField& shieldDU = sums.shieldDU();
    const scalarField& shield = sums.shield();
    scalarField& diag = E.diag();
    vectorField& source = E.source();

    diag_.resize(cells.size());

    forAll(cells, i)
    {
        const label celli = cells[i];

        diag_[i] = diag[celli];
        diag[celli] += V[celli]*K[celli];
        source[celli] += V[celli]
           *(KU[celli] + shield[celli]*gradP[celli] + shieldDU[celli]);
    }
}


Foam::scalarField Foam::bandMomentum::weights(const volScalarField& A0) const
{
    const labelUList& cells = region_.cells();
    const scalarField& K = region_.sums().K();
    scalarField weights(cells.size());

    forAll(cells, i)
    {
        weights[i] = A0[cells[i]]/(A0[cells[i]] + K[cells[i]]);
    }

    return weights;
}


void Foam::bandMomentum::scaleRows
(
    const volScalarField& A0,
    fvVectorMatrix& E
)
{
    const cellNeighbours& neighbours = region_.neighbours();
    const labelUList& cells = region_.cells();
    const scalarField scales(weights(A0));

    // Both, as the scaled matrix is not symmetric even where E0 is
    scalarField& lower = E.lower();
    scalarField& upper = E.upper();

    forAll(cells, i)
    {
        const label celli = cells[i];

        E.diag()[celli] *= scales[i];
        E.source()[celli] *= scales[i];

        for (const auto& n : neighbours.of(celli))
        {
            scalar& coeff = (n.owner() ? upper : lower)[n.face()];

            faces_.append(coeff);
            coeff *= scales[i];
        }

        for (const auto& face : neighbours.onPatches(celli))
        {
            vector& internal = E.internalCoeffs()[face.patch][face.face];
            vector& boundary = E.boundaryCoeffs()[face.patch][face.face];

            patches_.append(internal);
            patches_.append(boundary);
            internal *= scales[i];
            boundary *= scales[i];
        }
    }
}


void Foam::bandMomentum::restore(fvVectorMatrix& E)
{
    const labelUList& cells = region_.cells();

    UIndirectList<scalar>(E.diag(), cells) = diag_;

    if (!faces_.empty() || !patches_.empty())
    {
        unscaleRows(E);
    }

    corrected_.clear();
    uncorrected_.clear();
}


void Foam::bandMomentum::unscaleRows(fvVectorMatrix& E)
{
    const cellNeighbours& neighbours = region_.neighbours();
    scalarField& lower = E.lower();
    scalarField& upper = E.upper();
    label facei = 0, patch = 0;

    for (const label celli : region_.cells())
    {
        for (const auto& n : neighbours.of(celli))
        {
            (n.owner() ? upper : lower)[n.face()] = faces_[facei++];
        }

        for (const auto& face : neighbours.onPatches(celli))
        {
            E.internalCoeffs()[face.patch][face.face] = patches_[patch++];
            E.boundaryCoeffs()[face.patch][face.face] = patches_[patch++];
        }
    }

    faces_.clear();
    patches_.clear();
}


void Foam::bandMomentum::correctConvection
(
    const surfaceScalarField& phi,
    const surfaceScalarField& phi0,
    const volVectorField& U,
    vectorField& source
)
{
    const cellNeighbours& neighbours = region_.neighbours();
    const surfaceScalarField& weights = U.mesh().weights();
    const List<vectorField> neighbourU(coupledValues(U));

    UIndirectList<vector>(source, corrected_) = uncorrected_;
    corrected_ = region_.cells();
    uncorrected_ = vectorField(source, corrected_);

    for (const label celli : region_.cells())
    {
        for (const auto& n : neighbours.of(celli))
        {
            const label facei = n.face();
            const scalar w = weights[facei];
            const scalar change = phi[facei] - phi0[facei];

            source[celli] -= change*(n.owner() ? 1 - w : -w)
               *(U[n.cell()] - U[celli]);
        }

        for (const auto& face : neighbours.onPatches(celli))
        {
            const label patchi = face.patch;
            const label i = face.face;
            const scalar change =
                phi.boundaryField()[patchi][i]
              - phi0.boundaryField()[patchi][i];

            source[celli] -= neighbourU[patchi].size()
              ? change*(1 - weights.boundaryField()[patchi][i])
               *(neighbourU[patchi][i] - U[celli])
              : change*(U.boundaryField()[patchi][i] - U[celli]);
        }
    }
}


Foam::label Foam::bandMomentum::relax
(
    const fvVectorMatrix& E0,
    const vectorField& gradP,
    const scalar tolerance,
    const scalar relTol,
    volVectorField& U
) const
{
    const labelUList& cells = region_.cells();
    const bodySums& sums = region_.sums();
    vectorField f(cells.size());

    forAll(f, i)
    {
        const label celli = cells[i];

        f[i] = sums.KU()[celli] + sums.shieldDU()[celli]
          - (1 - sums.shield()[celli])*gradP[celli];
    }

    bandRows rows(E0, region_.neighbours(), cells, sums.K(), f);
    const vectorField before(U.primitiveField(), cells);
    scalar first = 0;

    for (label sweep = 1; sweep <= maxSweeps; ++sweep)
    {
        // Forth and back
        const scalar change = returnReduce
        (
            rows.sweep(U, sweep % 2 == 0),
            maxOp<scalar>()
        );
        U.correctBoundaryConditions();

        first = sweep == 1 ? change : first;

        if (change <= max(tolerance, relTol*first))
        {
            return sweep;
        }

        // Rows that are not dominated by their diagonals
        if (change > 10*first)
        {
            UIndirectList<vector>(U.primitiveFieldRef(), cells) = before;
            U.correctBoundaryConditions();
            return 0;
        }
    }

    return maxSweeps;
}
