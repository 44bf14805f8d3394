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


Foam::rigidMotion Foam::stokesModes::freeMotion
(
    const label bodyi,
    const vector& W
) const
{
    rigidMotion motion{bodyi, -W, Zero};

    for (label i = 0; i < bodies_.nModes(); ++i)
    {
        const rigidMotion part(bodies_.motion(i));

        if (part.body == bodyi)
        {
            motion.U += V[i]*part.U;
            motion.omega += V[i]*part.omega;
        }
    }

    return motion;
}


Foam::scalar Foam::stokesModes::insideBodies
(
    const label mode,
    const vector& W
) const
{
    const rigidMotion one(bodies_.motion(mode));
    const immersedBody& body = bodies_[one.body];
    const rigidMotion free(freeMotion(one.body, W));
    const vector& omega = free.omega;

    return body.volume()*((omega^free.U) & one.U)
      + ((omega^(body.inertia(body.state()) & omega)) & one.omega);
}


Foam::scalar Foam::stokesModes::inLayers
(
    const label mode,
    const vector& W
) const
{
    const scalarField& volumes = equations_.mesh().V();
    const label nCells = volumes.size();
    const rigidMotion one(bodies_.motion(mode));
    scalar sum = 0;

    for (const bodyRegion& region : bodies_.region().regions())
    {
        const label bodyi = region.body();
        const point& centre = bodies_[bodyi].state().position;
        const rigidMotion free(freeMotion(bodyi, W));

        forAll(region.cells, j)
        {
            const label celli = region.cells[j];
            const vector r(region.x(j) - centre);
            vector u(bodyi == one.body ? -one(r) : Zero);

            forAll(equations_.components(), k)
            {
                u[equations_.components()[k]] += x_[mode][k*nCells + celli];
            }
            sum += volumes[celli]*region.share[j]*((free.omega^free(r)) & u);
        }
    }

    return returnReduce(sum, sumOp<scalar>());
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
        C[i] = -
        (
            returnReduce(sum, sumOp<scalar>())
          - inLayers(i, W)
          - insideBodies(i, W)
        )/bodies_.space().depth();
    }

    V1 = denseMatrix::multiply(mobility, C);
}
