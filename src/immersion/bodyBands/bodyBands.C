// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyBands.H"
#include "bodyShare.H"
#include <algorithm>

namespace
{

//- Set `all` to the labels of all regions, each once and in ascending order,
//  as fields lie in memory; size: one more than the largest of them
void unite
(
    const Foam::PtrList<Foam::bodyRegion>& regions,
    const Foam::DynamicList<Foam::label> Foam::bodyRegion::*labels,
    const Foam::label size,
    Foam::DynamicList<Foam::label>& all
)
{
    Foam::bitSet met(size);

    for (const Foam::bodyRegion& region : regions)
    {
        met.set(region.*labels);
    }

    all = met.sortedToc();
}

} // End anonymous namespace


Foam::bodyBands::bodyBands
(
    const cellSearch& search,
    const cellSurroundings& surroundings,
    const periodicity& periods,
    const resistanceModel& resistance,
    bodyList& bodies
)
:
    bodyList::dependent(bodies),
    search_(search),
    surroundings_(surroundings),
    resistance_(resistance),
    regions_(periods),
    selection_(search.mesh()),
    same_(false),
    version_(0)
{}


void Foam::bodyBands::added()
{
    selectAll();
}


void Foam::bodyBands::removed(const label bodyi)
{
    labelList order(identity(bodies().size()));

    for (label i = bodyi; i < order.size(); ++i)
    {
        order[i] = i + 1;
    }
    reordered(order);
}


void Foam::bodyBands::reordered(const labelUList& order)
{
    selectAll();
    regions_.renumber(order);
}


bool Foam::bodyBands::stillValid(const PtrList<immersedBody>& bodies) const
{
    if (!regions_.complete(bodies))
    {
        return false;
    }

    forAll(bodies, bodyi)
    {
        const immersedBody& body = bodies[bodyi];

        if
        (
            body.resolved() && selected(bodyi)
         && !regions_[bodyi].stillValid(body)
        )
        {
            return false;
        }
    }

    return true;
}


Foam::UPtrList<Foam::bodyRegion> Foam::bodyBands::worked()
{
    if (selection_.few())
    {
        return selection_.regionsAndParts();
    }

    UPtrList<bodyRegion> all(regions().size());

    forAll(all, i)
    {
        all.set(i, &regions()[i]);
    }

    return all;
}


Foam::scalar Foam::bodyBands::overlap() const
{
    // With those in several bands as often as they are there
    label all = 0;

    for (const bodyRegion& region : regions())
    {
        all += region.cells.size();
    }

    const scalar once = returnReduce(cells_.size(), sumOp<label>());

    return (returnReduce(all, sumOp<label>()) - once)/max(once, 1);
}


void Foam::bodyBands::selectAll()
{
    if (selection_.few())
    {
        selection_.selectAll();
        ++version_;
    }
}


Foam::bodyRegion::change Foam::bodyBands::updateRegion
(
    const immersedBody& body,
    const bool changed,
    const bool again,
    bodyRegion& region
)
{
    typedef bodyRegion::change change;

    const change done =
        region.update(body, search_, resistance_.bandWidth(), again);

    // One that is new may have been placed in the mesh before
    if (changed || done != change::none)
    {
        resistance_.setShield(body, region);
    }

    return done;
}


void Foam::bodyBands::updateFew(const PtrList<immersedBody>& bodies)
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
    surroundings_.faces(selection_.cells(), faces);
    selection_.addFaces(faces);
    selection_.findParts(regions());
    ++version_;
}


Foam::bodyRegion::change Foam::bodyBands::update
(
    const PtrList<immersedBody>& bodies,
    const bool changed,
    const bool again
)
{
    typedef bodyRegion::change change;

    if (changed || !again)
    {
        selectAll();
    }

    // The same on all processors: by the bodies alone
    same_ =
        again && !changed && !selection_.over()
     && this->bodies().share().all(stillValid(bodies));

    if (selection_.few())
    {
        updateFew(bodies);
        return change::moved;
    }
    if (same_)
    {
        return change::none;
    }

    const bool others =
        changed || selection_.over() || !regions_.complete(bodies);
    change most = others ? change::anew : change::none;

    regions_.update(bodies, resistance_.bandWidth(), again);

    for (bodyRegion& region : regions())
    {
        const immersedBody& body = bodies[region.body()];

        most = std::max(most, updateRegion(body, changed, again, region));
    }

    return most;
}


void Foam::bodyBands::collect()
{
    const fvMesh& mesh = search_.mesh();

    ++version_;
    selection_.forget();
    unite(regions(), &bodyRegion::cells, mesh.nCells(), cells_);
    unite(regions(), &bodyRegion::faces, mesh.nFaces(), faces_);
}
