// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBody.H"

namespace
{

//- Take mode k out of the linear system: its unknown becomes zero
void lock(Foam::scalarSquareMatrix& A, Foam::scalarField& b, const int k)
{
    for (int l = 0; l < A.n(); ++l)
    {
        A(k, l) = 0;
        A(l, k) = 0;
    }
    A(k, k) = 1;
    b[k] = 0;
}


//- The change if it goes on as expected, otherwise, as in the transient of a
//  sudden start, nothing
Foam::vector trend(const Foam::vector& change, const Foam::vector& expected)
{
    return
        Foam::mag(change - expected) < 0.5*Foam::mag(change)
      ? change
      : Foam::vector::zero;
}

} // End anonymous namespace


void Foam::immersedBody::setAmbient(const vector& U, const vector& omega)
{
    if (ambientU_)
    {
        state_.U = cmptMultiply(U, space_.translation());
    }
    if (ambientOmega_)
    {
        state_.omega = cmptMultiply(omega, space_.rotation());
    }

    restart();
    ambientU_ = ambientOmega_ = false;
}


void Foam::immersedBody::prescribe(const scalar t)
{
    if (prescribed_)
    {
        state_.U = prescribed_->velocity(t);
        state_.omega = prescribed_->angularVelocity(t);
    }
}


void Foam::immersedBody::startPrescribed(const scalar t)
{
    if (prescribed_)
    {
        prescribe(t);
        restart();
    }
}


void Foam::immersedBody::beginStep(const scalar ratio)
{
    oldOld_ = old_;
    old_ = state_;

    fluidOldOld_ = fluidOld_;
    fluidOld_ = fluid_;

    if (isFree())
    {
        state_.U += ratio*trendU_;
        state_.omega += ratio*trendOmega_;
    }
}


void Foam::immersedBody::endStep(const scalar ratio)
{
    trendU_ = trend(state_.U - old_.U, ratio*(old_.U - oldOld_.U));
    trendOmega_ =
        trend(state_.omega - old_.omega, ratio*(old_.omega - oldOld_.omega));
}


void Foam::immersedBody::undoStep()
{
    state_ = old_;
    old_ = oldOld_;

    fluid_ = fluidOld_;
    fluidOld_ = fluidOldOld_;
}


void Foam::immersedBody::keepOnPlane(const vector& n)
{
    const vector axis(cmptMag(n));

    freeU_ = cmptMultiply(freeU_, vector::one - axis);
    freeOmega_ = cmptMultiply(freeOmega_, axis);
    mirrored_ = max(mirrored_, axis);
}


void Foam::immersedBody::predictPose
(
    const scalar dt,
    const vector& meshU
)
{
    state_.position = old_.position;
    state_.orientation = old_.orientation;
    state_.move
    (
        dt,
        0.5*(state_.U + old_.U) - meshU,
        0.5*(state_.omega + old_.omega)
    );
}


Foam::rigidMomentum
Foam::immersedBody::momentum(const bodyState& state) const
{
    return rigidMomentum{volume()*state.U, inertia(state) & state.omega};
}


Foam::rigidMomentum
Foam::immersedBody::fluidMomentum(const bodyLoad& load) const
{
    // Mean velocity and spin of the fluid, as cells cut by the surface do not
    // add up to volume and inertia exactly
    bodyState mean(state_);

    mean.U = load.fluidMomentum/load.volume;
    mean.omega = inv(load.inertia) & load.fluidSpin;

    return momentum(mean);
}


bool Foam::immersedBody::isLight
(
    const scalar response,
    const scalar ddtInertia
) const
{
    // Without the momentum of the fluid inside, time steps have been seen to
    // amplify spin where less than about 0.4 of the inertia is left (disc of
    // four cells, r = 0.5), or r is below 0.4 whatever is left
    return
        densityRatio_ < 0.45
     || response + (densityRatio_ - 1)*ddtInertia < 0.6*ddtInertia;
}


Foam::scalarSquareMatrix Foam::immersedBody::jacobian
(
    const bodyLoad& load,
    const scalar ddtCoeff
)
{
    // Added mass, which the projection adds to the response of the momentum
    // equation within a step: that of a disc, of a sphere
    const scalar addedMass = space_.twoD() ? 1 : 0.5;
    const tensor I(inertia(state_));
    scalarSquareMatrix J(load.block());

    // Fluid inside counts with the part of the motion imposed on it where its
    // own momentum is in the balance, else in full
    lightU_ = isLight(load.a, ddtCoeff*volume());

    const vector axes(space_.rotation());
    const vector response(J(3, 3), J(4, 4), J(5, 5));

    lightOmega_ = isLight(response & axes, ddtCoeff*tr(I));

    const scalar mass = ddtCoeff*volume()
       *(
            lightU_
          ? densityRatio_ - load.imposedVolume/load.volume + addedMass
          : densityRatio_ - 1
        );
    const scalar inertiaRatio = ddtCoeff
       *(
            lightOmega_
          ? densityRatio_ - load.imposedInertia/tr(load.inertia)
          : densityRatio_ - 1
        );

    for (direction k = 0; k < 3; ++k)
    {
        J(k, k) += mass;

        for (direction l = 0; l < 3; ++l)
        {
            J(3 + k, 3 + l) += inertiaRatio*I(k, l);
        }
    }

    return J;
}


Foam::scalar Foam::immersedBody::correctVelocity
(
    const bodyLoad& load,
    const ddtCoefficients& ddt,
    const vector& g
)
{
    load_ = load;

    for (direction k = 0; k < 3; ++k)
    {
        if (mirrored_[k] > 0.5)
        {
            load_.symmetrise(k);
        }
    }

    const rigidMomentum ddtBody
    (
        ddt(momentum(state_), momentum(old_), momentum(oldOld_))
    );

    ddtFluid_ = ddtBody;

    if (!isFree())
    {
        return 0;
    }

    fluid_ = fluidMomentum(load_);

    scalarSquareMatrix J(jacobian(load_, ddt.c));
    const rigidMomentum ddtInside(ddt(fluid_, fluidOld_, fluidOldOld_));

    if (lightU_)
    {
        ddtFluid_.linear = ddtInside.linear;
    }
    if (lightOmega_)
    {
        ddtFluid_.angular = ddtInside.angular;
    }

    const rigidMomentum residual
    (
        densityRatio_*ddtBody - ddtFluid_
      + rigidMomentum
        {
            load_.force - (densityRatio_ - 1)*volume()*g,
            load_.torque
        }
    );

    scalarField change(6);

    for (direction k = 0; k < 3; ++k)
    {
        change[k] = -residual.linear[k];
        change[3 + k] = -residual.angular[k];
    }
    for (direction k = 0; k < 3; ++k)
    {
        if (freeU_[k] < 0.5) lock(J, change, k);
        if (freeOmega_[k] < 0.5) lock(J, change, 3 + k);
    }

    LUsolve(J, change);

    const vector dU(change[0], change[1], change[2]);
    const vector dOmega(change[3], change[4], change[5]);

    state_.U += dU;
    state_.omega += dOmega;

    return mag(dU) + shape_->boundingRadius()*mag(dOmega);
}
