// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBody.H"

void Foam::immersedBody::checkRestraints(const scalar t) const
{
    for (const bodyRestraint& restraint : *restraints_)
    {
        restraint.check(t);
    }
}


void Foam::immersedBody::addRestraints
(
    rigidMomentum& residual,
    scalarSquareMatrix& J
) const
{
    const bodyRestraint::motion motion
    {
        unwrapped() + meshShift_,
        startPosition_,
        bodyRestraint::turn(startOrientation_, state_.orientation),
        state_.U,
        state_.omega,
        time_,
        0.5*deltaT_
    };
    rigidMomentum load{Zero, Zero};

    for (const bodyRestraint& restraint : *restraints_)
    {
        restraint.addLoad(motion, load);
        restraint.addResponse(motion, J);
    }

    residual = residual - load;
}
