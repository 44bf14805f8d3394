// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedRegion.H"

namespace
{

//- The region of a list that has the shift and body of another, -1 if none
Foam::label findSame
(
    const Foam::PtrList<Foam::bodyRegion>& regions,
    const Foam::bodyRegion& region
)
{
    forAll(regions, i)
    {
        if
        (
            regions.set(i)
         && regions[i].body() == region.body()
         && regions[i].shift() == region.shift()
        )
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

    PtrList<bodyRegion> images(regions_.size());
    label n = 0;
    bool same = true;

    auto append = [&](const label bodyi, const vector& shift)
    {
        autoPtr<bodyRegion> image(new bodyRegion(bodyi, shift));

        same = same
         && n < regions_.size()
         && regions_[n].body() == bodyi
         && regions_[n].shift() == shift;

        images.resize(max(images.size(), n + 1));
        images.set(n++, image);
    };

    forAll(bodies, bodyi)
    {
        append(bodyi, vector::zero);
    }

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
            const vector& shift
          : periodicity_.localShifts(body.state().position, reach)
        )
        {
            if (shift != vector::zero)
            {
                append(bodyi, shift);
            }
        }
    }

    if (same && n == regions_.size())
    {
        return;
    }

    // What has been found for them stays valid
    images.resize(n);

    forAll(images, i)
    {
        const label oldi = findSame(regions_, images[i]);

        if (oldi >= 0)
        {
            images.set(i, regions_.release(oldi));
        }
    }

    regions_.transfer(images);
}
