// SPDX-License-Identifier: GPL-3.0-or-later

#include "stokesPreconditioner.H"

namespace
{
    //- Part of w at least, by the leak of bodies
    const Foam::scalar leastPart = 1e-4;
}

Foam::stokesPreconditioner::stokesPreconditioner(stokesEquations& equations)
:
    equations_(equations),
    viscous_(equations)
{}


Foam::tmp<Foam::scalarField> Foam::stokesPreconditioner::operator()
(
    const scalarField& r
) const
{
    const fvMesh& mesh = equations_.mesh();
    const scalarField& V = mesh.V();
    const label n = mesh.nCells();
    const label nComponents = equations_.components().size();
    const stokesBodies* bodies = equations_.bodies();
    tmp<scalarField> tx(new scalarField(r.size(), Zero));
    scalarField& x = tx.ref();

    // Not scaled
    scalarField rows(equations_.A0());
    if (bodies)
    {
        rows += bodies->K();
    }

    for (label i = 0; i < nComponents; ++i)
    {
        SubList<scalar>(x, n, i*n) = viscous_.solve
        (
            i,
            V*rows*SubField<scalar>(r, n, i*n)
        )();
    }

    const scalarField left(r - equations_.multiply(x)());

    for (label celli = 0; celli < n; ++celli)
    {
        const scalar w = bodies
          ? sqr(1 - bodies->shield()[celli])*equations_.A0()[celli]/rows[celli]
          : 1;

        x[nComponents*n + celli] = equations_.nu()/max(w, leastPart)
           *equations_.area()[celli]/V[celli]*left[nComponents*n + celli];
    }

    return tx;
}
