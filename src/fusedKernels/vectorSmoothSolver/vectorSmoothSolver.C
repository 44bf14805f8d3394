// SPDX-License-Identifier: GPL-3.0-or-later

#include "vectorSmoothSolver.H"
#include "profiling.H"

namespace
{
    //- Residual, one at first, of sweeps that lead away from the solution
    const Foam::scalar diverged = 1e6;

    //- Sweeps, of those that the residual asks for, before the next look at it
    const Foam::scalar blindPart = 0.5;
    const Foam::label maxBlind = 20;

    //- Sweeps to do before the next look: before and now: residual over what
    //  it may be, with n sweeps between them
    Foam::label nToLook
    (
        const Foam::scalar before,
        const Foam::scalar now,
        const Foam::label n
    )
    {
        if (!(now > 1 && now < before))
        {
            return 1;
        }

        const Foam::scalar part =
            blindPart*n*Foam::log(now)/Foam::log(before/now);

        return Foam::label(Foam::max(1, Foam::min(part, maxBlind)));
    }
}


Foam::vectorSmoothSolver::vectorSmoothSolver
(
    const word& name,
    const fvVectorMatrix& matrix,
    volVectorField& psi
)
:
    matrix_(matrix),
    psi_(psi),
    source_(matrix.source()),
    work_(matrix.diag().size()),
    residual_(matrix.diag().size()),
    sumMag_(Zero),
    trend_{nullptr, nullptr, 0},
    performance_(name, psi.name())
{
    forAll(psi.boundaryField(), patchi)
    {
        const labelUList& cells = matrix.lduAddr().patchAddr(patchi);
        const vectorField& boundary = matrix.boundaryCoeffs()[patchi];

        if (!psi.boundaryField()[patchi].coupled())
        {
            forAll(boundary, i)
            {
                source_[cells[i]] += boundary[i];
            }
        }
    }

    setDiagonal();

    const Vector<label> valid(psi.mesh().validComponents<vector>());

    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        solved_[cmpt] = valid[cmpt] == -1 ? 0 : 1;
    }

    // Rounding of the others would spread, by sweeps, as tails of ever smaller
    // numbers, and the processor takes long for the last of them
    if (solved_ != vector::one)
    {
        vectorField& values = psi.primitiveFieldRef();

        forAll(values, celli)
        {
            source_[celli] = cmptMultiply(solved_, source_[celli]);
            values[celli] = cmptMultiply(solved_, values[celli]);
        }
    }
}


void Foam::vectorSmoothSolver::updateCoupled()
{
    volVectorField::Boundary& patches = psi_.boundaryFieldRef();
    const label nRequests = Pstream::nRequests();

    for (fvPatchVectorField& patch : patches)
    {
        if (patch.coupled())
        {
            patch.initEvaluate(Pstream::commsTypes::nonBlocking);
        }
    }

    if (Pstream::parRun())
    {
        Pstream::waitRequests(nRequests);
    }

    for (fvPatchVectorField& patch : patches)
    {
        if (patch.coupled())
        {
            patch.evaluate(Pstream::commsTypes::nonBlocking);
        }
    }
}


Foam::List<Foam::vectorField>
Foam::vectorSmoothSolver::coupledProducts() const
{
    List<vectorField> products(psi_.boundaryField().size());

    forAll(products, patchi)
    {
        const fvPatchVectorField& patch = psi_.boundaryField()[patchi];

        if (patch.coupled())
        {
            products[patchi] = cmptMultiply
            (
                matrix_.boundaryCoeffs()[patchi],
                patch.patchNeighbourField()
            );
        }
    }

    return products;
}


void Foam::vectorSmoothSolver::addCoupled
(
    const scalar factor,
    const List<vectorField>& products,
    vectorField& b
) const
{
    forAll(products, patchi)
    {
        const labelUList& cells = matrix_.lduAddr().patchAddr(patchi);

        forAll(products[patchi], i)
        {
            b[cells[i]] += factor*products[patchi][i];
        }
    }
}


void Foam::vectorSmoothSolver::follow
(
    const vectorField& from,
    const vectorField& to,
    const scalar part
)
{
    trend_ = trend{&from, &to, part};
}


Foam::SolverPerformance<Foam::vector> Foam::vectorSmoothSolver::solve
(
    const dictionary& controls
)
{
    addProfiling(solve, "vectorSmoothSolver." + psi_.name());

    const scalar tolerance = controls.lookupOrDefault("tolerance", 1e-6);
    const scalar relTol = controls.lookupOrDefault<scalar>("relTol", 0);
    const label nSweeps = controls.lookupOrDefault<label>("nSweeps", 1);
    const label minIter = controls.lookupOrDefault<label>("minIter", 0);
    const label maxIter = controls.lookupOrDefault<label>("maxIter", 1000);

    updateCoupled();

    const vector norm(begin());
    scalar rest = excess(tolerance, relTol);
    label n = 0;
    label next = nSweeps;

    // Beyond `diverged` numbers would overflow
    while
    (
        (n < minIter || (n < maxIter && rest >= 1))
     && cmptMax(performance_.finalResidual()) < diverged
    )
    {
        const scalar before = rest;

        for (label i = 1; i <= next; ++i)
        {
            sweep(i == next);
        }
        n += next;
        rest = look(tolerance, relTol, norm);

        if (rest < 1)
        {
            measureAll();
            rest = look(tolerance, relTol, norm);
        }
        next = max(nSweeps, min(nToLook(before, rest, next), maxIter - n));
    }

    performance_.nIterations() = Vector<label>::uniform(n);
    psi_.correctBoundaryConditions();
    report();

    return performance_;
}
