// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"

void Foam::flowSolvers::immersedFluid::motionCorrector()
{
    if (!immersed())
    {
        incompressibleFluid::motionCorrector();
        return;
    }

    if (outer_ == 1)
    {
        bodies_->beginStep();
    }

    bodies_->predict(outer_ > 1);
}
