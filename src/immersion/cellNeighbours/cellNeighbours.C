// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellNeighbours.H"

Foam::cellNeighbours::cellNeighbours(const fvMesh& mesh)
:
    start_(mesh.nCells() + 1, Zero),
    patchStart_(mesh.nCells() + 1),
    neighbours_(2*mesh.nInternalFaces())
{
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();

    label n = 0;

    forAll(mesh.cells(), celli)
    {
        start_[celli] = n;
        patchStart_[celli] = patchFaces_.size();

        for (const label facei : mesh.cells()[celli])
        {
            if (facei < own.size())
            {
                const bool owner = own[facei] == celli;
                const label other = owner ? nei[facei] : own[facei];

                neighbours_[n++] = neighbour(other, facei, owner);
                continue;
            }

            const label patchi =
                patches.patchID()[facei - mesh.nInternalFaces()];

            if (mesh.boundary()[patchi].size())
            {
                patchFaces_.append
                (
                    patchFace{patchi, facei - patches[patchi].start()}
                );
            }
        }
    }

    start_.last() = n;
    patchStart_.last() = patchFaces_.size();
    patchFaces_.shrink();
}
