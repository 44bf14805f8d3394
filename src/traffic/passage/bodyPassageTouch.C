// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyPassage.H"
#include "bodyShare.H"
#include "contactPoint.H"

namespace
{

//- Does a body with this gap [m] to a patch touch it? One that has just been
//  put beside it may by rounding.
bool touches(const Foam::immersedBody& body, const Foam::scalar gap)
{
    return gap <= -1e-6*body.shape().boundingRadius();
}

} // End anonymous namespace


void Foam::bodyPassage::findTouched
(
    const bodyList& bodies,
    scalarField& gaps,
    labelList& patches
)
{
    scalarField smallest(gaps);
    const labelList all(identity(bodies.size()));

    bodies.share().combine(all, 1, smallest, minEqOp<scalar>());

    forAll(bodies, bodyi)
    {
        if (gaps[bodyi] > smallest[bodyi])
        {
            patches[bodyi] = -1;
        }
    }
    bodies.share().combine(all, 1, patches, maxEqOp<label>());
    gaps = smallest;
}


Foam::labelList Foam::bodyPassage::passed
(
    const bodyList& bodies,
    const UPtrList<const DynamicList<label>>& beside,
    const List<bodyLoad>& loads
) const
{
    scalarField gaps(bodies.size());
    labelList patches(bodies.size());
    bool any = false;

    forAll(bodies, bodyi)
    {
        gaps[bodyi] =
            open_->gap(bodies[bodyi], beside[bodyi], patches[bodyi]);
        any = any || touches(bodies[bodyi], gaps[bodyi])
         || bodies[bodyi].status().passing().size();
    }

    // Mostly none is near, nor on its way
    if (!returnReduce(any, orOp<bool>()))
    {
        return labelList(bodies.size(), label(AS_BEFORE));
    }
    findTouched(bodies, gaps, patches);

    forAll(bodies, bodyi)
    {
        const immersedBody& body = bodies[bodyi];

        // Not while the last of it is beyond the patch
        if (!touches(body, gaps[bodyi]))
        {
            patches[bodyi] =
                loads[bodyi].volume > 0.5*body.volume() ? NONE : AS_BEFORE;
        }
    }

    // Copies may know less of the load
    bodies.share().give(patches);

    return patches;
}


Foam::labelList Foam::bodyPassage::touch
(
    bodyList& bodies,
    const UPtrList<const DynamicList<label>>& beside,
    const List<bodyLoad>& loads
) const
{
    DynamicList<label> held;

    if (!leaving_.active())
    {
        return held;
    }

    const labelList patches(passed(bodies, beside, loads));

    forAll(patches, bodyi)
    {
        immersedBody& body = bodies[bodyi];
        const label patchi = patches[bodyi];

        if (body.isFixed() || patchi == AS_BEFORE)
        {
            continue;
        }
        if (patchi == NONE)
        {
            body.status().pass(word::null);
            continue;
        }

        const leavingRules::action what = leaving_[patchi].what;

        if (what != leavingRules::action::stop)
        {
            body.status().pass(mesh_.boundaryMesh()[patchi].name());
        }
        if (what == leavingRules::action::hold)
        {
            held.append(bodyi);
        }
    }

    return held;
}


bool Foam::bodyPassage::room
(
    const immersedBody& body,
    const UList<label>& beside,
    const bodyList& bodies,
    const scalar h,
    const scalar gap
) const
{
    const scalar wanted = max(gap, h);
    const scalar R = body.shape().boundingRadius();
    const point& x = body.state().position;
    bool free = true;

    for (label i = 0; i < bodies.size() && free; ++i)
    {
        const immersedBody& other = bodies[i];
        const scalar apart = mag(other.state().position - x);

        free = apart >= R + other.shape().boundingRadius() + wanted
         || contactPoint(body, other).gap >= wanted;
    }

    if (free)
    {
        // An open patch it may touch
        label patchi;

        free = closed_->gap(body, beside, patchi) >= wanted
         && open_->gap(body, beside, patchi) >= -1e-6*R;
    }

    return returnReduce(free, andOp<bool>());
}
