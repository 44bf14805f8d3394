// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedRegion.H"
#include "coupledValues.H"
#include "bandRows.H"

namespace
{
    //- Sweeps after which the rows are left as they are
    const Foam::label maxSweeps = 100;
}


void Foam::immersedRegion::addConvection
(
    const surfaceScalarField& phi,
    const surfaceScalarField& phi0,
    const volVectorField& U,
    vectorField& source
) const
{
    const surfaceScalarField& weights = mesh_.weights();
    const List<vectorField> neighbourU(coupledValues(U));

    for (const label celli : cells())
    {
        for (const auto& n : neighbours_.of(celli))
        {
            const label facei = n.face();
            const scalar w = weights[facei];
            const scalar change = phi[facei] - phi0[facei];

            source[celli] -= change*(n.owner() ? 1 - w : -w)
               *(U[n.cell()] - U[celli]);
        }

        for (const auto& face : neighbours_.onPatches(celli))
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


Foam::label Foam::immersedRegion::relax
(
    const fvVectorMatrix& E0,
    const vectorField& gradP,
    const scalar tolerance,
    const scalar relTol,
    volVectorField& U
) const
{
    const labelUList& cells = this->cells();
    vectorField f(cells.size());

    forAll(f, i)
    {
        const label celli = cells[i];

        f[i] = KU_[celli] + shieldDU_[celli]
          - (1 - shield_[celli])*gradP[celli];
    }

    bandRows rows(E0, neighbours_, cells, K_, f);
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


void Foam::immersedRegion::bandFaces(DynamicList<label>& faces) const
{
    faces.clear();
    UIndirectList<scalar>(weight_, cells()) = 1;

    for (const label celli : cells())
    {
        for (const auto& n : neighbours_.of(celli))
        {
            // Once
            if (n.owner() || weight_[n.cell()] == 0)
            {
                faces.append(n.face());
            }
        }

        for (const auto& face : neighbours_.onPatches(celli))
        {
            faces.append
            (
                mesh_.boundaryMesh()[face.patch].start() + face.face
            );
        }
    }

    for (const label facei : facesBeside())
    {
        faces.append(facei);
    }

    UIndirectList<scalar>(weight_, cells()) = 0;
}


Foam::DynamicList<Foam::label> Foam::immersedRegion::facesBeside() const
{
    DynamicList<label> faces;

    if (!coupled_)
    {
        return faces;
    }

    weight_.correctBoundaryConditions();

    const List<scalarField> beyond(coupledValues(weight_));

    forAll(beyond, patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];

        forAll(beyond[patchi], i)
        {
            if (beyond[patchi][i] > 0 && weight_[patch.faceCells()[i]] == 0)
            {
                faces.append(patch.start() + i);
            }
        }
    }

    return faces;
}


void Foam::immersedRegion::bandAndBeside(DynamicList<label>& cells) const
{
    const labelUList& inBands = this->cells();

    cells = inBands;
    UIndirectList<scalar>(weight_, cells) = 1;

    const DynamicList<label> beyond(facesBeside());

    const auto append = [&](const label celli)
    {
        if (weight_[celli] == 0)
        {
            weight_[celli] = 1;
            cells.append(celli);
        }
    };

    for (const label celli : inBands)
    {
        for (const auto& n : neighbours_.of(celli))
        {
            append(n.cell());
        }
    }
    for (const label facei : beyond)
    {
        append(mesh_.faceOwner()[facei]);
    }

    UIndirectList<scalar>(weight_, cells) = 0;
}
