// SPDX-License-Identifier: GPL-3.0-or-later

#include "proximityMonitor.H"
#include "compat.H"
#include "SortableList.H"
#include "StringStream.H"
#include "wallPolyPatch.H"

namespace
{

//- Smallest signed distance from the surface of a to points on that of b
Foam::scalar sampledGap
(
    const Foam::immersedBody& a,
    const Foam::immersedBody& b
)
{
    Foam::pointField x;
    Foam::faceList faces;
    b.shape().surface(x, faces);

    const Foam::tensor R(b.state().orientation.R());
    for (Foam::point& xi : x)
    {
        xi = b.state().position + (R & xi);
    }

    Foam::scalarField d(x.size());
    a.distance(x, d);

    return Foam::min(d);
}

} // End anonymous namespace


Foam::proximityMonitor::proximityMonitor(const fvMesh& mesh)
:
    wallCells_(mesh.nCells())
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
    const immersedBody& b
)
{
    if (b.shape().round())
    {
        return a.distance(b.state().position) - b.shape().boundingRadius();
    }

    if (a.shape().round())
    {
        return gap(b, a);
    }

    return min(sampledGap(a, b), sampledGap(b, a));
}


bool Foam::proximityMonitor::note
(
    const string& pair,
    const scalar gap,
    const scalar h
)
{
    if (gap < h && reported_.insert(pair))
    {
        WarningInFunction
            << "Gap of " << gap << " m between " << pair.c_str()
            << ", below the cell size of " << h
            << " m: the flow between them is not resolved and there is no"
            << " contact model" << nl << endl;
    }

    if (gap < 0)
    {
        OStringStream os;
        os  << (overlaps_.empty() ? "" : ", ") << pair.c_str() << " by "
            << -gap << " m";
        overlaps_ += os.str();
    }

    return gap < 0;
}


Foam::scalar Foam::proximityMonitor::wallGap
(
    const immersedBody& body,
    const bodyRegion& region,
    const fvMesh& mesh
) const
{
    const point& centre = body.state().position;
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
                gap = min(gap, body.distance(nearest.rawPoint()));

                if (!round)
                {
                    pointField x(f.points(mesh.points()));
                    x.append(mesh.faceCentres()[facei]);

                    scalarField d(x.size());
                    body.distance(x, d);
                    gap = min(gap, min(d));
                }
            }
        }
    }

    return gap;
}


bool Foam::proximityMonitor::check
(
    const PtrList<immersedBody>& bodies,
    const immersedRegion& region,
    const UList<scalar>& h,
    const fvMesh& mesh
)
{
    const label n = bodies.size();
    scalarField wallGaps(n);
    boundBox box;

    forAll(bodies, i)
    {
        wallGaps[i] = wallGap(bodies[i], region.region(i), mesh);
        box.add(bodies[i].state().position);
    }

    compat::allReduce(wallGaps, minEqOp<scalar>());

    bool overlap = false;
    overlaps_.clear();

    // Sweep along the longest side, by the lower ends of the bounding spheres
    const vector span(box.span());
    const direction along =
        span.x() >= max(span.y(), span.z()) ? 0 : span.y() >= span.z() ? 1 : 2;

    SortableList<scalar> lower(n);

    forAll(bodies, i)
    {
        lower[i] = bodies[i].state().position[along]
          - bodies[i].shape().boundingRadius() - 0.5*h[i];

        overlap =
            note(bodies[i].name() + " and a wall", wallGaps[i], h[i])
         || overlap;
    }
    lower.sort();

    for (label k = 0; k < n; ++k)
    {
        const label i = lower.indices()[k];
        const immersedBody& a = bodies[i];
        const scalar Ra = a.shape().boundingRadius();
        const scalar upper = a.state().position[along] + Ra + 0.5*h[i];

        for (label l = k + 1; l < n && lower[l] < upper; ++l)
        {
            const label j = lower.indices()[l];
            const immersedBody& b = bodies[j];
            const scalar Rb = b.shape().boundingRadius();
            const scalar hPair = max(h[i], h[j]);

            if (mag(a.state().position - b.state().position) < Ra + Rb + hPair)
            {
                overlap =
                    note(a.name() + " and " + b.name(), gap(a, b), hPair)
                 || overlap;
            }
        }
    }

    return overlap;
}
