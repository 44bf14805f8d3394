// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceGradient.H"
#include "surfaceFields.H"

namespace
{

using namespace Foam;

//- U, in the cells at the patch that on the patch
tmp<volVectorField> raised(const volVectorField& U, const label patchi)
{
    const fvMesh& mesh = U.mesh();
    const fvPatchVectorField& Up = U.boundaryField()[patchi];
    const labelUList& cells = Up.patch().faceCells();

    tmp<volVectorField> tV
    (
        new volVectorField
        (
            IOobject("raisedU", mesh.time().timeName(), mesh),
            mesh,
            dimensionedVector(U.dimensions(), Zero)
        )
    );
    volVectorField& V = tV.ref();
    scalarField nFaces(mesh.nCells(), Zero);

    forAll(cells, facei)
    {
        V[cells[facei]] += Up[facei];
        nFaces[cells[facei]] += 1;
    }

    forAll(nFaces, celli)
    {
        V[celli] = nFaces[celli] > 0 ? V[celli]/nFaces[celli] : U[celli];
    }
    V.correctBoundaryConditions();

    // Values of other patches, beside those that are coupled
    forAll(V.boundaryField(), patchj)
    {
        fvPatchVectorField& Vp = V.boundaryFieldRef()[patchj];

        if (!Vp.coupled())
        {
            Vp == U.boundaryField()[patchj];
        }
        else
        {
            const scalarField w(Vp.patch().weights());
            const vectorField inside(Vp.patchInternalField());
            const vectorField across(Vp.patchNeighbourField());

            Vp == w*inside + (1 - w)*across;
        }
    }

    return tV;
}


//- Value of V on a face of the mesh, and the area vector of that face
Tuple2<vector, vector> onFace
(
    const volVectorField& V,
    const label facei
)
{
    const fvMesh& mesh = V.mesh();

    if (mesh.isInternalFace(facei))
    {
        const scalar w = mesh.weights()[facei];

        return Tuple2<vector, vector>
        (
            w*V[mesh.owner()[facei]] + (1 - w)*V[mesh.neighbour()[facei]],
            mesh.Sf()[facei]
        );
    }

    const label patchj = mesh.boundaryMesh().whichPatch(facei);
    const fvPatchVectorField& Vp = V.boundaryField()[patchj];

    // Of an empty patch it has no faces
    if (Vp.empty())
    {
        return Tuple2<vector, vector>(Zero, Zero);
    }

    const label i = facei - mesh.boundaryMesh()[patchj].start();

    return Tuple2<vector, vector>
    (
        Vp[i],
        mesh.Sf().boundaryField()[patchj][i]
    );
}

} // End anonymous namespace


Foam::tmp<Foam::tensorField> Foam::surfaceGradient::calculate
(
    const volVectorField& U,
    const label patchi
)
{
    const fvMesh& mesh = U.mesh();
    const fvPatch& patch = mesh.boundary()[patchi];
    const tmp<volVectorField> tV(raised(U, patchi));
    const volVectorField& V = tV();
    const vectorField n(patch.nf());

    tmp<tensorField> tG(new tensorField(patch.size(), Zero));
    tensorField& G = tG.ref();

    forAll(G, i)
    {
        const label celli = patch.faceCells()[i];

        for (const label facei : mesh.cells()[celli])
        {
            const Tuple2<vector, vector> face(onFace(V, facei));
            const bool out =
                !mesh.isInternalFace(facei) || mesh.owner()[facei] == celli;

            G[i] +=
                (out ? 1 : -1)*face.second()*(face.first() - V[celli])
               /mesh.V()[celli];
        }

        G[i] = G[i] - n[i]*(n[i] & G[i]);
    }

    return tG;
}
