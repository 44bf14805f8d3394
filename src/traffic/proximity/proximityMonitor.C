// SPDX-License-Identifier: GPL-3.0-or-later

#include "proximityMonitor.H"
#include "bodyShare.H"
#include "compat.H"
#include "contactModel.H"
#include "contactPoint.H"
#include "StringStream.H"
#include "wallPolyPatch.H"

namespace
{

//- Which patches are walls
Foam::boolList walls(const Foam::polyBoundaryMesh& patches)
{
    Foam::boolList are(patches.size());

    forAll(are, patchi)
    {
        are[patchi] = Foam::isA<Foam::wallPolyPatch>(patches[patchi]);
    }

    return are;
}


//- Is a body there for good: it may touch walls and others of its kind, and
//  overlap them
bool isObstacle(const Foam::immersedBody& body)
{
    return body.isFixed() && !body.status().asleep();
}


//- Gap that is worth a warning, with cells of the size h: none if the flow
//  between the bodies is not to be resolved
Foam::scalar margin(const Foam::immersedBody& body, const Foam::scalar h)
{
    return body.resolved() ? h : 0;
}

} // End anonymous namespace


Foam::proximityMonitor::proximityMonitor
(
    const fvMesh& mesh,
    const periodicity& periods,
    const contactModel& contact
)
:
    walls_(mesh, walls(mesh.boundaryMesh())),
    model_(contact),
    periodicity_(periods)
{}


Foam::string Foam::proximityMonitor::overlaps() const
{
    string all;

    for (const string& overlap : overlaps_)
    {
        all += (all.empty() ? "" : ", ") + overlap;
    }

    return all;
}


void Foam::proximityMonitor::note
(
    const word& first,
    const word& second,
    const scalar gap,
    const scalar h,
    const scalar width
)
{
    const bool contact = model_.active();
    const scalar allowed = 0.5*model_.largestOverlap()*width;
    const bool overlap = gap < -allowed;

    // Nothing to say of nearly all
    if (!overlap && (contact || gap >= h))
    {
        return;
    }

    const string pair(first + " and " + second);

    if (!contact && gap < h && reported_.insert(pair))
    {
        WarningInFunction
            << "Gap of " << gap << " m between " << pair.c_str()
            << ", below the cell size of " << h
            << " m: the flow between them is not resolved and there is no"
            << " contact model" << nl << endl;
    }

    if (overlap)
    {
        OStringStream os;
        os  << pair.c_str() << " by " << -gap << " m";

        if (contact)
        {
            os  << " (allowed are " << allowed << " m, 'largestOverlap "
                << model_.largestOverlap() << "' in 'contact')";
        }
        overlaps_.append(os.str());
    }
}


void Foam::proximityMonitor::checkPair
(
    const PtrList<immersedBody>& bodies,
    const UList<scalar>& h,
    const closePairs::pair& pair
)
{
    const immersedBody& a = bodies[pair.a];
    const immersedBody& b = bodies[pair.b];

    const scalar near = max(margin(a, h[pair.a]), margin(b, h[pair.b]));
    const scalar ofSpheres =
        mag(b.state().position + pair.shift - a.state().position)
      - a.shape().boundingRadius() - b.shape().boundingRadius();

    // Those that are there for good may overlap each other
    if (ofSpheres < near && !(isObstacle(a) && isObstacle(b)))
    {
        note
        (
            a.name(),
            b.name(),
            contactPoint(a, b, pair.shift).gap,
            near,
            min(a.shape().width(), b.shape().width())
        );
    }
}


Foam::scalarField Foam::proximityMonitor::wallGaps
(
    const bodyList& bodies,
    const immersedRegion& region
) const
{
    scalarField gaps(bodies.size(), GREAT);

    if (!bodies.anyResolved())
    {
        return gaps;
    }

    for (const bodyRegion& r : region.regions())
    {
        scalar& gap = gaps[r.body()];
        label patchi;

        gap = min
        (
            gap,
            walls_.gap(bodies[r.body()], r.cells, patchi, r.shift())
        );
    }

    bodies.share().combine(gaps, minEqOp<scalar>());

    return gaps;
}


Foam::DynamicList<Foam::closePairs::pair> Foam::proximityMonitor::findPairs
(
    const PtrList<immersedBody>& bodies,
    const UList<scalar>& h
) const
{
    DynamicList<closePairs::pair> pairs;

    // Pairs of bodies that neither move freely nor are obstacles are not known
    bool all = true;

    for (const immersedBody& body : bodies)
    {
        all = all && (body.isFree() || isObstacle(body));
    }

    if (all && model_.pairsAtEnd(pairs))
    {
        return pairs;
    }

    pointField centres(bodies.size());
    scalarField radii(bodies.size());

    forAll(bodies, i)
    {
        centres[i] = bodies[i].state().position;
        radii[i] =
            bodies[i].shape().boundingRadius() + margin(bodies[i], h[i]);
    }

    return closePairs(centres, radii, periodicity_).pairs();
}


bool Foam::proximityMonitor::gatherOverlaps()
{
    if (!returnReduce(!overlaps_.empty(), orOp<bool>()))
    {
        return false;
    }

    List<List<string>> all(Pstream::nProcs());

    all[Pstream::myProcNo()] = overlaps_;
    compat::allGather(all);
    overlaps_.clear();

    for (const List<string>& found : all)
    {
        for (const string& overlap : found)
        {
            if (!overlaps_.found(overlap))
            {
                overlaps_.append(overlap);
            }
        }
    }

    return true;
}


bool Foam::proximityMonitor::check
(
    const bodyList& bodies,
    const immersedRegion& region,
    const UList<scalar>& h
)
{
    const scalarField gaps(wallGaps(bodies, region));

    overlaps_.clear();

    forAll(bodies, i)
    {
        note
        (
            bodies[i].name(),
            "a wall",
            isObstacle(bodies[i]) ? GREAT : gaps[i],
            h[i],
            bodies[i].shape().width()
        );
    }

    for (const closePairs::pair& pair : findPairs(bodies, h))
    {
        checkPair(bodies, h, pair);
    }

    return gatherOverlaps();
}
