// SPDX-License-Identifier: GPL-3.0-or-later

#include "pressureAround.H"
#include "bodyShare.H"

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
    // and their number
    const label n = 4;
    labelList listed(bodies_.size() - bodies_.nUnresolved());
    vectorField packed(n*listed.size(), Zero);
    label last = 0;

    forAll(bodies_, bodyi)
    {
        const immersedBody& body = bodies_[bodyi];

        if (!body.resolved())
        {
            continue;
        }

        const scalar R = body.shape().boundingRadius();
        vector* const sums = &packed[n*last];

        listed[last++] = bodyi;

        for (direction k = 0; k < 3; ++k)
        {
            for (label side = 0; side < 2; ++side)
            {
                point x(body.state().position);
                x[k] += side ? R : -R;

                for (const auto& im : periods_.localImages(x, 0))
                {
                    const label celli =
                        region_.search().findCell(x + im.shift);

                    sums[2*side][k] += celli >= 0 ? p[celli] : 0;
                    sums[2*side + 1][k] += celli >= 0;
                }
            }
        }
    }

    bodies_.share().combine(listed, n, packed, plusEqOp<vector>());

    vectorField gradP(bodies_.size(), -drive);

    forAll(listed, i)
    {
        const vector* const sums = &packed[n*i];
        const scalar width = 2*bodies_[listed[i]].shape().boundingRadius();

        for (direction k = 0; k < 3; ++k)
        {
            const scalar n0 = sums[1][k], n1 = sums[3][k];

            if (n0 > 0 && n1 > 0)
            {
                gradP[listed[i]][k] += (sums[2][k]/n1 - sums[0][k]/n0)/width;
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

    return bodies_.share().largest(most);
}
