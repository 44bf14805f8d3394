// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedRegion.H"

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


void Foam::immersedRegion::updateImages(const PtrList<immersedBody>& bodies)
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

        const scalar reach =
            bodyRegion::reach(body, resistance_->bandWidth());

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

    setRegions(of, images);
}


void Foam::immersedRegion::setRegions
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
        // What has been found for them stays valid
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
