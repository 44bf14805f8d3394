// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBody.H"
#include "checkKeywords.H"

Foam::immersedBody::immersedBody
(
    const word& name,
    const dictionary& dict,
    const std::shared_ptr<const bodyShape>& shape,
    const geometricSpace& space,
    const point& position,
    const scalar rho,
    const quaternion& orientation
)
:
    name_(name),
    number_(0),
    shape_(shape),
    space_(space),
    densityRatio_(1),
    freeU_(space.translation()),
    freeOmega_(space.rotation()),
    mirrored_(Zero),
    fixed_(false),
    material_(dict.lookupOrDefault("material", word::null)),
    resolved_(true),
    startPosition_(space.inPlane(position)),
    startOrientation_(orientation),
    time_(0),
    deltaT_(0),
    meshShift_(Zero),
    asleep_(false),
    ambientU_(false),
    ambientOmega_(false),
    wrapped_(Zero),
    addedMass_(0),
    contactForce_{Zero, Zero},
    load_{Zero, Zero},
    oldLoad_{Zero, Zero},
    ddtMomentum_{Zero, Zero}
{
    state_.position = space.inPlane(position);
    state_.orientation = orientation;

    readMotion(dict);
    readCoupling(dict);
    readDensity(dict, rho);
    restraints_ = bodyRestraint::readList(dict, space, rho, isFree());
    restart();
}


void Foam::immersedBody::hold()
{
    fixed_ = true;
    freeU_ = freeOmega_ = Zero;
    prescribed_.reset();
    state_.U = state_.omega = Zero;
    restart();
}


void Foam::immersedBody::setAsleep(const bool asleep)
{
    asleep_ = asleep;

    if (asleep)
    {
        state_.U = state_.omega = Zero;
        restart();
    }
}


void Foam::immersedBody::enter(const point& position, const bool ambient)
{
    passing_.clear();
    ambientU_ = ambientOmega_ = ambient;
    state_.position = space_.inPlane(position);
    restart();
}


void Foam::immersedBody::restart()
{
    old_ = oldOld_ = state_;
    trendU_ = trendOmega_ = velocityTrend();
    contactU_ = contactOmega_ = oldContactU_ = oldContactOmega_ = Zero;
    contactForce_ = rigidMomentum{Zero, Zero};
}


bool Foam::immersedBody::isFree() const
{
    return
        (passing_.empty() || !resolved_) && !asleep_
     && (cmptMax(freeU_) > 0 || cmptMax(freeOmega_) > 0);
}


bool Foam::immersedBody::tumbles() const
{
    return
        !resolved_ && !shape_->round() && isFree()
     && cmptMin(freeOmega_) > 0.5;
}


bool Foam::immersedBody::isFixed() const
{
    return fixed_
     || (
            !isFree() && !prescribed_
         && state_.U == vector::zero && state_.omega == vector::zero
        );
}


Foam::tensor Foam::immersedBody::inertia(const bodyState& state) const
{
    // The same in all orientations, in which it can be
    if (shape_->round())
    {
        return tensor(space_.depth()*shape_->inertia());
    }

    const tensor R(state.orientation.R());

    return (R & tensor(space_.depth()*shape_->inertia()) & R.T());
}


Foam::pointField Foam::immersedBody::inBody(const UList<point>& x) const
{
    pointField X(x.size());

    if (shape_->round())
    {
        // However it has turned
        forAll(x, i)
        {
            X[i] = x[i] - state_.position;
        }
        return X;
    }

    const tensor toBody(state_.orientation.R().T());

    forAll(x, i)
    {
        X[i] = toBody & (x[i] - state_.position);
    }

    return X;
}


void Foam::immersedBody::distance
(
    const UList<point>& x,
    UList<scalar>& d
) const
{
    shape_->distance(inBody(x), d);
}


void Foam::immersedBody::normal(const UList<point>& x, UList<vector>& n) const
{
    shape_->normal(inBody(x), n);

    if (shape_->round())
    {
        return;
    }

    const tensor R(state_.orientation.R());

    forAll(n, i)
    {
        n[i] = R & n[i];
    }
}


Foam::scalar Foam::immersedBody::distance(const point& x) const
{
    return shape_->distance
    (
        state_.orientation.R().T() & (x - state_.position)
    );
}


Foam::scalar Foam::immersedBody::maxSpeed(const vector& meshU) const
{
    return mag(state_.U - meshU) + shape_->boundingRadius()*mag(state_.omega);
}
