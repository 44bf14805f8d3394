// SPDX-License-Identifier: GPL-3.0-or-later

#include "unresolvedMotion.H"
#include "mathematicalConstants.H"
#include "selfDisturbance.H"
#include "sphericity.H"

using Foam::constant::mathematical::pi;


Foam::unresolvedMotion::unresolvedMotion
(
    const dragModel& drag,
    const fluidSample& fluid,
    const immersedBody& body,
    const scalar psi,
    const ddtCoefficients& ddt,
    const vector& g,
    const vector& meshU,
    const vector& fluctuation,
    const PtrList<liftModel>& lifts
)
:
    drag_(drag),
    fluid_(fluid),
    V_(body.volume()),
    D_(cbrt(6*V_/pi)),
    psi_(psi),
    response_(fluid.crowd()/ddt.c),
    oldLoad_(body.load().force),
    lift_(Zero)
{
    const scalar own = V_*fluid.selfKernel();
    const scalar others = max(fluid.fraction() - own, 0);

    alone_ = max(1 - others/own, 0);

    // Packed as densely as spheres can be by chance, at most
    phi_ = min(others + (1 - alone_)*own, 0.64);

    if (fluid.crowd() == 0)
    {
        alone_ = 0;
    }

    const tensor grad(fluid.gradient());

    u_ = fluid.velocity(grad);
    spin_ = 0.5*vector
    (
        grad.yz() - grad.zy(), grad.zx() - grad.xz(), grad.xy() - grad.yx()
    );
    DuDt_ = acceleration(grad, u_ + fluctuation - body.state().U, u_ - meshU);
    u_ += fluctuation;

    vector W(slip(body, ddt, g, lift_));

    for (const liftModel& lift : lifts)
    {
        lift_ += lift.force(W, 2*spin_, body.state().omega, D_, fluid.nu());
    }
    if (lifts.size())
    {
        W = slip(body, ddt, g, lift_);
    }

    const scalar s = mag(W);
    const scalar b = this->drag(s);

    b_ = b/seen(b, s);
}


Foam::vector Foam::unresolvedMotion::slip
(
    const immersedBody& body,
    const ddtCoefficients& ddt,
    const vector& g,
    const vector& lift
) const
{
    // Slip if there were no drag, and how much of it a drag takes
    const vector dUdt(body.acceleration(ddt).linear);
    const scalar r = body.densityRatio();
    vector P(1.5*V_*(dUdt - DuDt_) - lift);
    vector U(body.state().U);
    scalar k = response_;

    if (body.isFree())
    {
        const scalar mass = (r + 0.5)*V_;
        const vector rest
        (
            1.5*V_*DuDt_ + (r - 1)*V_*g + body.contactTerm(ddt).linear + lift
        );

        U += (rest/mass - dUdt)/ddt.c;
        P = 1.5*(rest/(r + 0.5) - V_*DuDt_) - lift;
        k = (1/V_ + (r - 1)*response_*ddt.c)/(ddt.c*(r + 0.5));
    }

    const vector a(u_ + response_*(P - oldLoad_) - U);

    return solveSlip(mag(a), k)/max(mag(a), VSMALL)*a;
}


Foam::scalar Foam::unresolvedMotion::drag(const scalar s) const
{
    const scalar nu = fluid_.nu();
    const scalar Re = s*D_/nu;

    return
        3*pi*nu*D_*drag_.K(Re, phi_)*sphericity(psi_).factor(Re);
}


Foam::scalar Foam::unresolvedMotion::disturbance(const scalar s) const
{
    const scalar nu = fluid_.nuEff();
    const scalar width = selfDisturbance::width(fluid_.selfKernel());

    return
        alone_*selfDisturbance::velocity(s*width/nu)
       /(6*pi*sqrt(pi)*nu*width);
}


Foam::scalar Foam::unresolvedMotion::seen
(
    const scalar b,
    const scalar s
) const
{
    // A kernel that is too narrow for more of it sees no slip at all
    return max(1 - b*disturbance(s), 0.5);
}


Foam::vector Foam::unresolvedMotion::acceleration
(
    const tensor& grad,
    const vector& slip,
    const vector& through
) const
{
    const scalar width = selfDisturbance::width(fluid_.selfKernel());
    const scalar own =
        2.0/3.0*alone_*fluid_.selfKernel()
       *selfDisturbance::acceleration(mag(slip)*width/fluid_.nuEff());

    return fluid_.localAcceleration() + (through & grad) - own*oldLoad_;
}


Foam::scalar Foam::unresolvedMotion::solveSlip
(
    const scalar a,
    const scalar k
) const
{
    auto excess = [&](const scalar s)
    {
        const scalar b = drag(s);

        return s*(seen(b, s) + k*b) - a;
    };

    // Newton's method from above, where the function is convex; the drag law
    // may jump by a per cent
    scalar s = a;

    for (label i = 0; i < 20 && s > VSMALL; ++i)
    {
        const scalar step = 1e-4*s;
        const scalar f = excess(s);
        const scalar slope = (excess(s + step) - f)/step;
        const scalar next = max(s - f/max(slope, SMALL), 0.01*s);
        const bool done = mag(next - s) < 1e-10*s;

        s = next;
        if (done)
        {
            break;
        }
    }

    return s;
}


Foam::bodyLoad Foam::unresolvedMotion::load
(
    const immersedBody& body,
    const ddtCoefficients& ddt
) const
{
    const bodyState& state = body.state();
    const rigidMomentum rate(body.ddtMomentum(ddt));
    const tensor I(body.inertia(state));
    const scalar implicit = 1/(1 + response_*b_);
    const scalar turning = pi*fluid_.nu()*pow3(D_);
    bodyLoad load;

    load.force = implicit
       *(
            1.5*(rate.linear - V_*DuDt_)
          - lift_
          - b_*(u_ - response_*oldLoad_ - state.U)
        );
    load.torque = rate.angular - turning*(spin_ - state.omega);

    load.a = implicit*(1.5*V_*ddt.c + b_);
    load.aRowCol =
        ddt.c*(0.5*tr(I)*tensor::I - I) + 0.5*turning*tensor::I;
    load.volume = V_;

    return load;
}
