// SPDX-License-Identifier: GPL-3.0-or-later

#include "comovingDerivative.H"
#include "bodyShare.H"
#include "LeesEdwardsPolyPatch.H"
#include "surfaceDisplacement.H"

namespace
{
    //- Around bodies of many cells the frame reaches farther than the band, as
    //  it is for the shear layers: to a part of the width, within so many cells
    const Foam::scalar partOfWidth = 0.4;
    const Foam::scalar maxReach = 6.4;

    //- Component of a displacement over the body's width that is none
    const Foam::scalar still = 1e-7;

    //- V h/nu up to which a body has no frame, and from which on all of it
    const Foam::scalar slow = 0.1;
    const Foam::scalar fast = 0.25;


    //- Upper bounds of the displacements of a body's points between two states
    Foam::vector farthest
    (
        const Foam::immersedBody& body,
        const Foam::bodyState& before,
        const Foam::bodyState& after
    )
    {
        return Foam::surfaceDisplacement(body, before, after)
            .bound(body.shape().boundingRadius());
    }
}


Foam::scalar Foam::comovingDerivative::farthestReach(const immersedBody& body)
{
    return partOfWidth*body.shape().width();
}


Foam::comovingDerivative::comovingDerivative
(
    const fvMesh& mesh,
    const cellNeighbours& neighbours
)
:
    mesh_(mesh),
    neighbours_(neighbours),
    remaps_(mesh, neighbours),
    remap_(nullptr),
    ddt_("Euler", 1, 1),
    active_(false),
    onSliding_(mesh.nFaces())
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<LeesEdwardsPolyPatch>(patch))
        {
            onSliding_.set(labelRange(patch.start(), patch.size()));
        }
    }
}


Foam::scalar Foam::comovingDerivative::partOf
(
    const immersedBody& body,
    const vector& slide,
    const scalar h,
    const scalar nu
) const
{
    if (!body.resolved())
    {
        return 0;
    }

    // In the last time step, as iterations change that in this one; but in the
    // first in which it moves there is no other
    const bodyMotion& motion = body.motion();
    const vector last(farthest(body, motion.oldOld(), motion.old()));
    const vector V
    (
        mag(last) > 0
      ? last/mesh_.time().deltaT0Value()
      : farthest(body, motion.old(), motion.now())
       /mesh_.time().deltaTValue()
    );

    return min(max((mag(V + cmptMag(slide))*h/nu - slow)/(fast - slow), 0), 1);
}


void Foam::comovingDerivative::findMoving
(
    const PtrList<bodyRegion>& regions,
    const bodyList& bodies,
    const periodicity& periods,
    const UList<scalar>& h,
    const scalar nu
)
{
    bool moving[3] = {false, false, false};

    // The same on all processors, whatever images these have
    forAll(bodies, bodyi)
    {
        const immersedBody& body = bodies[bodyi];
        const vector& slide = periods.slideVelocity();
        const vector far
        (
            max
            (
                farthest(body, body.motion().old(), body.state()),
                farthest(body, body.motion().oldOld(), body.state())
            )
          + mesh_.time().deltaTValue()*cmptMag(slide)
        );
        const bool moves = partOf(body, slide, h[bodyi], nu) > 0;

        for (direction k = 0; k < 3 && moves; ++k)
        {
            moving[k] = moving[k] || far[k] > still*body.shape().width();
        }
    }

    components_.clear();
    for (direction k = 0; k < 3; ++k)
    {
        if (bodies.share().any(moving[k]))
        {
            components_.append(k);
        }
    }
    active_ = !components_.empty();

    parts_.resize(regions.size());

    forAll(regions, i)
    {
        const label bodyi = regions[i].body();

        parts_[i] = partOf
        (
            bodies[bodyi], regions[i].slideVelocity(), h[bodyi], nu
        );
    }
}


void Foam::comovingDerivative::update
(
    const PtrList<bodyRegion>& regions,
    const bodyList& bodies,
    const cellSearch& search,
    const UList<scalar>& h,
    const scalar bandWidth,
    const periodicity& periods,
    const scalar nu,
    const ddtCoefficients& ddt
)
{
    UIndirectList<label>(faceAt_, faces_) = -1;
    faces_.clear();
    s0_.clear();
    s00_.clear();
    weight_.clear();
    ddt_ = ddt;

    findMoving(regions, bodies, periods, h, nu);

    if (!active_)
    {
        return;
    }

    faceAt_.resize(mesh_.nFaces(), -1);
    near_.resize(bodies.size());

    forAll(regions, i)
    {
        const label bodyi = regions[i].body();

        if (parts_[i] > 0)
        {
            const immersedBody& body = bodies[bodyi];
            const scalar end = periods.active()
              ? 0
              : min(farthestReach(body)/h[bodyi], maxReach);

            if (end > bandWidth)
            {
                addFarther(i, regions[i], body, search, h[bodyi], end);
            }
            else
            {
                addBand(i, regions[i], body, bandWidth, false);
            }
        }
    }
    forAll(regions, i)
    {
        if (!(parts_[i] > 0))
        {
            addBand(i, regions[i], bodies[regions[i].body()], bandWidth, true);
        }
    }

    forAll(faces_, i)
    {
        s0_[i] /= weight_[i];
        s00_[i] /= weight_[i];
    }

    // Images that slide may be nowhere in the mesh
    active_ = returnReduce(!faces_.empty(), orOp<bool>());

    if (active_)
    {
        remap_ = &remaps_.select(faces_);
    }
}
