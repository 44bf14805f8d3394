// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedRegion.H"

void Foam::immersedRegion::unite
(
    const PtrList<bodyRegion>& regions,
    const DynamicList<label> bodyRegion::*labels,
    const label size,
    DynamicList<label>& all
)
{
    all.clear();

    if (regions.size() == 1)
    {
        all = regions[0].*labels;
        return;
    }

    bitSet met(size);

    for (const bodyRegion& region : regions)
    {
        for (const label i : region.*labels)
        {
            if (met.set(i))
            {
                all.append(i);
            }
        }
    }
}


void Foam::immersedRegion::combineShields
(
    const DynamicList<label> bodyRegion::*labels,
    const DynamicList<scalar> bodyRegion::*shields,
    DynamicList<scalar> bodyRegion::*shares,
    const labelUList& all,
    scalarField& total
)
{
    UPtrList<bodyRegion> regions(worked());

    // One body: the flat field is its list
    if (regions_.size() == 1 && !selection_.few())
    {
        regions[0].*shares = regions[0].*shields;
        UIndirectList<scalar>(total, all) = regions[0].*shields;
        return;
    }

    // Places in the shields of several bodies
    bitSet shared(total.size());
    bool any = false;

    shieldSum_.resize(mesh_.nFaces());
    UIndirectList<scalar>(total, all) = 0;

    // One less the product of the open parts, and sum of the shields
    for (const bodyRegion& region : regions)
    {
        forAll(region.*labels, i)
        {
            const label at = (region.*labels)[i];
            const scalar shield = (region.*shields)[i];
            const scalar before = total[at];

            if (before > 0 && shield > 0)
            {
                shieldSum_[at] =
                    shield + (shared.set(at) ? before : shieldSum_[at]);
                any = true;
            }
            total[at] = before + shield*(1 - before);
        }
    }

    for (bodyRegion& region : regions)
    {
        region.*shares = region.*shields;

        forAll(region.*labels, i)
        {
            const label at = (region.*labels)[i];

            if (any && shared.test(at))
            {
                (region.*shares)[i] *= total[at]/shieldSum_[at];
            }
        }
    }
}


void Foam::immersedRegion::combineShields()
{
    combineShields
    (
        &bodyRegion::cells,
        &bodyRegion::shield,
        &bodyRegion::share,
        cells(),
        shield_
    );
    combineShields
    (
        &bodyRegion::faces,
        &bodyRegion::faceShield,
        &bodyRegion::faceShare,
        faces(),
        faceShield_
    );
}


void Foam::immersedRegion::added()
{
    selectAll();

    // Before the images
    const label bodyi = bodies().size() - 1;

    regions_.resize(regions_.size() + 1);

    for (label i = regions_.size() - 1; i > bodyi; --i)
    {
        regions_.set(i, regions_.release(i - 1));
    }
    regions_.set(bodyi, new bodyRegion(bodyi));
}


void Foam::immersedRegion::removed(const label bodyi)
{
    selectAll();

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


bool Foam::immersedRegion::stillValid(const PtrList<immersedBody>& bodies) const
{
    forAll(bodies, bodyi)
    {
        if (selected(bodyi) && !regions_[bodyi].stillValid(bodies[bodyi]))
        {
            return false;
        }
    }

    return true;
}


Foam::UPtrList<Foam::bodyRegion> Foam::immersedRegion::worked()
{
    if (selection_.few())
    {
        return selection_.regionsAndParts();
    }

    UPtrList<bodyRegion> all(regions_.size());

    forAll(all, i)
    {
        all.set(i, &regions_[i]);
    }

    return all;
}


void Foam::immersedRegion::selectAll()
{
    if (selection_.few())
    {
        selection_.selectAll();
        ++version_;
    }
}


Foam::bodyRegion::change Foam::immersedRegion::updateRegion
(
    const immersedBody& body,
    const bool changed,
    const bool again,
    bodyRegion& region
)
{
    const bodyRegion::change done =
        region.update(body, search_, resistance_->bandWidth(), again);

    // One that is new may have been placed in the mesh before
    if (changed || done != bodyRegion::change::none)
    {
        resistance_->setShield(body, region);
    }

    return done;
}


void Foam::immersedRegion::updateFew(const PtrList<immersedBody>& bodies)
{
    selection_.clearBands();

    // Where they have been they leave something
    selection_.addBands();

    for (bodyRegion& region : selection_.regions())
    {
        updateRegion(bodies[region.body()], false, true, region);
    }

    selection_.addBands();

    DynamicList<label> faces;
    bandFaces(faces);
    selection_.addFaces(faces);
    selection_.findParts(regions_);
    combineShields();
    ++version_;
}


void Foam::immersedRegion::updateGeometry
(
    const PtrList<immersedBody>& bodies,
    const bool changed,
    const bool again
)
{
    if (changed || !again)
    {
        selectAll();
    }

    // By the bodies alone, which are the same on all processors
    same_ = again && !changed && !selection_.over() && stillValid(bodies);

    if (selection_.few())
    {
        updateFew(bodies);
        return;
    }
    if (same_)
    {
        return;
    }

    updateImages(bodies);

    typedef bodyRegion::change change;
    bool moved = changed || selection_.over(), anew = moved;

    for (bodyRegion& region : regions_)
    {
        const immersedBody& body = bodies[region.body()];

        if (body.resolved())
        {
            const change done = updateRegion(body, changed, again, region);

            moved = moved || done != change::none;
            anew = anew || done == change::anew;
        }
        else if (region.clear())
        {
            moved = anew = true;
        }
    }

    if (!moved)
    {
        return;
    }

    if (anew)
    {
        collect();
    }
    combineShields();
}


void Foam::immersedRegion::clearSums
(
    const labelUList& cells,
    const labelUList& faces
)
{
    UIndirectList<scalar>(K_.primitiveFieldRef(), cells) = 0;
    UIndirectList<vector>(KU_, cells) = vector::zero;
    UIndirectList<vector>(shieldDU_, cells) = vector::zero;
    UIndirectList<scalar>(shield_, cells) = 0;
    UIndirectList<scalar>(faceShield_, faces) = 0;
    UIndirectList<scalar>(bodyFlux_, faces) = 0;
}


void Foam::immersedRegion::collect()
{
    ++version_;

    clearSums(cells_, faces_);
    clearSums(selection_.usedCells(), selection_.usedFaces());
    selection_.forget();
    unite(regions_, &bodyRegion::cells, mesh_.nCells(), cells_);
    unite(regions_, &bodyRegion::faces, mesh_.nFaces(), faces_);
}
