// SPDX-License-Identifier: GPL-3.0-or-later

#include "patchGaps.H"

Foam::patchGaps::patchGaps(const fvMesh& mesh, const boolList& patches)
:
    mesh_(mesh),
    patches_(patches),
    cells_(mesh.nCells())
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (patches_[patch.index()])
        {
            cells_.set(patch.faceCells());
        }
    }
}


Foam::scalar Foam::patchGaps::gap
(
    const immersedBody& body,
    const bodyRegion& region,
    label& patchi
) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const pointField& points = mesh_.points();
    scalar smallest = GREAT;
    patchi = -1;

    for (const label celli : region.cells)
    {
        if (!cells_.test(celli))
        {
            continue;
        }

        for (const label facei : mesh_.cells()[celli])
        {
            const label at =
                mesh_.isInternalFace(facei) ? -1 : patches.whichPatch(facei);

            if (at < 0 || !patches_[at])
            {
                continue;
            }

            const face& f = mesh_.faces()[facei];
            pointField x
            (
                1, f.nearestPoint(body.state().position, points).rawPoint()
            );

            if (!body.shape().round())
            {
                x.append(f.points(points));
                x.append(mesh_.faceCentres()[facei]);
            }

            scalarField d(x.size());
            body.distance(x, d);

            if (min(d) < smallest)
            {
                smallest = min(d);
                patchi = at;
            }
        }
    }

    return smallest;
}
