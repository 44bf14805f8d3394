// SPDX-License-Identifier: GPL-3.0-or-later

#include "displacedFluid.H"
#include "compat.H"
#include "vectorField.H"

void Foam::displacedFluid::reduce()
{
    vectorField sums(5);
    sums[0] = momentum_;
    sums[1] = spin_;
    sums[2] = vector(volume_, inertia_.xx(), inertia_.xy());
    sums[3] = vector(inertia_.xz(), inertia_.yy(), inertia_.yz());
    sums[4] = vector(inertia_.zz(), 0, 0);

    compat::allReduce(sums, plusEqOp<vector>());

    momentum_ = sums[0];
    spin_ = sums[1];
    volume_ = sums[2].x();
    inertia_ = symmTensor
    (
        sums[2].y(), sums[2].z(), sums[3].x(),
        sums[3].y(), sums[3].z(), sums[4].x()
    );
}
