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
    bodyPassage& passage
)
:
    bodies_(bodies),
    region_(region),
    window_(window),
    loads_(loads),
    resolution_(resolution),
    h_(h),
    passage_(passage)
{}


void Foam::bodyTraffic::hold()
{
    UPtrList<const DynamicList<label>> beside(bodies_.size());

    forAll(beside, bodyi)
    {
        beside.set(bodyi, &resolution_.cellsBeside(bodyi));
    }

    for (const label bodyi : passage_.touch(bodies_, beside, loads_.all()))
    {
        immersedBody& body = bodies_[bodyi];

        passage_.table().add
        (
            body, "held", body.status().passing(), window_.displacement()
        );
        body.hold();
    }
}


bool Foam::bodyTraffic::leave()
{
    hold();

    bool good = true;
    bool changed = false;

    // From the last on, as those after one that is taken out move up
    for (label bodyi = bodies_.size() - 1; bodyi >= 0; --bodyi)
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

        if (body.status().passing().empty())
        {
            OSstream& os = bodies_.share().spread()
              ? static_cast<OSstream&>(Pout)
              : static_cast<OSstream&>(Info);

            os  << "Body " << body.name() << " has left the mesh at "
                << body.state().position + window_.displacement()
                << ", moving with " << body.state().U << endl;
            good = false;
            continue;
        }

        passage_.table().add
        (
            body, "leaves", body.status().passing(), window_.displacement()
        );
        passage_.take(bodies_.take(bodyi));
        changed = true;
    }

    if (changed)
    {
        region_.updateGeometry(bodies_, true);
    }

    return bodies_.share().spread()
      ? returnReduce(good, andOp<bool>())
      : good;
}
