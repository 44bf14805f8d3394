// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedRegion.H"
#include "cyclicPolyPatch.H"
#include "LeesEdwardsFlux.H"
#include "profiling.H"
#include "syncTools.H"

void Foam::immersedRegion::penalise
(
    const volScalarField& A0,
    const vectorField& gradP,
    fvVectorMatrix& E,
    replacedCoeffs& replaced
) const
{
    addProfiling(penalise, "immersedBodies::penalise");

    const scalarField& V = mesh_.V();
    const scalarField& K = K_;

    // Both, as the scaled matrix is not symmetric even where E0 is
    scalarField& lower = E.lower();
    scalarField& upper = E.upper();
    scalarField& diag = E.diag();
    vectorField& source = E.source();

    replaced.rows.clear();
    replaced.patches.clear();

    for (const label celli : cells())
    {
        const scalar scale = A0[celli]/(A0[celli] + K[celli]);

        replaced.rows.append(diag[celli]);
        diag[celli] = scale*(diag[celli] + V[celli]*K[celli]);
        source[celli] = scale
           *(
                source[celli]
              + V[celli]
               *(
                    KU_[celli] + shield_[celli]*gradP[celli]
                  + shieldDU_[celli]
                )
            );

        for (const auto& n : neighbours_.of(celli))
        {
            scalar& coeff = (n.owner() ? upper : lower)[n.face()];

            replaced.rows.append(coeff);
            coeff *= scale;
        }

        for (const auto& face : neighbours_.onPatches(celli))
        {
            vector& internal = E.internalCoeffs()[face.patch][face.face];
            vector& boundary = E.boundaryCoeffs()[face.patch][face.face];

            replaced.patches.append(internal);
            replaced.patches.append(boundary);
            internal *= scale;
            boundary *= scale;
        }
    }
}


void Foam::immersedRegion::unpenalise
(
    const replacedCoeffs& replaced,
    fvVectorMatrix& E
) const
{
    scalarField& lower = E.lower();
    scalarField& upper = E.upper();
    scalarField& diag = E.diag();
    label row = 0, patch = 0;

    for (const label celli : cells())
    {
        diag[celli] = replaced.rows[row++];

        for (const auto& n : neighbours_.of(celli))
        {
            (n.owner() ? upper : lower)[n.face()] = replaced.rows[row++];
        }

        for (const auto& face : neighbours_.onPatches(celli))
        {
            E.internalCoeffs()[face.patch][face.face] =
                replaced.patches[patch++];
            E.boundaryCoeffs()[face.patch][face.face] =
                replaced.patches[patch++];
        }
    }
}


void Foam::immersedRegion::shieldFlux(surfaceScalarField& phi) const
{
    addProfiling(shield, "immersedBodies::shieldFlux");

    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    for (const label facei : faces())
    {
        const scalar open = 1 - faceShield_[facei];

        if (mesh_.isInternalFace(facei))
        {
            phi[facei] = open*phi[facei] + bodyFlux_[facei];
        }
        else
        {
            const label patchi = patchOf(facei);
            scalar& patchPhi = phi.boundaryFieldRef()
                [patchi][facei - patches[patchi].start()];

            patchPhi = open*patchPhi + bodyFlux_[facei];
        }
    }

    equaliseCyclic(phi);
    LeesEdwards::equalise(mesh_, phi);
}


void Foam::immersedRegion::equaliseCyclic(surfaceScalarField& phi) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const label nInternal = mesh_.nInternalFaces();
    bool cyclic = false;

    // All processors have these patches, with faces or without
    for (const polyPatch& patch : patches)
    {
        cyclic = cyclic || isA<cyclicPolyPatch>(patch);
    }

    if (!cyclic)
    {
        return;
    }

    surfaceScalarField::Boundary& phib = phi.boundaryFieldRef();
    scalarList beyond(mesh_.nFaces() - nInternal, Zero);

    forAll(phib, patchi)
    {
        SubList<scalar>
        (
            beyond,
            phib[patchi].size(),
            patches[patchi].start() - nInternal
        ) = phib[patchi];
    }

    syncTools::swapBoundaryFaceList(mesh_, beyond);

    forAll(phib, patchi)
    {
        if (cellSearch::matched(patches[patchi]))
        {
            forAll(phib[patchi], i)
            {
                const scalar other =
                    beyond[patches[patchi].start() - nInternal + i];

                phib[patchi][i] = 0.5*(phib[patchi][i] - other);
            }
        }
    }
}
