// SPDX-License-Identifier: GPL-3.0-or-later

#include "proximityMonitor.H"
#include "compat.H"
#include "contactModel.H"
#include "StringStream.H"
#include "wallPolyPatch.H"

namespace
{

//- Smallest signed distance from the surface of a to points on that of b,
//  shifted
Foam::scalar sampledGap
(
    const Foam::immersedBody& a,
    const Foam::immersedBody& b,
    const Foam::vector& shift
)
{
    Foam::pointField x;
    Foam::faceList faces;
    b.shape().surface(x, faces);

    const Foam::tensor R(b.state().orientation.R());
    for (Foam::point& xi : x)
    {
        xi = b.state().position + shift + (R & xi);
    }

    Foam::scalarField d(x.size());
    a.distance(x, d);

    return Foam::min(d);
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
    wallCells_(mesh.nCells()),
    contact_(contact.active()),
    allowed_(contact.largestOverlap()),
    periodicity_(periods)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<wallPolyPatch>(patch))
        {
            wallCells_.set(patch.faceCells());
        }
    }
}


Foam::scalar Foam::proximityMonitor::gap
(
    const immersedBody& a,
    const immersedBody& b,
    const vector& shift
)
{
    if (b.shape().round())
    {
        return
            a.distance(b.state().position + shift)
          - b.shape().boundingRadius();
    }

    if (a.shape().round())
    {
        return gap(b, a, -shift);
    }

    if (a.shape().hasSupport() && b.shape().hasSupport())
    {
        return contactPoint(a, b, shift).gap;
    }

    return min(sampledGap(a, b, shift), sampledGap(b, a, -shift));
}


bool Foam::proximityMonitor::note
(
    const string& pair,
    const scalar gap,
    const scalar h,
    const scalar width
)
{
    const bool overlap = gap < -0.5*allowed_*width;

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
        overlaps_ += os.str();
    }

    return overlap;
}


Foam::scalar Foam::proximityMonitor::wallGap
(
    const immersedBody& body,
    const bodyRegion& region,
    const fvMesh& mesh
) const
{
    const point centre(region.centre(body.state()));
    const bool round = body.shape().round();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    scalar gap = GREAT;

    forAll(region.cells, i)
    {
        const label celli = region.cells[i];

        if (!wallCells_.test(celli))
        {
            continue;
        }

        for (const label facei : mesh.cells()[celli])
        {
            if
            (
                !mesh.isInternalFace(facei)
             && isA<wallPolyPatch>(patches[patches.whichPatch(facei)])
            )
            {
                const face& f = mesh.faces()[facei];
                const pointHit nearest(f.nearestPoint(centre, mesh.points()));
                gap = min
                (
                    gap,
                    body.distance(nearest.rawPoint() - region.shift())
                );

                if (!round)
                {
                    pointField x(f.points(mesh.points()));
                    x.append(mesh.faceCentres()[facei]);
                    x -= region.shift();

                    scalarField d(x.size());
                    body.distance(x, d);
                    gap = min(gap, min(d));
                }
            }
        }
    }

    return gap;
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
        a.name() + " and " + b.name(),
        gap(a, b, pair.shift),
        max(margin(a, h[pair.a]), margin(b, h[pair.b])),
        min(a.shape().width(), b.shape().width())
    );
}


bool Foam::proximityMonitor::check
(
    const PtrList<immersedBody>& bodies,
    const immersedRegion& region,
    const UList<scalar>& h,
    const fvMesh& mesh
)
{
    scalarField wallGaps(bodies.size(), GREAT);

    for (const bodyRegion& r : region.regions())
    {
        scalar& gap = wallGaps[r.body()];

        gap = min(gap, wallGap(bodies[r.body()], r, mesh));
    }

    compat::allReduce(wallGaps, minEqOp<scalar>());

    bool overlap = false;
    overlaps_.clear();

    pointField centres(bodies.size());
    scalarField radii(bodies.size());

    forAll(bodies, i)
    {
        centres[i] = bodies[i].state().position;
        radii[i] =
            bodies[i].shape().boundingRadius() + margin(bodies[i], h[i]);
        overlap =
            note
            (
                bodies[i].name() + " and a wall",
                wallGaps[i],
                h[i],
                bodies[i].shape().width()
            )
         || overlap;
    }

    const closePairs close(centres, radii, periodicity_);

    for (const closePairs::pair& pair : close.pairs())
    {
        overlap = checkPair(bodies, h, pair) || overlap;
    }

    return overlap;
}
