// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceGradient.H"
#include "surfaceFields.H"
#include "syncTools.H"

namespace
{

using namespace Foam;

//- The velocity U, with that on a patch in place of it in the cells there
class raisedField
{
    const fvMesh& mesh_;

    const volVectorField& U_;

    //- Mean velocity [m/s] on the faces of the patch, by cell
    Map<vector> atPatch_;

    //- Velocity [m/s] in the cells beyond coupled patches, by boundary face;
    //  empty if there are no such patches
    vectorField beyond_;


    //- Set beyond_. Collective.
    void exchange()
    {
        // Cyclic patches are on all processors
        bool any = Pstream::parRun();

        for (const fvPatch& patch : mesh_.boundary())
        {
            any = any || patch.coupled();
        }

        if (!any)
        {
            return;
        }

        beyond_.resize(mesh_.nFaces() - mesh_.nInternalFaces(), Zero);

        for (const fvPatch& patch : mesh_.boundary())
        {
            if (patch.coupled())
            {
                const label start = patch.start() - mesh_.nInternalFaces();

                forAll(patch, i)
                {
                    beyond_[start + i] = inCell(patch.faceCells()[i]);
                }
            }
        }
        syncTools::swapBoundaryFaceList(mesh_, beyond_);
    }

public:

    raisedField(const volVectorField& U, const label patchi)
    :
        mesh_(U.mesh()),
        U_(U)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        const labelUList& cells = Up.patch().faceCells();
        Map<scalar> nFaces(2*cells.size());

        atPatch_.resize(2*cells.size());

        forAll(cells, facei)
        {
            atPatch_(cells[facei], Zero) += Up[facei];
            nFaces(cells[facei], 0) += 1;
        }
        forAllIters(atPatch_, iter)
        {
            iter.val() /= nFaces[iter.key()];
        }
        exchange();
    }

    //- Value in a cell [m/s]
    const vector& inCell(const label celli) const
    {
        const auto iter = atPatch_.cfind(celli);

        return iter.found() ? iter.val() : U_[celli];
    }

    //- Area vector of a face of a cell, outward, times what the value on it is
    //  more than that in the cell [m3/s]
    tensor flux(const label facei, const label celli) const
    {
        if (mesh_.isInternalFace(facei))
        {
            const label own = mesh_.owner()[facei];
            const scalar w = mesh_.weights()[facei];
            const vector value
            (
                w*inCell(own) + (1 - w)*inCell(mesh_.neighbour()[facei])
            );

            return (own == celli ? 1 : -1)*mesh_.Sf()[facei]
               *(value - inCell(celli));
        }

        const label patchj = mesh_.boundaryMesh().whichPatch(facei);
        const fvPatchVectorField& Up = U_.boundaryField()[patchj];

        // Of an empty patch it has no faces
        if (Up.empty())
        {
            return tensor::zero;
        }

        const label i = facei - Up.patch().start();
        const scalar w = mesh_.weights().boundaryField()[patchj][i];
        const vector value
        (
            Up.coupled()
          ? w*inCell(celli)
          + (1 - w)*beyond_[facei - mesh_.nInternalFaces()]
          : Up[i]
        );

        return mesh_.Sf().boundaryField()[patchj][i]*(value - inCell(celli));
    }
};

} // End anonymous namespace


Foam::tmp<Foam::tensorField> Foam::surfaceGradient::calculate
(
    const volVectorField& U,
    const label patchi
)
{
    const fvMesh& mesh = U.mesh();
    const fvPatch& patch = mesh.boundary()[patchi];
    const raisedField V(U, patchi);
    const vectorField n(patch.nf());

    tmp<tensorField> tG(new tensorField(patch.size(), Zero));
    tensorField& G = tG.ref();

    forAll(G, i)
    {
        const label celli = patch.faceCells()[i];

        for (const label facei : mesh.cells()[celli])
        {
            G[i] += V.flux(facei, celli)/mesh.V()[celli];
        }

        G[i] = G[i] - n[i]*(n[i] & G[i]);
    }

    return tG;
}
