// SPDX-License-Identifier: GPL-3.0-or-later

#include "stokesModes.H"
#include "denseMatrix.H"
#include "fvcSurfaceIntegrate.H"
#include "linear.H"

Foam::autoPtr<Foam::stokesFlow> Foam::stokesModes::freeFlow(vector& W)
{
    const label n = bodies_.nModes();
    scalarField x(x_[n]);
    vector mean(Zero);

    for (label i = 0; i < n; ++i)
    {
        x += V[i]*x_[i];
        mean += V[i]*bodies_.motion(i).U/bodies_.size();
    }

    autoPtr<stokesFlow> flow(equations_.flow(x, true));

    for (label i = 0; i < n; ++i)
    {
        equations_.addFlux(i, V[i], flow->phi);
    }

    W = (mean & drive_.direction)*drive_.direction;

    return flow;
}


void Foam::stokesModes::setInertia()
{
    const fvMesh& mesh = equations_.mesh();
    const label n = bodies_.nModes();
    vector W;
    autoPtr<stokesFlow> flow(freeFlow(W));

    flow->phi -= dimensionedVector("W", dimVelocity, W) & mesh.Sf();

    const volVectorField transport
    (
        fvc::surfaceIntegrate(flow->phi*linearInterpolate(flow->U))
    );
    const scalarField fluid(bodies_.fluidFraction());
    const label nCells = mesh.nCells();

    for (label i = 0; i < n; ++i)
    {
        scalar sum = 0;

        forAll(equations_.components(), k)
        {
            const direction cmpt = equations_.components()[k];

            for (label celli = 0; celli < nCells; ++celli)
            {
                sum += mesh.V()[celli]*fluid[celli]*transport[celli][cmpt]
                   *x_[i][k*nCells + celli];
            }
        }
        C[i] = -returnReduce(sum, sumOp<scalar>())/bodies_.space().depth();
    }

    V1 = denseMatrix::multiply(mobility, C);
}
