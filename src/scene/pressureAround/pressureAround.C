// SPDX-License-Identifier: GPL-3.0-or-later

#include "pressureAround.H"
#include "compat.H"

Foam::pressureAround::pressureAround
(
    bodyList& bodies,
    const immersedRegion& region,
    const bodyLoads& loads,
    const periodicity& periods
)
:
    bodies_(bodies),
    region_(region),
    loads_(loads),
    periods_(periods),
    gradP_(bodies, Zero)
{}


Foam::vectorField Foam::pressureAround::gradients
(
    const scalarField& p,
    const vector& drive
) const
{
    // On both sides of each body: the sum of the values in the cells there,
    // and their number. One list, for one reduction
    const label n = bodies_.size();
    vectorField packed(4*n, Zero);

    const auto sum = [&](const label side, const label bodyi) -> vector&
    {
        return packed[2*n*side + bodyi];
    };
    const auto number = [&](const label side, const label bodyi) -> vector&
    {
        return packed[2*n*side + n + bodyi];
    };

    forAll(bodies_, bodyi)
    {
        const immersedBody& body = bodies_[bodyi];
        const scalar R = body.shape().boundingRadius();

        for (direction k = 0; k < 3 && body.resolved(); ++k)
        {
            for (label side = 0; side < 2; ++side)
            {
                point x(body.state().position);
                x[k] += side ? R : -R;

                for (const auto& im : periods_.localImages(x, 0))
                {
                    const label celli =
                        region_.search().findCell(x + im.shift);

                    sum(side, bodyi)[k] += celli >= 0 ? p[celli] : 0;
                    number(side, bodyi)[k] += celli >= 0;
                }
            }
        }
    }

    compat::allReduce(packed, plusEqOp<vector>());

    vectorField gradP(n, -drive);

    forAll(gradP, bodyi)
    {
        const scalar width = 2*bodies_[bodyi].shape().boundingRadius();

        for (direction k = 0; k < 3; ++k)
        {
            const scalar n0 = number(0, bodyi)[k], n1 = number(1, bodyi)[k];

            if (n0 > 0 && n1 > 0)
            {
                gradP[bodyi][k] +=
                    (sum(1, bodyi)[k]/n1 - sum(0, bodyi)[k]/n0)/width;
            }
        }
    }

    return gradP;
}


Foam::scalar Foam::pressureAround::speedChange
(
    const label bodyi,
    const vector& gradP,
    const scalar dt
) const
{
    const immersedBody& body = bodies_[bodyi];
    const scalar response = max(loads_[bodyi].a*dt/body.volume(), 1);
    const scalar part =
        body.isFree() ? 1.5/(body.densityRatio() + response - 0.5) : 1;

    return part*dt*mag(gradP - gradP_[bodyi]);
}


Foam::scalar Foam::pressureAround::update
(
    const scalarField& p,
    const vector& drive,
    const scalar dt
)
{
    const vectorField gradP(gradients(p, drive));
    scalar most = 0;

    forAll(bodies_, bodyi)
    {
        if (bodies_[bodyi].resolved() && bodies_[bodyi].isFree())
        {
            most = max(most, speedChange(bodyi, gradP[bodyi], dt));
            set(bodyi, gradP[bodyi]);
        }
    }

    return most;
}
