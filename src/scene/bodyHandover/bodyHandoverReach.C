// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyHandover.H"
#include "comovingDerivative.H"

namespace
{

//- What a body may go in a time step beyond twice that of the fastest, as far
//  as contact looks, over the largest radius
const Foam::scalar spareWay = 0.25;

} // End anonymous namespace


Foam::scalar Foam::bodyHandover::reach(const immersedBody& body) const
{
    // It may become the other
    const bool both = choice_.type(body) == "auto";
    scalar most = 0;

    if (both || !body.resolved())
    {
        most = kernels_.radius(body, search_.hMax());
    }
    if (both || body.resolved())
    {
        const scalar R = body.shape().boundingRadius();
        const scalar band = bodyRegion::reach
        (
            body, region_.resistance().bandWidth(), search_.hMax()
        );
        const scalar around = max
        (
            comovingDerivative::farthestReach(body), 2*widthsAround_*R
        );

        // Faces belong to cells on both sides
        most = max(most, search_.hMax() + max(band, R + around));
    }

    return most;
}


void Foam::bodyHandover::setWay(const scalar dt, const labelUList& owners)
{
    // One that is hit may go as far as the fastest, and images go on with what
    // slides
    const scalar speed = returnReduce(bodies_.maxSpeed(), maxOp<scalar>());

    // Of one that leaves the mesh the centre is outside
    outside_ = maxRadius_ = 0;

    forAll(owners, i)
    {
        if (owners[i] >= 0)
        {
            const point& x = bodies_[i].state().position;

            outside_ = max(outside_, bounds_.distance(owners[i], x));
            maxRadius_ = max(maxRadius_, bodies_[i].shape().boundingRadius());
        }
    }
    reduce(outside_, maxOp<scalar>());
    reduce(maxRadius_, maxOp<scalar>());

    share_.setWay
    (
        spareWay*maxRadius_ + dt*(2*speed + mag(periods_.slideVelocity()))
    );
}


Foam::labelList Foam::bodyHandover::holders
(
    const label bodyi,
    const point& x,
    const label owner
) const
{
    // Kernels grow where cells do
    const immersedBody& body = bodies_[bodyi];
    const scalar touching =
        body.shape().boundingRadius() + maxRadius_ + 2*share_.way()
      + max(search_.hMax(), outside_) + wallMargin_;
    labelList ranks
    (
        bounds_.reached(x, max(reach(body) + share_.way(), touching), periods_)
    );

    if (!ranks.found(owner))
    {
        ranks.append(owner);
        Foam::sort(ranks);
    }

    return ranks;
}
