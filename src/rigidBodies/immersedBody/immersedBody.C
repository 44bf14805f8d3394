// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBody.H"

namespace
{

//- State at the start
Foam::bodyState startOf
(
    const Foam::bodyKind& kind,
    const Foam::point& position,
    const Foam::quaternion& orientation
)
{
    Foam::bodyState state;

    state.position = kind.space().inPlane(position);
    state.orientation = orientation;
    state.U = kind.U();
    state.omega = kind.omega();

    return state;
}

} // End anonymous namespace


Foam::immersedBody::immersedBody
(
    const word& name,
    const std::shared_ptr<const bodyKind>& kind,
    const point& position,
    const quaternion& orientation,
    const std::shared_ptr<const bodyOrigin>& origin
)
:
    kind_(kind),
    number_(0),
    status_(kind->freedom(), kind->fixed()),
    ambientU_(kind->ambientU()),
    ambientOmega_(kind->ambientOmega()),
    motion_(startOf(*kind, position, orientation)),
    restrained_
    (
        kind->restrained() ? 1 : 0, Foam::restrainedMotion(motion_.now())
    ),
    name_(name),
    origin_(origin)
{}


void Foam::immersedBody::hold()
{
    status_.fix();
    motion_.stop();
    restart();
}


void Foam::immersedBody::setAsleep(const bool asleep)
{
    status_.setAsleep(asleep);

    if (asleep)
    {
        motion_.stop();
        restart();
    }
}


void Foam::immersedBody::enter(const point& position, const bool ambient)
{
    status_.pass(word::null);
    ambientU_ = ambientOmega_ = ambient;
    motion_.now().position = kind_->space().inPlane(position);
    restart();
}


void Foam::immersedBody::restart()
{
    motion_.restart();
    contact_.restart();
}


bool Foam::immersedBody::isFixed() const
{
    return
        status_.fixed()
     || (!isFree() && !isPrescribed() && motion_.now().still());
}


Foam::scalar Foam::immersedBody::maxSpeed(const vector& meshU) const
{
    return mag(state().U - meshU)
      + shape().boundingRadius()*mag(state().omega);
}
