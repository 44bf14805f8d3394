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


Foam::scalar Foam::stokesModes::insideBodies
(
    const label mode,
    const vector& W
) const
{
    const rigidMotion one(bodies_.motion(mode));
    const immersedBody& body = bodies_[one.body];
    vector v(-W), omega(Zero);

    for (label i = 0; i < bodies_.nModes(); ++i)
    {
        const rigidMotion part(bodies_.motion(i));

        if (part.body == one.body)
        {
            v += V[i]*part.U;
            omega += V[i]*part.omega;
        }
    }

    return body.volume()*((omega^v) & one.U)
      + ((omega^(body.inertia(body.state()) & omega)) & one.omega);
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
    const label nCells = mesh.nCells();

    for (label i = 0; i < n; ++i)
    {
        scalar sum = 0;

        forAll(equations_.components(), k)
        {
            const direction cmpt = equations_.components()[k];

            for (label celli = 0; celli < nCells; ++celli)
            {
                sum += mesh.V()[celli]*transport[celli][cmpt]
                   *x_[i][k*nCells + celli];
            }
        }
        C[i] = -(returnReduce(sum, sumOp<scalar>()) - insideBodies(i, W))
           /bodies_.space().depth();
    }

    V1 = denseMatrix::multiply(mobility, C);
}
