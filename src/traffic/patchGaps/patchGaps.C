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
    const label facei,
    const vector& shift
) const
{
    const pointField& points = mesh_.points();
    const face& f = mesh_.faces()[facei];
    const point centre(body.state().position + shift);
    pointField x(1, f.nearestPoint(centre, points).rawPoint());

    if (!body.resolved())
    {
        const vector out(centre - x[0]);
        const scalar side = (out & mesh_.faceAreas()[facei]) > 0 ? -1 : 1;

        return side*mag(out) - body.shape().boundingRadius();
    }

    if (!body.shape().round())
    {
        x.append(f.points(points));
        x.append(mesh_.faceCentres()[facei]);
    }

    x -= shift;

    scalarField d(x.size());
    body.posed().distance(x, d);

    return min(d);
}


Foam::scalar Foam::patchGaps::gap
(
    const immersedBody& body,
    const UList<label>& beside,
    label& patchi,
    const vector& shift
) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    scalar smallest = GREAT;
    patchi = -1;

    for (const label celli : beside)
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

            const scalar d = gap(body, facei, shift);

            if (d < smallest)
            {
                smallest = d;
                patchi = at;
            }
        }
    }

    return smallest;
}
