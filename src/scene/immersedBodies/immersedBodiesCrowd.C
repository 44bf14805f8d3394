// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"

Foam::scalar Foam::immersedBodies::correctCrowd
(
    const scalarField& p,
    const scalar dt
)
{
    const vectorField gradP(pressure_.gradients(p));
    scalar most = 0;

    forAll(bodies_, bodyi)
    {
        if (region_.selected(bodyi))
        {
            pressure_.set(bodyi, gradP[bodyi]);
        }
        else if (bodies_[bodyi].resolved())
        {
            const scalar change =
                pressure_.speedChange(bodyi, gradP[bodyi], dt);

            crowd_.note(bodyi, change);
            most = max(most, change);
        }
    }

    return most;
}
