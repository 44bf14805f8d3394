// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "compat.H"

Foam::scalar Foam::immersedBodies::correctCrowd
(
    const scalarField& p,
    const scalar dt
)
{
    if (!crowd_.active())
    {
        return 0;
    }

    const vectorField gradP(pressureGradients(p));
    scalar most = 0;

    forAll(bodies_, bodyi)
    {
        if (region_.selected(bodyi))
        {
            crowd_.setPressure(bodyi, gradP[bodyi]);
        }
        else if (bodies_[bodyi].resolved())
        {
            most = max(most, crowd_.follow(bodyi, gradP[bodyi], dt));
        }
    }

    return most;
}


Foam::vectorField Foam::immersedBodies::pressureGradients
(
    const scalarField& p
) const
{
    // On both sides of each body: the sum of the values in the cells there,
    // and their number
    FixedList<vectorField, 2> sums(vectorField(bodies_.size(), Zero));
    FixedList<vectorField, 2> numbers(sums);

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

                for (const auto& im : periodicity_.localImages(x, 0))
                {
                    const label celli =
                        region_.search().findCell(x + im.shift);

                    sums[side][bodyi][k] += celli >= 0 ? p[celli] : 0;
                    numbers[side][bodyi][k] += celli >= 0;
                }
            }
        }
    }

    for (label side = 0; side < 2; ++side)
    {
        compat::allReduce(sums[side], plusEqOp<vector>());
        compat::allReduce(numbers[side], plusEqOp<vector>());
    }

    vectorField gradP(bodies_.size(), Zero);

    forAll(gradP, bodyi)
    {
        const scalar width = 2*bodies_[bodyi].shape().boundingRadius();

        for (direction k = 0; k < 3; ++k)
        {
            const scalar n0 = numbers[0][bodyi][k], n1 = numbers[1][bodyi][k];

            if (n0 > 0 && n1 > 0)
            {
                gradP[bodyi][k] =
                    (sums[1][bodyi][k]/n1 - sums[0][bodyi][k]/n0)/width;
            }
        }
    }

    return gradP;
}
