// SPDX-License-Identifier: GPL-3.0-or-later

#include "comovingDerivative.H"

void Foam::comovingDerivative::setMoved
(
    const volVectorField& U,
    const bool add
) const
{
    if (!moved_.valid())
    {
        moved_.reset
        (
            new volVectorField
            (
                IOobject
                (
                    "movedVelocity",
                    mesh_.time().timeName(),
                    mesh_,
                    IOobject::NO_READ,
                    IOobject::NO_WRITE,
                    false
                ),
                mesh_,
                dimensionedVector(dimVelocity, Zero)
            )
        );
    }

    // The scheme Euler does not have what is before the last time
    const bool older = ddt_.c00 > 0;
    const volVectorField& U0 = U.oldTime();
    const volVectorField& U00 = older ? U0.oldTime() : U0;
    volVectorField& y = moved_();

    const auto value = [&]
    (
        const vector& old,
        const vector& oldOld,
        const vector& moved
    )
    {
        const vector sum(ddt_.c0*old);

        return !add ? oldOld : older ? sum - ddt_.c00*moved : sum;
    };

    for (const label celli : remap_->stencil())
    {
        y[celli] = value(U0[celli], U00[celli], y[celli]);

        for (const auto& face : neighbours_.onPatches(celli))
        {
            const vector& before =
                U00.boundaryField()[face.patch][face.face];

            y.boundaryFieldRef()[face.patch][face.face] =
                value
                (
                    U0.boundaryField()[face.patch][face.face], before, before
                );
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

    // S0 (c0 U0 - c00 S' U00), of which c0 U0 - c00 U00 is in the source: of S'
    // once with the swept volumes, which conserve momentum, once without, for
    // what is moved on by S0
    const labelUList& cells = remap_->cells();

    if (ddt_.c00 > 0)
    {
        vectorField s(s00_);

        forAll(s, i)
        {
            s[i] -= s0_[i];
        }
        setMoved(U, false);

        const vectorField swept
        (
            remap_->move(s, components_, true, moved_())
        );

        forAll(cells, i)
        {
            source[cells[i]] += ddt_.c00*swept[i];
        }
    }

    setMoved(U, true);

    const vectorField swept(remap_->move(s0_, components_, true, moved_()));

    forAll(cells, i)
    {
        source[cells[i]] -= swept[i];
    }
}


void Foam::comovingDerivative::follow
(
    const scalar part,
    volScalarField& p,
    volVectorField& gradP
) const
{
    const scalarField before(p, remap_->cells());

    // It bends at surfaces, where sixth order makes it uneven
    remap_->move(s0_, components_, false, p);

    forAll(before, i)
    {
        scalar& value = p[remap_->cells()[i]];

        value = before[i] + part*(value - before[i]);
    }
    p.correctBoundaryConditions();

    UIndirectList<vector>(gradP.primitiveFieldRef(), remap_->wideCells()) =
        remap_->gradients(p);
    gradP.correctBoundaryConditions();
}
