// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscousSolver.H"

namespace
{
    //- One cycle mostly
    Foam::dictionary controls()
    {
        Foam::dictionary dict;

        dict.add("solver", "GAMG");
        dict.add("smoother", "symGaussSeidel");
        dict.add("tolerance", 0);
        dict.add("relTol", 0.1);
        dict.add("maxIter", 20);

        return dict;
    }
}


Foam::viscousSolver::viscousSolver(const stokesEquations& equations)
:
    systems_(equations.components().size()),
    interfaces_(equations.U().boundaryField().scalarInterfaces())
{
    const fvMesh& mesh = equations.mesh();
    const fvVectorMatrix& eqn = equations.viscous();
    const dictionary dict(controls());

    forAll(systems_, i)
    {
        const direction cmpt = equations.components()[i];

        systems_.set
        (
            i,
            new system
            {
                lduMatrix(mesh),
                eqn.internalCoeffs().component(cmpt),
                eqn.boundaryCoeffs().component(cmpt),
                nullptr
            }
        );

        lduMatrix& matrix = systems_[i].matrix;
        matrix.upper() = eqn.upper();
        matrix.diag() = eqn.diag();

        if (equations.bodies())
        {
            matrix.diag() += mesh.V()*equations.bodies()->K();
        }

        forAll(mesh.boundary(), patchi)
        {
            const labelUList& cells = mesh.boundary()[patchi].faceCells();
            const scalarField& coeffs = systems_[i].onPatches[patchi];

            forAll(coeffs, facei)
            {
                matrix.diag()[cells[facei]] += coeffs[facei];
            }
        }

        systems_[i].solver = lduMatrix::solver::New
        (
            "viscous",
            matrix,
            systems_[i].beyond,
            systems_[i].onPatches,
            interfaces_,
            dict
        );
    }
}


Foam::tmp<Foam::scalarField> Foam::viscousSolver::solve
(
    const label i,
    const scalarField& f
) const
{
    tmp<scalarField> tU(new scalarField(f.size(), Zero));

    systems_[i].solver->solve(tU.ref(), f, 0);

    return tU;
}
