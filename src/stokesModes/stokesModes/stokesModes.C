// SPDX-License-Identifier: GPL-3.0-or-later

#include "stokesModes.H"
#include "denseMatrix.H"

Foam::stokesModes::stokesModes
(
    stokesEquations& equations,
    const stokesBodies& bodies,
    stokesSolver& solver,
    const stokesDrive& drive
)
:
    equations_(equations),
    bodies_(bodies),
    solver_(solver),
    drive_(drive),
    x_(bodies.nModes() + 1),
    loads_(bodies.nModes() + 1),
    asymmetry(0),
    residual(0)
{}


Foam::scalarField Foam::stokesModes::load
(
    const scalarField& x,
    const label source,
    const vector& f
)
{
    autoPtr<stokesFlow> flow
    (
        equations_.flow(x, source == stokesSolver::patches)
    );

    return bodies_.loads
    (
        flow(),
        f,
        source >= 0 ? source : -1
    );
}


Foam::scalar Foam::stokesModes::meanVelocity
(
    const scalarField& x,
    const label source
)
{
    const fvMesh& mesh = equations_.mesh();
    autoPtr<stokesFlow> flow
    (
        equations_.flow(x, source == stokesSolver::patches)
    );
    surfaceScalarField& phi = flow->phi;

    if (source >= 0)
    {
        equations_.addFlux(source, 1, phi);
    }

    // Faces between cells carry the velocity between their centres
    scalar sum = 0;

    forAll(phi, facei)
    {
        const vector way
        (
            mesh.C()[mesh.neighbour()[facei]] - mesh.C()[mesh.owner()[facei]]
        );
        sum += phi[facei]*(way & drive_.direction);
    }
    forAll(phi.boundaryField(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];

        if (patch.coupled())
        {
            const scalarField way(patch.delta() & drive_.direction);

            sum += 0.5*Foam::sum(phi.boundaryField()[patchi]*way);
        }
    }

    return returnReduce(sum, sumOp<scalar>())/gSum(mesh.V());
}


void Foam::stokesModes::solve(const label i, const label source)
{
    x_.set(i, new scalarField);
    residual = max
    (
        residual,
        solver_.solve(source, drive_.direction, x_[i])
    );
    loads_.set(i, new scalarField(load(x_[i], source, Zero)));
}


void Foam::stokesModes::addDrive()
{
    const label n = bodies_.nModes();
    const vector& e = drive_.direction;
    scalarField x;

    residual = max(residual, solver_.solve(stokesSolver::force, e, x));

    const scalarField forces(load(x, stokesSolver::force, e));
    const scalar mean = meanVelocity(x, stokesSolver::force);

    for (label i = 0; i <= n; ++i)
    {
        const bool last = i == n;
        scalar f = last ? drive_.value : 0;

        if (drive_.holdsFlowRate)
        {
            const label source = last ? label(stokesSolver::patches) : i;

            f = (f - meanVelocity(x_[i], source))/mean;
        }
        x_[i] += f*x;
        loads_[i] += f*forces;
    }
}


void Foam::stokesModes::solve(const bool inertia)
{
    const label n = bodies_.nModes();
    const scalar unit = equations_.nu()*bodies_.space().depth();

    residual = asymmetry = 0;
    solver_.begin();

    for (label i = 0; i < n; ++i)
    {
        solve(i, i);
    }
    solve(n, stokesSolver::patches);

    if (drive_.active)
    {
        addDrive();
    }

    A = scalarSquareMatrix(n, Zero);
    B = -loads_[n]/unit;

    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            A(i, j) = loads_[j][i]/unit;
        }
    }
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            asymmetry = max(asymmetry, mag(A(i, j) - A(j, i)));
        }
    }

    eigenvalues = denseMatrix::eigenvalues(A);
    mobility = denseMatrix::inverse(A);
    V = denseMatrix::multiply(mobility, B);

    C = scalarField(n, Zero);
    V1 = C;

    if (inertia)
    {
        setInertia();
    }
}


Foam::autoPtr<Foam::stokesFlow> Foam::stokesModes::flow(const label i)
{
    const label n = bodies_.nModes();
    vector W;

    if (i > n)
    {
        return freeFlow(W);
    }

    autoPtr<stokesFlow> flow(equations_.flow(x_[i], i == n));

    if (i < n)
    {
        equations_.addFlux(i, 1, flow->phi);
    }

    return flow;
}
