// SPDX-License-Identifier: GPL-3.0-or-later

#include "proximityMonitor.H"
#include "compat.H"
#include "SortableList.H"
#include "StringStream.H"
#include "wallPolyPatch.H"

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
                const pointHit nearest
                (
                    mesh.faces()[facei].nearestPoint(centre, mesh.points())
                );
                gap = min(gap, body.distance(nearest.rawPoint()));
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
                const scalar gap = a.distance(b.state().position) - Rb;

                overlap =
                    note(a.name() + " and " + b.name(), gap, hPair)
                 || overlap;
            }
        }
    }

    return overlap;
}
