// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodySums.H"
#include "cyclicPolyPatch.H"
#include "LeesEdwardsFlux.H"
#include "profiling.H"
#include "syncTools.H"

namespace
{

//- Set the fluxes on both sides of cyclic patches to their mean: they differ on
//  patches that are turned, where bodies have no images
void equaliseCyclic
(
    const Foam::fvMesh& mesh,
    Foam::surfaceScalarField& phi
)
{
    const Foam::polyBoundaryMesh& patches = mesh.boundaryMesh();
    const Foam::label nInternal = mesh.nInternalFaces();
    bool cyclic = false;

    // All processors have these patches, with faces or without
    for (const Foam::polyPatch& patch : patches)
    {
        cyclic = cyclic || Foam::isA<Foam::cyclicPolyPatch>(patch);
    }

    if (!cyclic)
    {
        return;
    }

    Foam::surfaceScalarField::Boundary& phib = phi.boundaryFieldRef();
    Foam::scalarList beyond(mesh.nFaces() - nInternal, Foam::Zero);

    forAll(phib, patchi)
    {
        Foam::SubList<Foam::scalar>
        (
            beyond,
            phib[patchi].size(),
            patches[patchi].start() - nInternal
        ) = phib[patchi];
    }

    Foam::syncTools::swapBoundaryFaceList(mesh, beyond);

    forAll(phib, patchi)
    {
        if (Foam::cellSearch::matched(patches[patchi]))
        {
            forAll(phib[patchi], i)
            {
                const Foam::scalar other =
                    beyond[patches[patchi].start() - nInternal + i];

                phib[patchi][i] = 0.5*(phib[patchi][i] - other);
            }
        }
    }
}

} // End anonymous namespace


void Foam::bodySums::shieldFlux(surfaceScalarField& phi) const
{
    addProfiling(shield, "immersedBodies::shieldFlux");

    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const label nInternal = mesh_.nInternalFaces();

    for (const label facei : bands_.faces())
    {
        const scalar open = 1 - faceShield_[facei];

        if (facei < nInternal)
        {
            phi[facei] = open*phi[facei] + bodyFlux_[facei];
        }
        else
        {
            const label patchi = patches.patchID()[facei - nInternal];
            scalar& patchPhi = phi.boundaryFieldRef()
                [patchi][facei - patches[patchi].start()];

            patchPhi = open*patchPhi + bodyFlux_[facei];
        }
    }

    equaliseCyclic(mesh_, phi);
    LeesEdwards::equalise(mesh_, phi);
}
