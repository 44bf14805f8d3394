// SPDX-License-Identifier: GPL-3.0-or-later

#include "directStokes.H"

extern "C"
{

void dgetrs_
(
    const char* trans, const int* n, const int* nRhs, const double* A,
    const int* ldA, const int* pivots, double* B, const int* ldB, int* info
);

}


Foam::directStokes::directStokes
(
    stokesEquations& equations,
    const tubeGrid& grid
)
:
    stokesSolver(equations),
    grid_(grid),
    stencils_(equations, grid),
    inverse_(grid, stencils_),
    freePatches_(equations.patchSource()),
    columnOf_(equations.mesh().nCells(), -1),
    reused_(false)
{
    inverse_.solve(freePatches_);

    for (direction cmpt = 0; cmpt < 2; ++cmpt)
    {
        vector f(Zero);
        f[cmpt] = 1;
        freeForces_[cmpt] = equations.forceSource(f);
        inverse_.solve(freeForces_[cmpt]);
    }
}


void Foam::directStokes::begin()
{
    findRows();

    std::vector<double> now(signature());

    reused_ = now == signature_;

    if (!reused_)
    {
        signature_.swap(now);
        makeMatrix();
    }
}


Foam::tmp<Foam::scalarField> Foam::directStokes::unscaled
(
    const scalarField& b
) const
{
    const label n = equations_.mesh().nCells();
    const scalarField& A0 = equations_.A0();
    const scalarField& K = equations_.bodies()->K();
    tmp<scalarField> tb(new scalarField(b));

    for (label i = 0; i < 2*n; ++i)
    {
        tb.ref()[i] *= 1 + K[i % n]/A0[i % n];
    }

    return tb;
}


Foam::scalarField Foam::directStokes::inBands
(
    const label source,
    const vector& f,
    const scalarField& b,
    const scalarField& x
) const
{
    const label n = equations_.mesh().nCells();
    const scalarField sources(unscaled(b));
    const scalarField& shield = equations_.bodies()->shield();
    scalarField y(rowCells_.size(), Zero);

    if (source < 0)
    {
        y = -multiply(x);
    }

    forAll(y, row)
    {
        const label celli = rowCells_[row], k = rowKinds_[row];

        if (source >= 0)
        {
            y[row] += sources[k*n + celli];
        }
        else if (source == force && k < 2)
        {
            y[row] -= shield[celli]*f[k]/equations_.A0()[celli];
        }
    }

    return y;
}


Foam::scalar Foam::directStokes::solve
(
    const label source,
    const vector& f,
    scalarField& x
)
{
    const label n = equations_.mesh().nCells();
    const scalarField b(rightSide(source, f));

    x = scalarField(b.size(), Zero);

    if (source == patches)
    {
        x = freePatches_;
    }
    else if (source == force)
    {
        x = f.x()*freeForces_[0] + f.y()*freeForces_[1];
    }

    scalarField y(inBands(source, f, b, x));
    const int size = y.size(), one = 1;
    int info = 0;

    dgetrs_
    (
        "N", &size, &one, matrix_.data(), &size, pivots_.data(), y.begin(),
        &size, &info
    );

    scalarField byBodies(x.size(), Zero);

    forAll(y, row)
    {
        byBodies[rowKinds_[row]*n + rowCells_[row]] = y[row];
    }
    inverse_.solve(byBodies);
    x += byBodies;

    return Foam::sqrt
    (
        sumSqr(b - equations_.multiply(x)())/max(sumSqr(b), VSMALL)
    );
}


void Foam::directStokes::report(Ostream& os) const
{
    os  << "dense matrix of " << rowCells_.size() << " rows"
        << (reused_ ? ", that of the last state" : "");
}
