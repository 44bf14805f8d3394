// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "bodyContacts.H"
#include "bodyPassage.H"

void Foam::immersedBodies::refuseOutside(const immersedBody& body) const
{
    FatalIOErrorInFunction(dict_.subDict("bodies"))
        << "'position " << body.state().position << "' of body '"
        << body.name() << "' is outside the mesh, whose bounds are "
        << mesh_.bounds() << nl << exit(FatalIOError);
}


void Foam::immersedBodies::checkBounds() const
{
    const scalar hMax = region().search().hMax();

    for (const immersedBody& body : bodies_)
    {
        const point& x = body.state().position;
        const scalar reach = bodyRegion::reach
        (
            body, region().resistance().bandWidth(), hMax
        );

        if (mag(x - mesh_.bounds().nearest(x)) > hMax + reach)
        {
            refuseOutside(body);
        }
    }
}


void Foam::immersedBodies::checkInside() const
{
    const cellSearch& search = region().search();
    labelList found(bodies_.size(), 0);

    forAll(bodies_, bodyi)
    {
        found[bodyi] = search.findCell(bodies_[bodyi].state().position) >= 0;
    }

    // Or an image of it. A fixed one may be there in part, such as one that a
    // plane of symmetry cuts
    for (const bodyRegion& region : region().regions())
    {
        const label bodyi = region.body();
        const immersedBody& body = bodies_[bodyi];

        if
        (
            search.findCell(region.centre(body.state())) >= 0
         || (
                (body.isFixed() || body.status().passing().size())
             && !region.cells.empty()
            )
        )
        {
            found[bodyi] = 1;
        }
    }

    bodies_.share().combine(found, maxEqOp<label>());

    forAll(bodies_, bodyi)
    {
        if (!found[bodyi])
        {
            refuseOutside(bodies_[bodyi]);
        }
    }
}


void Foam::immersedBodies::checkSteady() const
{
    if (passage_->injects())
    {
        FatalIOErrorInFunction(dict_.subDict("steady"))
            << "'steady' is not for bodies that enter: remove 'injection'"
            << nl << exit(FatalIOError);
    }

    if (!moving_ || window_.comoving())
    {
        return;
    }

    for (const immersedBody& body : bodies_)
    {
        if (!body.isFixed())
        {
            FatalIOErrorInFunction(dict_.subDict("steady"))
                << "'steady' is for bodies that do not cross the mesh, and"
                << " body '" << body.name() << "' may: allowed are"
                << " 'motion { type fixed; }' for all bodies, or"
                << " 'window { type comoving; ... }'" << nl
                << exit(FatalIOError);
        }
    }
}


void Foam::immersedBodies::checkGaps()
{
    if (contacts_->overlap(bodies_, region(), h_))
    {
        FatalIOErrorInFunction(dict_.subOrEmptyDict("bodies"))
            << "'bodies' must not overlap each other or a wall"
            << (contacts_->active() ? " by that much: " : ": ")
            << contacts_->proximity().overlaps().c_str() << nl
            << exit(FatalIOError);
    }
}
