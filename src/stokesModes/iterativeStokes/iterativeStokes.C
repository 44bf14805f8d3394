// SPDX-License-Identifier: GPL-3.0-or-later

#include "iterativeStokes.H"

Foam::iterativeStokes::iterativeStokes
(
    stokesEquations& equations,
    const scalar tolerance,
    const label maxIterations
)
:
    stokesSolver(equations),
    tolerance_(tolerance),
    maxIterations_(maxIterations)
{}


void Foam::iterativeStokes::begin()
{
    preconditioner_.reset(new stokesPreconditioner(equations_));
    krylov_.reset
    (
        new recycledKrylov
        (
            [&](const scalarField& x) { return equations_.multiply(x); },
            [&](const scalarField& r) { return preconditioner_()(r); }
        )
    );
}


Foam::scalar Foam::iterativeStokes::solve
(
    const label source,
    const vector& f,
    scalarField& x
)
{
    return krylov_->solve
    (
        rightSide(source, f)(), tolerance_, maxIterations_, x
    );
}


void Foam::iterativeStokes::report(Ostream& os) const
{
    os  << krylov_->nIterations() << " iterations";
}
