// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyRegions.H"

namespace
{

//- The region of a list for an image of a body, -1 if there is none
Foam::label findFor
(
    const Foam::PtrList<Foam::bodyRegion>& regions,
    const Foam::label bodyi,
    const Foam::periodicity::image& im
)
{
    forAll(regions, i)
    {
        if (regions.set(i) && regions[i].isFor(bodyi, im))
        {
            return i;
        }
    }

    return -1;
}

} // End anonymous namespace


Foam::bodyRegions::bodyRegions
(
    const periodicity& periods,
    const label nBodies
)
:
    periodicity_(periods),
    regions_(nBodies)
{
    forAll(regions_, bodyi)
    {
        regions_.set(bodyi, new bodyRegion(bodyi));
    }
}


void Foam::bodyRegions::add(const label bodyi)
{
    regions_.resize(regions_.size() + 1);

    // Before the images
    for (label i = regions_.size() - 1; i > bodyi; --i)
    {
        regions_.set(i, regions_.release(i - 1));
    }
    regions_.set(bodyi, new bodyRegion(bodyi));
}


void Foam::bodyRegions::remove(const label bodyi)
{
    PtrList<bodyRegion> others(regions_.size());
    label n = 0;

    forAll(regions_, i)
    {
        if (regions_[i].body() != bodyi)
        {
            others.set(n, regions_.release(i));
            others[n++].moveUp(bodyi);
        }
    }

    others.resize(n);
    regions_.transfer(others);
}


void Foam::bodyRegions::updateImages
(
    const PtrList<immersedBody>& bodies,
    const scalar bandWidth
)
{
    bool any = false;

    for (const immersedBody& body : bodies)
    {
        any = any || body.resolved();
    }

    if (!periodicity_.active() || !(any || regions_.size() > bodies.size()))
    {
        return;
    }

    // The bodies, then their images
    DynamicList<label> of(identity(bodies.size()));
    DynamicList<periodicity::image> images
    (
        bodies.size(), periodicity::image{Zero, Zero, Zero}
    );

    forAll(bodies, bodyi)
    {
        const immersedBody& body = bodies[bodyi];

        if (!body.resolved())
        {
            continue;
        }

        const scalar reach = bodyRegion::reach(body, bandWidth);

        for
        (
            const periodicity::image& im
          : periodicity_.localImages(body.state().position, reach)
        )
        {
            if (im.key != vector::zero)
            {
                of.append(bodyi);
                images.append(im);
            }
        }
    }

    set(of, images);
}


void Foam::bodyRegions::set
(
    const UList<label>& of,
    const UList<periodicity::image>& images
)
{
    bool same = of.size() == regions_.size();

    for (label i = 0; i < of.size() && same; ++i)
    {
        same = regions_[i].isFor(of[i], images[i]);
    }

    if (!same)
    {
        PtrList<bodyRegion> regions(of.size());

        forAll(regions, i)
        {
            const label oldi = findFor(regions_, of[i], images[i]);

            if (oldi >= 0)
            {
                regions.set(i, regions_.release(oldi));
            }
            else
            {
                regions.set(i, new bodyRegion(of[i], images[i]));
            }
        }

        regions_.transfer(regions);
    }

    for (label i = 0; i < of.size() && periodicity_.sliding(); ++i)
    {
        regions_[i].slide(images[i]);
    }
}
