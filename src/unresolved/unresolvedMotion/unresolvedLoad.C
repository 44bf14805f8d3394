// SPDX-License-Identifier: GPL-3.0-or-later

#include "unresolvedMotion.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;


void Foam::unresolvedMotion::setTorque(const vector& W, const tensor& grad)
{
    const scalar nu = fluid_.nu();
    const scalar sphere = pi*nu*pow3(D_);
    const vector t(shape_.turning());
    const symmTensor E(symm(R_.T() & grad & R_));

    torque_.turning =
        sphere*(R_ & tensor(t.x(), 0, 0, 0, t.y(), 0, 0, 0, t.z()) & R_.T());
    torque_.torque =
        R_
      & (
            sphere*shape_.straining(E)
          + shape_.pitching(R_.T() & W, D_, nu)
        );
}


Foam::bodyLoad Foam::unresolvedMotion::load
(
    const immersedBody& body,
    const ddtCoefficients& ddt
) const
{
    const rigidMomentum rate(body.ddtMomentum(ddt));
    const scalar implicit = 1/(1 + response_*b_);
    bodyLoad load;

    load.force = implicit
       *(
            1.5*(rate.linear - V_*DuDt_)
          - lift_
          - b_*(u_ - response_*oldLoad_ - body.state().U)
        );
    load.a = implicit*(1.5*V_*ddt.c + b_);
    torque_.addTo(body, ddt, load);

    return load;
}
