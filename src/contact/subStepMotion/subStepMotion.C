// SPDX-License-Identifier: GPL-3.0-or-later

#include "subStepMotion.H"

Foam::subStepMotion::subStepMotion
(
    contactMovers& movers,
    const PtrList<immersedBody>& bodies,
    contactClearance& clearance,
    const label n,
    const scalar dt,
    const vector& meshU,
    const bool films
)
:
    movers_(movers),
    bodies_(bodies),
    clearance_(clearance),
    n_(n),
    h_(dt/n),
    meshU_(meshU),
    accelerated_(films ? 0 : h_),
    step_(0),
    flights_(movers.size())
{
    clearance_.setSubSteps(n);
    clearance_.setSubStep(step_);

    forAll(movers_, i)
    {
        if (films || !movers_[i].round)
        {
            followed_.append(i);
        }
        else
        {
            takeOff(i);
        }
    }

    follow(1, 0);
}


void Foam::subStepMotion::takeOff(const label moveri)
{
    contactMover& m = movers_[moveri];
    flight& f = flights_[moveri];

    f.from = step_;
    f.omega = m.state.omega;
    f.rotation = 0.5*h_*f.omega;
    f.way = 0.5*h_*contactMovers::speed(m.state.U, meshU_);
    m.state.position += 0.5*h_*(m.state.U - meshU_);
    fly(moveri);
}


void Foam::subStepMotion::follow(const label halves, const scalar accelerated)
{
    const scalar time = 0.5*halves*h_;

    for (const label moveri : followed_)
    {
        contactMover& m = movers_[moveri];

        m.state.U += accelerated*m.acceleration;
        m.state.omega += accelerated*m.spinRate;
        m.drift(bodies_, halves, 0.5*h_, meshU_);

        const scalar speed = contactMovers::speed(m.state.U, meshU_);
        const scalar spin = m.round ? 0 : m.radius*mag(m.state.omega);

        m.way += time*speed;
        clearance_.setWay(moveri, m.way + m.turned, h_*(speed + spin));
    }
}


void Foam::subStepMotion::fly(const label moveri)
{
    flight& f = flights_[moveri];

    if (f.from < 0)
    {
        return;
    }

    const contactMover& m = movers_[moveri];
    const label k = step_ - f.from;
    const vector atEnd(m.state.U + (n_ - step_)*h_*m.acceleration);

    f.rotation += sum(k, f.omega, m.spinRate);
    f.way += k*f.perStep;
    f.from = f.now = step_;
    f.position = m.state.position;
    f.U = m.state.U;
    f.omega = m.state.omega;
    f.perStep = h_*max
    (
        contactMovers::speed(f.U, meshU_), contactMovers::speed(atEnd, meshU_)
    );
    clearance_.setWay(moveri, f.way, f.perStep);
}


void Foam::subStepMotion::land(const label moveri)
{
    const flight& f = flights_[moveri];

    if (f.from < 0)
    {
        return;
    }

    bring(moveri);

    contactMover& m = movers_[moveri];
    const label k = step_ - f.from;

    m.state.U += h_*m.acceleration;
    m.state.omega += h_*m.spinRate;
    m.way = f.way + (k + 0.5)*f.perStep;
    m.state.position += 0.5*h_*(m.state.U - meshU_);
    m.state.move
    (
        1, Zero,
        f.rotation + sum(k, f.omega, m.spinRate) + 0.5*h_*m.state.omega
    );
}


void Foam::subStepMotion::bringReceived()
{
    for (const label moveri : movers_.received())
    {
        bring(moveri);
    }
}


void Foam::subStepMotion::setVelocities
(
    const label moveri,
    const vector& U,
    const vector& omega
)
{
    contactMover& m = movers_[moveri];

    m.state.U = U;
    m.state.omega = omega;
    m.kicked = step_;
    kicked_.append(moveri);
}


void Foam::subStepMotion::goOn()
{
    for (const label moveri : kicked_)
    {
        fly(moveri);
    }
    for (const label moveri : movers_.received())
    {
        if (movers_[moveri].kicked == step_)
        {
            fly(moveri);
        }
    }
    kicked_.clear();
}


void Foam::subStepMotion::next()
{
    clearance_.setSubStep(++step_);
    follow(2, accelerated_);
}


void Foam::subStepMotion::end()
{
    follow(1, accelerated_);

    forAll(flights_, i)
    {
        land(i);
    }
}
