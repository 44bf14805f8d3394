// SPDX-License-Identifier: GPL-3.0-or-later

#include "tubeGrid.H"
#include "cyclicFvPatch.H"
#include "surfaceFields.H"
#include "volFields.H"
#include "SortableList.H"

namespace
{
    //- Difference of places that are the same, over the length of the mesh
    const Foam::scalar same = 1e-6;
}


Foam::tubeGrid::tubeGrid(const fvMesh& mesh)
:
    nx_(0),
    ny_(0)
{
    if (Pstream::parRun())
    {
        why_ = "there are several processors";
    }
    else if (mesh.nGeometricD() != 2 || mesh.geometricD().z() > 0)
    {
        why_ = "the mesh is not one of the x-y plane";
    }
    else if (!findCells(mesh))
    {
        why_ = "the mesh is no box with equal columns of cells along x";
    }
    else if (!findFaces(mesh))
    {
        why_ = "its ends along x are not cyclic";
    }
}


bool Foam::tubeGrid::findCells(const fvMesh& mesh)
{
    const vectorField& C = mesh.cellCentres();
    const scalar span = mag(mesh.bounds().span());
    const label n = mesh.nCells();

    // Places of rows and columns
    const auto count = [&](const direction cmpt, labelList& number)
    {
        SortableList<scalar> x(C.component(cmpt)());
        label k = -1;
        scalar last = -GREAT;
        number.setSize(n);

        forAll(x, i)
        {
            if (x[i] > last + same*span)
            {
                ++k;
                last = x[i];
            }
            number[x.indices()[i]] = k;
        }

        return k + 1;
    };

    nx_ = count(0, columns_);
    ny_ = count(1, rows_);

    if (nx_*ny_ != n)
    {
        return false;
    }

    cells_ = labelList(n, -1);

    forAll(columns_, celli)
    {
        cells_[rows_[celli]*nx_ + columns_[celli]] = celli;
    }

    const scalar h = (max(C.component(0)) - min(C.component(0)))/(nx_ - 1);

    for (label at = 0; at < n; ++at)
    {
        // Cells are equal along a row
        if
        (
            cells_[at] < 0
         || mag(mesh.V()[cells_[at]]/mesh.V()[cells_[at - at % nx_]] - 1) > same
         || mag
            (
                C[cells_[at]].x() - C[cells_[0]].x() - h*(at % nx_)
            ) > same*span
        )
        {
            return false;
        }
    }

    return true;
}


void Foam::tubeGrid::setFace
(
    const fvMesh& mesh,
    const label facei,
    const label celli,
    const scalar side
)
{
    const vector n(side*mesh.faceAreas()[facei]);
    const label at = rows_[celli]*nx_ + columns_[celli];

    if (mag(n.x()) > mag(n.y()) && n.x() > 0)
    {
        east_[at] = facei;
        eastSign_[at] = side;
    }
    else if (mag(n.y()) > mag(n.x()) && n.y() > 0)
    {
        north_[at] = facei;
        northSign_[at] = side;
    }
}


bool Foam::tubeGrid::findFaces(const fvMesh& mesh)
{
    east_ = labelList(mesh.nCells(), -1);
    north_ = east_;
    eastSign_ = scalarList(mesh.nCells(), scalar(1));
    northSign_ = eastSign_;

    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        setFace(mesh, facei, mesh.faceOwner()[facei], 1);
        setFace(mesh, facei, mesh.faceNeighbour()[facei], -1);
    }

    for (const fvPatch& patch : mesh.boundary())
    {
        if (isA<cyclicFvPatch>(patch))
        {
            forAll(patch, i)
            {
                setFace(mesh, patch.start() + i, patch.faceCells()[i], 1);
            }
        }
    }

    for (label at = 0; at < mesh.nCells(); ++at)
    {
        if (east_[at] < 0 || (at < (ny_ - 1)*nx_ && north_[at] < 0))
        {
            return false;
        }
    }

    return true;
}
