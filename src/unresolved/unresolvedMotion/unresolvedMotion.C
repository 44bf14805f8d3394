// SPDX-License-Identifier: GPL-3.0-or-later

#include "unresolvedMotion.H"
#include "mathematicalConstants.H"
#include "selfDisturbance.H"

using Foam::constant::mathematical::pi;


namespace
{

//- A speed [m/s] that has no direction
const Foam::scalar tiny = 1e-100;

//- Most iterations of drag and lift by shape
const Foam::label maxShape = 50;

} // End anonymous namespace


Foam::unresolvedMotion::unresolvedMotion
(
    const dragModel& drag,
    const fluidSample& fluid,
    const immersedBody& body,
    const shapeModel& shape,
    const ddtCoefficients& ddt,
    const vector& g,
    const vector& meshU,
    const vector& fluctuation,
    const PtrList<liftModel>& lifts,
    const densePart& dense
)
:
    drag_(drag),
    fluid_(fluid),
    shape_(shape),
    V_(body.volume()),
    D_(cbrt(6*V_/pi)),
    R_(body.state().orientation.R()),
    direction_(Zero),
    void_(1),
    pressure_(Zero),
    response_(dense.active ? 0 : fluid.crowd()/ddt.c),
    oldLoad_(body.fluid().load().linear),
    lift_(Zero)
{
    const scalar own = V_*fluid.selfKernel();
    const scalar others = max(fluid.fraction() - own, 0);

    alone_ = max(1 - others/own, 0);

    phi_ = min(others + (1 - alone_)*own, dense.maxFraction);

    if (fluid.crowd() == 0)
    {
        alone_ = 0;
    }

    const tensor grad(fluid.gradient());

    u_ = fluid.velocity(grad);
    torque_.spin = 0.5*vector
    (
        grad.yz() - grad.zy(), grad.zx() - grad.xz(), grad.xy() - grad.yx()
    );
    DuDt_ = acceleration(grad, u_ + fluctuation - body.state().U, u_ - meshU);
    u_ += fluctuation;

    if (dense.active)
    {
        void_ = 1 - phi_;
        pressure_ = dense.pressure - DuDt_;
    }

    vector W(slip(body, ddt, g, lift_));

    for (const liftModel& lift : lifts)
    {
        lift_ += lift.force
        (
            W, 2*torque_.spin, body.state().omega, D_, fluid.nu()
        );
    }
    if (lifts.size())
    {
        W = slip(body, ddt, g, lift_);
    }
    if (!shape_.isotropic())
    {
        W = balanceShape(body, ddt, g, W);
    }
    setTorque(W, grad);

    const scalar s = mag(W);
    const scalar b = this->drag(s);

    slip_ = W;
    b_ = b/seen(b, s);
}


Foam::vector Foam::unresolvedMotion::balanceShape
(
    const immersedBody& body,
    const ddtCoefficients& ddt,
    const vector& g,
    vector W
)
{
    const vector others(lift_);

    for (label i = 0; i < maxShape; ++i)
    {
        const vector F(others + shapeLift(W));
        const scalar scale = mag(F) + sphereDrag(mag(W))*mag(W);
        const bool done = mag(F - lift_) <= 1e-12*scale;

        lift_ = F;
        W = slip(body, ddt, g, lift_);

        if (done)
        {
            break;
        }
    }

    return W;
}


Foam::vector Foam::unresolvedMotion::slip
(
    const immersedBody& body,
    const ddtCoefficients& ddt,
    const vector& g,
    const vector& lift
)
{
    // Slip if there were no drag, and how much of it a drag takes
    const vector dUdt(body.motion().acceleration(ddt).linear);
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
          + V_*pressure_
        );

        U += (rest/mass - dUdt)/ddt.c;
        P = 1.5*(rest/(r + 0.5) - V_*DuDt_) - lift;
        k = (1/V_ + (r - 1)*response_*ddt.c)/(ddt.c*(r + 0.5));
    }

    const vector a(u_ + response_*(P - oldLoad_) - U);

    const scalar speed = mag(a);

    // None where the square of the slip is too small for a number
    direction_ = speed > tiny ? (R_.T() & a)/speed : vector::zero;

    return solveSlip(speed, k)/max(speed, VSMALL)*a;
}


Foam::scalar Foam::unresolvedMotion::sphereDrag(const scalar s) const
{
    const scalar nu = fluid_.nu();

    return 3*pi*nu*D_*drag_.K(void_*s*D_/nu, phi_)*sqr(void_);
}


Foam::scalar Foam::unresolvedMotion::drag(const scalar s) const
{
    const scalar Re = s*D_/fluid_.nu();
    const vector& e = direction_;

    // Any direction does if there is no slip
    const vector d(magSqr(e) > 0.5 ? e : vector(1, 0, 0));

    return sphereDrag(s)*(shape_.force(Re, d) & d);
}


Foam::vector Foam::unresolvedMotion::shapeLift(const vector& W) const
{
    const scalar s = mag(W);
    const vector& e = direction_;
    const vector f(shape_.force(s*D_/fluid_.nu(), e));

    return sphereDrag(s)*s*(R_ & (f - (f & e)*e));
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
