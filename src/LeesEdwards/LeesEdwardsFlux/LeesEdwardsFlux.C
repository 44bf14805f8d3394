// SPDX-License-Identifier: GPL-3.0-or-later

#include "LeesEdwardsFlux.H"
#include "LeesEdwardsPolyPatch.H"

void Foam::LeesEdwards::equalise(const fvMesh& mesh, surfaceScalarField& phi)
{
    const slidingPair* pair = LeesEdwardsPolyPatch::findPair(mesh);

    if (!pair)
    {
        return;
    }

    scalarField& first = phi.boundaryFieldRef()[pair->patchIndex()];
    scalarField& second = phi.boundaryFieldRef()[pair->otherPatchIndex()];

    first = 0.5*(first - pair->beyond(pair->patchIndex(), second));
    second = -pair->beyond(pair->otherPatchIndex(), first);
}


void Foam::LeesEdwards::clear(const fvMesh& mesh, surfaceScalarField& phi)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<LeesEdwardsPolyPatch>(patch))
        {
            phi.boundaryFieldRef()[patch.index()] = 0;
        }
    }
}
