// SPDX-License-Identifier: GPL-3.0-or-later

#include "proximityMonitor.H"
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
    contact_(contact.active()),
    allowed_(contact.largestOverlap()),
    periodicity_(periods)
{}


bool Foam::proximityMonitor::note
(
    const word& first,
    const word& second,
    const scalar gap,
    const scalar h,
    const scalar width
)
{
    const bool overlap = gap < -0.5*allowed_*width;

    // Nothing to say of nearly all
    if (!overlap && (contact_ || gap >= h))
    {
        return false;
    }

    const string pair(first + " and " + second);

    if (!contact_ && gap < h && reported_.insert(pair))
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
        os  << (overlaps_.empty() ? "" : ", ") << pair.c_str() << " by "
            << -gap << " m";

        if (contact_)
        {
            os  << " (allowed are " << 0.5*allowed_*width
                << " m, 'largestOverlap " << allowed_ << "' in 'contact')";
        }
        overlaps_ += os.str();
    }

    return overlap;
}


bool Foam::proximityMonitor::checkPair
(
    const PtrList<immersedBody>& bodies,
    const UList<scalar>& h,
    const closePairs::pair& pair
)
{
    const immersedBody& a = bodies[pair.a];
    const immersedBody& b = bodies[pair.b];

    return note
    (
        a.name(),
        b.name(),
        contactPoint(a, b, pair.shift).gap,
        max(margin(a, h[pair.a]), margin(b, h[pair.b])),
        min(a.shape().width(), b.shape().width())
    );
}


bool Foam::proximityMonitor::check
(
    const PtrList<immersedBody>& bodies,
    const immersedRegion& region,
    const UList<scalar>& h
)
{
    scalarField wallGaps(bodies.size(), GREAT);

    for (const bodyRegion& r : region.regions())
    {
        scalar& gap = wallGaps[r.body()];
        label patchi;

        gap = min
        (
            gap,
            walls_.gap(bodies[r.body()], r.cells, patchi, r.shift())
        );
    }

    compat::allReduce(wallGaps, minEqOp<scalar>());

    bool overlap = false;
    overlaps_.clear();

    pointField centres(bodies.size());
    scalarField radii(bodies.size());

    forAll(bodies, i)
    {
        if (isObstacle(bodies[i]))
        {
            wallGaps[i] = GREAT;
        }

        centres[i] = bodies[i].state().position;
        radii[i] =
            bodies[i].shape().boundingRadius() + margin(bodies[i], h[i]);
        overlap =
            note
            (
                bodies[i].name(),
                "a wall",
                wallGaps[i],
                h[i],
                bodies[i].shape().width()
            )
         || overlap;
    }

    const closePairs close(centres, radii, periodicity_);

    for (const closePairs::pair& pair : close.pairs())
    {
        if (!isObstacle(bodies[pair.a]) || !isObstacle(bodies[pair.b]))
        {
            overlap = checkPair(bodies, h, pair) || overlap;
        }
    }

    return overlap;
}
