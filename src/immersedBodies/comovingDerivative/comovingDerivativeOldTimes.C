// SPDX-License-Identifier: GPL-3.0-or-later

#include "comovingDerivative.H"

void Foam::comovingDerivative::setCombination
(
    const volVectorField& U0,
    const volVectorField& U00,
    const vectorField& moved
) const
{
    if (!combined_.valid())
    {
        combined_.reset
        (
            new volVectorField
            (
                IOobject
                (
                    "oldVelocities",
                    mesh_.time().timeName(),
                    mesh_,
                    IOobject::NO_READ,
                    IOobject::NO_WRITE,
                    false
                ),
                mesh_,
                dimensionedVector(dimAcceleration, Zero)
            )
        );
    }

    volVectorField& y = combined_();

    for (const label celli : wide_)
    {
        y[celli] = ddt_.c0*U0[celli] - ddt_.c00*U00[celli];
    }

    forAll(cells_, i)
    {
        y[cells_[i]] += ddt_.c00*moved[i];

        for (const auto& face : neighbours_.onPatches(cells_[i]))
        {
            y.boundaryFieldRef()[face.patch][face.face] =
                ddt_.c0*U0.boundaryField()[face.patch][face.face]
              - ddt_.c00*U00.boundaryField()[face.patch][face.face];
        }
    }
}


void Foam::comovingDerivative::addOldTimes
(
    const volVectorField& U,
    vectorField& source
) const
{
    if (!active_)
    {
        return;
    }

    const volVectorField& U0 = U.oldTime();

    if (ddt_.c00 <= 0)
    {
        const vectorField change(swept(s0_, U0));

        forAll(cells_, i)
        {
            source[cells_[i]] -= ddt_.c0*change[i];
        }
        return;
    }

    // S0 (c0 U0 - c00 S' U00), of which c0 U0 - c00 U00 is in the source: of S'
    // once with the swept volumes, which conserve momentum, once without, for
    // what is moved on by S0
    const volVectorField& U00 = U0.oldTime();
    vectorField s(s00_);

    forAll(s, i)
    {
        s[i] -= s0_[i];
    }

    const vectorField before(swept(s, U00));
    const scalarField volumes(sweptVolume(s));
    vectorField moved(before.size());

    forAll(cells_, i)
    {
        const label celli = cells_[i];

        moved[i] = (before[i] - volumes[i]*U00[celli])/mesh_.V()[celli];
    }

    setCombination(U0, U00, moved);

    const vectorField change(swept(s0_, combined_()));

    forAll(cells_, i)
    {
        source[cells_[i]] += ddt_.c00*before[i] - change[i];
    }
}


void Foam::comovingDerivative::follow
(
    const scalar part,
    volScalarField& p,
    volVectorField& gradP
) const
{
    const scalarField change(swept(s0_, p));
    const scalarField volumes(sweptVolume(s0_));
    scalarField& values = p.primitiveFieldRef();

    forAll(cells_, i)
    {
        const label celli = cells_[i];

        values[celli] -= part
           *(change[i] - volumes[i]*values[celli])/mesh_.V()[celli];
    }
    p.correctBoundaryConditions();

    UIndirectList<vector>(gradP.primitiveFieldRef(), wide_) =
        gradients(p, wide_);
    gradP.correctBoundaryConditions();
}
