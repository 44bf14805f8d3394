// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyEquation.H"
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

} // End anonymous namespace


Foam::rigidMomentum Foam::bodyEquation::residual(const vector& g) const
{
    const scalar r = body_.densityRatio() - 1;

    return
        r*body_.fluid().ddtMomentum()
      + rigidMomentum
        {
            load_.force - r*body_.volume()*g,
            load_.torque
        }
      - body_.contactTerm(ddt_);
}


Foam::scalarSquareMatrix Foam::bodyEquation::jacobian
(
    const scalar addedMass
) const
{
    // The fluid inside is in the load already, hence r - 1. The projection adds
    // to the response of the momentum equation (added mass), without which the
    // step of a light body would be too long: half of that of a disc. It adds
    // nothing to that of a turning disc or sphere; a tenth is for the response,
    // which is the inertia inside to some per cent only.
    // The response of an unresolved body is complete.
    const scalar r = body_.densityRatio();
    const scalar lightness = body_.resolved() ? max(1 - r, 0) : 0;
    const tensor I(body_.inertia(body_.state()));
    scalarSquareMatrix J(load_.block());

    const scalar mass =
        ddt_.c*body_.volume()*(r - 1 + max(addedMass, 0.5*lightness));
    const scalar inertiaRatio = ddt_.c*(r - 1 + 0.1*lightness);

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


void Foam::bodyEquation::addRestraints
(
    rigidMomentum& residual,
    scalarSquareMatrix& J
) const
{
    const bodyRestraint::motion motion(body_.restrainedMotion());
    rigidMomentum load{Zero, Zero};

    for (const bodyRestraint& restraint : body_.kind().restraints())
    {
        restraint.addLoad(motion, load);
        restraint.addResponse(motion, J);
    }

    residual = residual - load;
}


Foam::rigidMomentum Foam::bodyEquation::changeCoupled
(
    rigidMomentum residual,
    const scalar addedMass
) const
{
    const bodyFreedom& free = body_.status().freedom();
    scalarSquareMatrix J(jacobian(addedMass));

    if (body_.kind().restrained())
    {
        addRestraints(residual, J);
    }

    scalarField change(6);

    for (direction k = 0; k < 3; ++k)
    {
        change[k] = -residual.linear[k];
        change[3 + k] = -residual.angular[k];
    }
    for (direction k = 0; k < 3; ++k)
    {
        if (!free.U(k)) lock(J, change, k);
        if (!free.omega(k)) lock(J, change, 3 + k);
    }

    LUsolve(J, change);

    return rigidMomentum
    {
        vector(change[0], change[1], change[2]),
        vector(change[3], change[4], change[5])
    };
}


Foam::rigidMomentum Foam::bodyEquation::changeApart
(
    const rigidMomentum& residual
) const
{
    const bodyFreedom& free = body_.status().freedom();
    const scalar r = body_.densityRatio() - 1;
    tensor J
    (
        tr(load_.aRowCol)*tensor::I - load_.aRowCol.T()
      + ddt_.c*r*body_.inertia(body_.state())
    );
    vector torque(residual.angular);

    for (direction k = 0; k < 3; ++k)
    {
        if (!free.omega(k))
        {
            for (direction l = 0; l < 3; ++l)
            {
                J(k, l) = J(l, k) = 0;
            }
            J(k, k) = 1;
            torque[k] = 0;
        }
    }

    return rigidMomentum
    {
        cmptMultiply
        (
            free.U(), residual.linear/-(load_.a + ddt_.c*r*body_.volume())
        ),
       -(inv(J) & torque)
    };
}


Foam::rigidMomentum Foam::bodyEquation::change
(
    const vector& g,
    const scalar addedMass
) const
{
    // Velocity and spin of an unresolved body do not respond to each other
    const bool apart = !body_.resolved() && !body_.kind().restrained();

    return apart
      ? changeApart(residual(g))
      : changeCoupled(residual(g), addedMass);
}


Foam::addedInertia Foam::bodyEquation::viscousInertia() const
{
    const vector turns(body_.kind().space().rotation());
    const tensor I(body_.inertia(body_.state()));
    const tensor response(tr(load_.aRowCol)*tensor::I - load_.aRowCol.T());
    scalar sum = 0, inertia = 0;

    for (direction k = 0; k < 3; ++k)
    {
        sum += turns[k]*response(k, k);
        inertia += turns[k]*I(k, k);
    }

    return addedInertia
    {
        max(load_.a/(ddt_.c*body_.volume()) - 1, 0),
        max(sum/(ddt_.c*inertia) - 1, 0)
    };
}


Foam::scalar Foam::bodyEquation::heldChange(const rigidMomentum& change) const
{
    const bodyState& now = body_.state();
    const bodyState& old = body_.motion().old();
    const bodyFreedom& free = body_.status().freedom();
    const vector translation(body_.kind().space().translation());
    const vector rotation(body_.kind().space().rotation());
    vector force(change.linear);
    vector torque(change.angular);

    // None where it is at rest
    const bool moves = now.U != vector::zero || old.U != vector::zero;
    const bool turns = now.omega != vector::zero || old.omega != vector::zero;

    for (direction k = 0; k < 3; ++k)
    {
        force[k] *= moves && !free.U(k) ? translation[k] : 0;
        torque[k] *= turns && !free.omega(k) ? rotation[k] : 0;
    }

    const tensor I(body_.inertia(now));

    return mag(force)/(ddt_.c*body_.volume())
      + 3*body_.shape().boundingRadius()*mag(torque)/(ddt_.c*tr(I));
}
