// SPDX-License-Identifier: GPL-3.0-or-later

#include "tensorGrid.H"
#include "compat.H"
#include "PstreamReduceOps.H"

namespace
{

using namespace Foam;

//- Bounds of the cells, from the points of their faces
void cellBounds(const polyMesh& mesh, vectorField& low, vectorField& high)
{
    auto include = [&](const label celli, const point& p)
    {
        low[celli] = min(low[celli], p);
        high[celli] = max(high[celli], p);
    };

    const faceList& faces = mesh.faces();

    forAll(faces, facei)
    {
        for (const label pointi : faces[facei])
        {
            include(mesh.faceOwner()[facei], mesh.points()[pointi]);

            if (mesh.isInternalFace(facei))
            {
                include(mesh.faceNeighbour()[facei], mesh.points()[pointi]);
            }
        }
    }
}


//- Sort and drop values within tolerance of the one before
void makeDistinct(scalarList& values, const scalar tolerance)
{
    sort(values);
    label n = 0;

    for (const scalar value : values)
    {
        if (n == 0 || value - values[n - 1] > tolerance)
        {
            values[n++] = value;
        }
    }

    values.setSize(n);
}


//- Distinct values over all processors, ascending
scalarList allDistinct(const scalarField& local, const scalar tolerance)
{
    List<scalarList> all(Pstream::nProcs());
    scalarList& mine = all[Pstream::myProcNo()];
    mine = local;
    makeDistinct(mine, tolerance);
    Pstream::gatherList(all);

    scalarList values;

    for (const scalarList& part : all)
    {
        values.append(part);
    }

    makeDistinct(values, tolerance);
    compat::broadcast(values);

    return values;
}


//- Place of the nearest of ascending values
label nearest(const scalarList& values, const scalar x)
{
    const auto above = std::lower_bound(values.begin(), values.end(), x);
    const label i = above - values.begin();

    return i == values.size() || (i > 0 && x - values[i - 1] < values[i] - x)
      ? i - 1 : i;
}

} // End anonymous namespace


bool Foam::tensorGrid::setWidths
(
    const vectorField& sizes,
    const label direction
)
{
    scalarField& narrowest = widths_[direction];
    scalarField widest(narrowest.size(), -GREAT);
    narrowest = GREAT;

    forAll(sizes, celli)
    {
        const label i = index_[celli][direction];
        const scalar width = sizes[celli][direction];

        narrowest[i] = min(narrowest[i], width);
        widest[i] = max(widest[i], width);
    }

    compat::allReduce(narrowest, minEqOp<scalar>());
    compat::allReduce(widest, maxEqOp<scalar>());

    return max(widest/narrowest) < 1.0001;
}


void Foam::tensorGrid::findIndices
(
    const vectorField& centres,
    const vectorField& sizes
)
{
    const label nCells = returnReduce(centres.size(), sumOp<label>());
    index_.setSize(centres.size());

    for (label d = 0; d < 3; ++d)
    {
        // Far below the distance of centres, above rounding in mesh files
        const scalar tolerance = 0.01*gMin(sizes.component(d)());

        const scalarList coordinates
        (
            allDistinct(centres.component(d)(), tolerance)
        );
        widths_[d].setSize(coordinates.size());

        forAll(centres, celli)
        {
            index_[celli][d] = nearest(coordinates, centres[celli][d]);
        }
    }

    bool regular = scalar(n(0))*n(1)*n(2) == nCells;

    for (label d = 0; regular && d < 3; ++d)
    {
        regular = setWidths(sizes, d);
    }

    if (!regular)
    {
        reason_ = "the mesh is no box with the same cells in every row";
    }
}


Foam::tensorGrid::tensorGrid(const polyMesh& mesh)
{
    vectorField low(mesh.nCells(), vector::uniform(GREAT));
    vectorField high(mesh.nCells(), vector::uniform(-GREAT));
    cellBounds(mesh, low, high);

    const vectorField sizes(high - low);
    bool boxes = true;

    forAll(sizes, celli)
    {
        const vector& size = sizes[celli];
        const scalar volume = size.x()*size.y()*size.z();
        boxes = boxes && mag(volume/mesh.cellVolumes()[celli] - 1) < 1e-6;
    }

    if (!returnReduce(boxes, andOp<bool>()))
    {
        reason_ = "cells of the mesh are no boxes along the axes";
        return;
    }

    findIndices(0.5*(low + high), sizes);
}


Foam::scalar Foam::tensorGrid::area
(
    const labelVector& index,
    const label direction
) const
{
    const label d1 = (direction + 1) % 3;
    const label d2 = (direction + 2) % 3;

    return widths_[d1][index[d1]]*widths_[d2][index[d2]];
}


Foam::scalar Foam::tensorGrid::volume(const labelVector& index) const
{
    return area(index, 0)*widths_[0][index[0]];
}


std::string Foam::tensorGrid::description() const
{
    return std::to_string(n(0)) + " x " + std::to_string(n(1)) + " x "
      + std::to_string(n(2));
}
