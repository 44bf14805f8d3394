// SPDX-License-Identifier: GPL-3.0-or-later

#include "fusedKernels.H"
#include "debug.H"
#include "IOstreams.H"
#include "registerSwitch.H"

int Foam::fusedKernels::active
(
    Foam::debug::optimisationSwitch("fusedKernels", 1)
);

registerOptSwitch("fusedKernels", int, Foam::fusedKernels::active);
