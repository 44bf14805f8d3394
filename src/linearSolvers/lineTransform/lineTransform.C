// SPDX-License-Identifier: GPL-3.0-or-later

#include "lineTransform.H"

Foam::lineTransform::lineTransform
(
    const label n,
    const label inner,
    const label outer
)
:
    n_(n),
    inner_(inner),
    outer_(outer)
{}
