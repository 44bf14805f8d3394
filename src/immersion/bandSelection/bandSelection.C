// SPDX-License-Identifier: GPL-3.0-or-later

#include "bandSelection.H"

Foam::bandSelection::bandSelection(const polyMesh& mesh)
:
    mesh_(mesh),
    few_(false),
    over_(false),
    inCells_(mesh.nCells()),
    onFaces_(mesh.nFaces())
{}


void Foam::bandSelection::add
(
    const label i,
    bitSet& marked,
    DynamicList<label>& all
)
{
    if (marked.set(i))
    {
        all.append(i);
    }
}


void Foam::bandSelection::add
(
    const UList<label>& labels,
    bitSet& marked,
    DynamicList<label>& all
)
{
    for (const label i : labels)
    {
        add(i, marked, all);
    }
}


Foam::UPtrList<Foam::bodyRegion> Foam::bandSelection::regionsAndParts()
{
    UPtrList<bodyRegion> both(regions_.size() + parts_.size());
    label n = 0;

    for (bodyRegion& region : regions_)
    {
        both.set(n++, &region);
    }
    for (bodyRegion& part : parts_)
    {
        both.set(n++, &part);
    }

    return both;
}


void Foam::bandSelection::selectAll()
{
    over_ = over_ || few_;
    few_ = false;
}


void Foam::bandSelection::select
(
    const bitSet& bodies,
    PtrList<bodyRegion>& all
)
{
    few_ = true;
    over_ = false;
    bodies_ = bodies;

    label n = 0;
    regions_.setSize(all.size());

    for (bodyRegion& region : all)
    {
        if (bodies.test(region.body()))
        {
            regions_.set(n++, &region);
        }
    }
    regions_.setSize(n);
}


void Foam::bandSelection::clearBands()
{
    inCells_.unset(cells_);
    onFaces_.unset(faces_);
    cells_.clear();
    faces_.clear();
    parts_.clear();
}


void Foam::bandSelection::forget()
{
    clearBands();
    usedCells_.clear();
    usedFaces_.clear();
    over_ = false;
}


void Foam::bandSelection::addBands()
{
    for (const bodyRegion& region : regions_)
    {
        add(region.cells, inCells_, cells_);

        for (const label facei : region.faces)
        {
            add(mesh_.faceOwner()[facei], inCells_, cells_);

            if (mesh_.isInternalFace(facei))
            {
                add(mesh_.faceNeighbour()[facei], inCells_, cells_);
            }
        }
    }
}


void Foam::bandSelection::addFaces(const UList<label>& faces)
{
    add(faces, onFaces_, faces_);
}


void Foam::bandSelection::findParts(const PtrList<bodyRegion>& all)
{
    usedCells_.append(cells_);
    usedFaces_.append(faces_);

    label n = 0;
    parts_.clear();
    parts_.setSize(all.size());

    for (const bodyRegion& region : all)
    {
        if (!bodies_.test(region.body()))
        {
            autoPtr<bodyRegion> part(region.part(inCells_, onFaces_));

            if (part->cells.size() || part->faces.size())
            {
                parts_.set(n++, part.ptr());
            }
        }
    }
    parts_.setSize(n);
}
