// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"

void Foam::flowSolvers::immersedFluid::bodyCorrector
(
    const ddtCoefficients& ddt,
    const vectorField& dU
)
{
    const bool free = bodies_->anyFree();

    const scalar change = bodies_->correct
    (
        ddt,
        tUEqn(),
        A0_(),
        U_,
        gradP_(),
        dU,
        free && outer_ == 1
    );

    converged_ = !free || change <= bodies_->tolerance()*bodies_->maxSpeed();
}
