// SPDX-License-Identifier: GPL-3.0-or-later

#include "symmetryPlanes.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"

Foam::symmetryPlanes::symmetryPlanes(const fvMesh& mesh)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if
        (
            !isA<symmetryPlanePolyPatch>(patch)
         && !isA<symmetryPolyPatch>(patch)
        )
        {
            continue;
        }

        const vectorField& Sf = patch.faceAreas();
        const scalar area = gSum(mag(Sf));
        const vector normal(gSum(Sf)/max(area, VSMALL));

        // Of a curved patch the normals do not add up
        if (mag(normal) > 1 - 1e-6)
        {
            normals_.append(normal/mag(normal));
            points_.append(gSum(mag(Sf)*patch.faceCentres())/area);
        }
    }
}


Foam::List<Foam::vector> Foam::symmetryPlanes::through
(
    const point& x,
    const scalar tolerance
) const
{
    DynamicList<vector> found;

    forAll(normals_, i)
    {
        if (mag((x - points_[i]) & normals_[i]) < tolerance)
        {
            found.append(normals_[i]);
        }
    }

    return List<vector>(std::move(found));
}
