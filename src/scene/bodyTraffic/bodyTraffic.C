// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTraffic.H"
#include "bodyShare.H"

Foam::bodyTraffic::bodyTraffic
(
    bodyList& bodies,
    immersedRegion& region,
    const meshWindow& window,
    const bodyLoads& loads,
    bodyResolution& resolution,
    bodyCellSizes& h,
    bodyPassage& passage,
    bodyHandover& handover
)
:
    bodies_(bodies),
    region_(region),
    window_(window),
    loads_(loads),
    resolution_(resolution),
    h_(h),
    passage_(passage),
    handover_(handover)
{}


void Foam::bodyTraffic::tell
(
    const immersedBody& body,
    const word& what,
    const word& where
)
{
    passage_.table().add(body, what, where, window_.displacement());
}


void Foam::bodyTraffic::hold()
{
    UPtrList<const DynamicList<label>> beside(bodies_.size());

    forAll(beside, bodyi)
    {
        beside.set(bodyi, &resolution_.cellsBeside(bodyi));
    }

    const labelList held(passage_.touch(bodies_, beside, loads_.all()));

    if (bodies_.share().any(held.size()))
    {
        for (const immersedBody& body : handover_.copies(held))
        {
            tell(body, "held", body.status().passing());
        }
    }
    for (const label bodyi : held)
    {
        bodies_[bodyi].hold();
    }
}


bool Foam::bodyTraffic::leave()
{
    hold();

    boolList leaves(bodies_.size(), false);
    bool good = true;

    forAll(bodies_, bodyi)
    {
        const immersedBody& body = bodies_[bodyi];

        if
        (
            loads_.inMesh(bodyi) || body.isFixed()
         || !bodies_.share().mine(bodyi)
        )
        {
            continue;
        }

        leaves[bodyi] = body.status().passing().size();
        if (!leaves[bodyi])
        {
            OSstream& os = bodies_.share().spread()
              ? static_cast<OSstream&>(Pout)
              : static_cast<OSstream&>(Info);

            os  << "Body " << body.name() << " has left the mesh at "
                << body.state().position + window_.displacement()
                << ", moving with " << body.state().U << endl;
            good = false;
        }
    }

    if (bodies_.share().any(leaves.found(true)))
    {
        takeOut(leaves);
    }

    return bodies_.share().all(good);
}


void Foam::bodyTraffic::takeOut(UList<bool>& leaves)
{
    DynamicList<label> listed;

    bodies_.share().give(leaves);
    forAll(leaves, bodyi)
    {
        if (leaves[bodyi])
        {
            listed.append(bodyi);
        }
    }

    PtrList<immersedBody> taken(handover_.take(listed));

    forAll(taken, i)
    {
        tell(taken[i], "leaves", taken[i].status().passing());
        passage_.take(autoPtr<immersedBody>(taken.release(i)));
    }

    region_.updateGeometry(bodies_, true);
}
