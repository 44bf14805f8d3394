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


Foam::bodyRegions::bodyRegions(const periodicity& periods)
:
    periodicity_(periods),
    nBodies_(0)
{}


const Foam::bodyRegion& Foam::bodyRegions::operator[](const label bodyi) const
{
    // The first that is not of a body before
    label first = 0, end = nBodies_;

    while (first < end)
    {
        const label middle = (first + end)/2;

        if (regions_[middle].body() < bodyi)
        {
            first = middle + 1;
        }
        else
        {
            end = middle;
        }
    }

    if (first == nBodies_ || regions_[first].body() != bodyi)
    {
        FatalErrorInFunction
            << "There is no region of body " << bodyi << nl
            << abort(FatalError);
    }

    return regions_[first];
}


bool Foam::bodyRegions::complete(const PtrList<immersedBody>& bodies) const
{
    label n = 0;

    forAll(bodies, bodyi)
    {
        if (bodies[bodyi].resolved())
        {
            if (n == nBodies_ || regions_[n].body() != bodyi)
            {
                return false;
            }
            ++n;
        }
    }

    return n == nBodies_;
}


void Foam::bodyRegions::remove(const label bodyi)
{
    PtrList<bodyRegion> others(regions_.size());
    label n = 0, nBodies = 0;

    forAll(regions_, i)
    {
        if (regions_[i].body() != bodyi)
        {
            others.set(n, regions_.release(i));
            others[n++].moveUp(bodyi);
            nBodies += i < nBodies_;
        }
    }

    others.resize(n);
    regions_.transfer(others);
    nBodies_ = nBodies;
}


void Foam::bodyRegions::update
(
    const PtrList<immersedBody>& bodies,
    const scalar bandWidth
)
{
    const periodicity::image itself{Zero, Zero, Zero};
    DynamicList<label> of;
    DynamicList<periodicity::image> images;

    forAll(bodies, bodyi)
    {
        if (bodies[bodyi].resolved())
        {
            of.append(bodyi);
            images.append(itself);
        }
    }

    nBodies_ = of.size();

    for (label i = 0; i < nBodies_ && periodicity_.active(); ++i)
    {
        const label bodyi = of[i];
        const immersedBody& body = bodies[bodyi];
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
