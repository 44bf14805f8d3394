// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactMass.H"

Foam::vector Foam::contactMass::inverse(const immersedBody& body)
{
    const scalar ratio = body.densityRatio() + body.contact().added().mass;

    return body.isFree()
      ? body.status().freedom().U()/(ratio*body.volume())
      : vector::zero;
}


Foam::tensor Foam::contactMass::inverseInertia
(
    const immersedBody& body,
    const bodyState& state
)
{
    if (!body.isFree())
    {
        return Zero;
    }

    const bodyFreedom& free = body.status().freedom();
    const scalar ratio =
        body.densityRatio() + body.contact().added().rotation;
    tensor I(ratio*body.inertia(state));

    for (direction k = 0; k < 3; ++k)
    {
        if (!free.omega(k))
        {
            for (direction l = 0; l < 3; ++l)
            {
                I(k, l) = I(l, k) = 0;
            }
            I(k, k) = 1;
        }
    }

    tensor inverse(inv(I));

    for (direction k = 0; k < 3; ++k)
    {
        if (!free.omega(k))
        {
            inverse(k, k) = 0;
        }
    }

    return inverse;
}
