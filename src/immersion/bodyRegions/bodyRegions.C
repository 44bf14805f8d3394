// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyRegions.H"
#include "ListOps.H"
#include "pointGrid.H"

namespace
{
    //- The body itself
    const Foam::periodicity::image itself
    {
        Foam::Zero, Foam::Zero, Foam::Zero
    };
}


Foam::bodyRegions::bodyRegions(const periodicity& periods)
:
    periodicity_(periods)
{}


Foam::label Foam::bodyRegions::find
(
    const label bodyi,
    const periodicity::image& im
) const
{
    if (bodyi < ofBody_.size())
    {
        for (const label i : ofBody_[bodyi])
        {
            // set() takes them out one by one
            if (regions_.set(i) && regions_[i].isFor(bodyi, im))
            {
                return i;
            }
        }
    }

    return -1;
}


void Foam::bodyRegions::index()
{
    labelList of(regions_.size());
    label nBodies = 0;

    forAll(of, i)
    {
        of[i] = regions_[i].body();
        nBodies = max(nBodies, of[i] + 1);
    }

    ofBody_ = invertOneToMany(nBodies, of);
}


const Foam::bodyRegion& Foam::bodyRegions::operator[](const label bodyi) const
{
    const label i = find(bodyi, itself);

    if (i < 0)
    {
        FatalErrorInFunction
            << "There is no region of body " << bodyi << nl
            << abort(FatalError);
    }

    return regions_[i];
}


bool Foam::bodyRegions::complete(const PtrList<immersedBody>& bodies) const
{
    forAll(bodies, bodyi)
    {
        if (bodies[bodyi].resolved() != (find(bodyi, itself) >= 0))
        {
            return false;
        }
    }

    return true;
}


bool Foam::bodyRegions::same
(
    const UList<label>& of,
    const UList<periodicity::image>& images
) const
{
    forAll(of, i)
    {
        if (find(of[i], images[i]) < 0)
        {
            return false;
        }
    }

    return of.size() == regions_.size();
}


void Foam::bodyRegions::renumber(const labelUList& order)
{
    PtrList<bodyRegion> kept(regions_.size());
    label n = 0;

    forAll(order, bodyi)
    {
        if (order[bodyi] >= ofBody_.size())
        {
            continue;
        }
        for (const label i : ofBody_[order[bodyi]])
        {
            kept.set(n, regions_.release(i));
            kept[n++].renumber(bodyi);
        }
    }

    kept.resize(n);
    regions_.transfer(kept);
    index();
}


void Foam::bodyRegions::update
(
    const PtrList<immersedBody>& bodies,
    const scalar bandWidth,
    const bool again
)
{
    DynamicList<label> of;
    DynamicList<periodicity::image> images;
    DynamicList<point> x;

    const auto append = [&](const label bodyi, const periodicity::image& im)
    {
        of.append(bodyi);
        images.append(im);
        x.append(bodies[bodyi].state().position + im.shift);
    };

    forAll(bodies, bodyi)
    {
        const immersedBody& body = bodies[bodyi];

        if (!body.resolved())
        {
            continue;
        }

        append(bodyi, itself);

        if (!periodicity_.active())
        {
            continue;
        }

        for
        (
            const periodicity::image& im
          : periodicity_.localImages
            (
                body.state().position, bodyRegion::reach(body, bandWidth)
            )
        )
        {
            if (im.key != vector::zero)
            {
                append(bodyi, im);
            }
        }
    }

    if (!again || !same(of, images))
    {
        set(of, images, x);
    }

    for (label i = 0; i < of.size() && periodicity_.sliding(); ++i)
    {
        regions_[find(of[i], images[i])].slide(images[i]);
    }
}


void Foam::bodyRegions::set
(
    const UList<label>& of,
    const UList<periodicity::image>& images,
    const UList<point>& x
)
{
    PtrList<bodyRegion> regions(of.size());
    label n = 0;

    for (const label i : pointGrid::placeOrder(x))
    {
        const label old = find(of[i], images[i]);

        if (old >= 0)
        {
            regions.set(n++, regions_.release(old));
        }
        else
        {
            regions.set(n++, new bodyRegion(of[i], images[i]));
        }
    }

    regions_.transfer(regions);
    index();
}
