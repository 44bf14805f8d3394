// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellSearch.H"
#include "linear.H"
#include "processorPolyPatch.H"
#include "surfaceInterpolate.H"
#include "zeroGradientFvPatchFields.H"

Foam::cellSearch::cellSearch(const fvMesh& mesh, const geometricSpace& space)
:
    mesh_(mesh),
    h_(mesh.nCells()),
    faceH_(mesh.nFaces()),
    faceMet_(mesh.nFaces())
{
    forAll(h_, celli)
    {
        h_[celli] = space.cellSize(mesh.V()[celli]);
    }

    volScalarField h
    (
        IOobject("cellSize", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimLength, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
    h.primitiveFieldRef() = h_;
    h.correctBoundaryConditions();

    const surfaceScalarField hf(linearInterpolate(h));

    SubList<scalar>(faceH_, mesh.nInternalFaces()) = hf.primitiveField();

    forAll(hf.boundaryField(), patchi)
    {
        const scalarField& patchH = hf.boundaryField()[patchi];
        const label start = mesh.boundaryMesh()[patchi].start();

        forAll(patchH, i)
        {
            faceH_[start + i] = patchH[i];
        }
    }
}


const Foam::indexedOctree<Foam::treeDataPoint>& Foam::cellSearch::tree() const
{
    if (!treePtr_.valid())
    {
        // Somewhat larger than the centres' box, so that none is on its edge
        treeBoundBox box(mesh_.cellCentres());
        box.inflate(1e-3);
        box.min() -= point::uniform(SMALL);
        box.max() += point::uniform(SMALL);

        treePtr_.reset
        (
            new indexedOctree<treeDataPoint>
            (
                treeDataPoint(mesh_.cellCentres()), box, 12, 10, 3
            )
        );
    }

    return *treePtr_;
}


Foam::labelList Foam::cellSearch::cellsAround
(
    const point& x,
    const scalar radius
) const
{
    const vector extent(vector::uniform(radius));

    labelList cells(tree().findBox(treeBoundBox(x - extent, x + extent)));

    // The tree's order depends on its history; sums over the cells must not,
    // or a restarted run would differ in the last bit
    Foam::sort(cells);

    return cells;
}


Foam::labelList Foam::cellSearch::facesOf(const labelUList& cells) const
{
    const cellList& cellFaces = mesh_.cells();
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    DynamicList<label> faces(4*cells.size());

    for (const label celli : cells)
    {
        for (const label facei : cellFaces[celli])
        {
            const bool counts =
                mesh_.isInternalFace(facei)
             || isA<processorPolyPatch>(patches[patches.whichPatch(facei)]);

            if (counts && faceMet_.set(facei))
            {
                faces.append(facei);
            }
        }
    }

    for (const label facei : faces)
    {
        faceMet_.unset(facei);
    }

    return labelList(std::move(faces));
}
