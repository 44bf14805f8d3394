// SPDX-License-Identifier: GPL-3.0-or-later

#include "grainTorque.H"

void Foam::grainTorque::addTo
(
    const immersedBody& body,
    const ddtCoefficients& ddt,
    bodyLoad& load
) const
{
    const bodyState& state = body.state();
    const tensor I(body.inertia(state));

    load.torque =
        body.ddtMomentum(ddt).angular - torque
      - (turning & (spin - state.omega));
    load.aRowCol =
        ddt.c*(0.5*tr(I)*tensor::I - I)
      + 0.5*tr(turning)*tensor::I - turning;
    load.volume = body.volume();
}


Foam::bodyLoad Foam::grainTorque::load
(
    const immersedBody& body,
    const ddtCoefficients& ddt,
    const vector& F
) const
{
    bodyLoad load;

    load.force = body.ddtMomentum(ddt).linear - F;
    load.a = body.volume()*ddt.c;
    addTo(body, ddt, load);

    return load;
}
