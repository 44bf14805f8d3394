// SPDX-License-Identifier: GPL-3.0-or-later

#include "lineGrid.H"
#include "tensorGrid.H"

bool Foam::lineGrid::findBox(const tensorGrid& grid, labelVector& first)
{
    const List<labelVector>& index = grid.index();

    if (index.empty())
    {
        return false;
    }

    first = index.first();
    const labelVector n(index.last() - first + labelVector::one);

    for (direction k = 0; k < 3; ++k)
    {
        lines& along = lines_[k];
        const label nx = n[0], ny = n[1];

        along.n = n[k];
        along.single = grid.n(k) == 1;
        along.step = k == 0 ? 1 : k == 1 ? nx : nx*ny;
        along.next = k == 0 ? nx : 1;
        along.slab = k == 2 ? nx : nx*ny;
        along.nLines = k == 0 ? ny : nx;
        along.nSlabs = k == 2 ? ny : n[2];

        // Fewer layers than a neighbour needs
        if (!along.single && along.n < nBeyond)
        {
            return false;
        }
    }

    if (cmptMin(n) < 1 || index.size() != n[0]*n[1]*n[2])
    {
        return false;
    }

    forAll(index, celli)
    {
        const labelVector i(index[celli] - first);

        if (celli != i[0] + n[0]*(i[1] + n[1]*i[2]))
        {
            return false;
        }
    }

    return true;
}


void Foam::lineGrid::setLayers
(
    const direction k,
    const scalarField& widths,
    const label first
)
{
    lines& along = lines_[k];
    const label n = along.n;
    const label nAll = widths.size();
    const label nKnown = n + 2*nBeyond;

    for
    (
        scalarField* values
      : {
            &along.widths, &along.low, &along.high, &along.bendLow,
            &along.bendHigh, &along.weight, &along.distance
        }
    )
    {
        *values = scalarField(nKnown, Zero);
    }

    for (label i = -nBeyond; i < n + nBeyond; ++i)
    {
        if ((i >= 0 || along.joined[0]) && (i < n || along.joined[1]))
        {
            along.widths[lines::at(i)] =
                widths[(first + i + nAll) % nAll];
        }
    }

    for (label i = 1; i < nKnown; ++i)
    {
        const scalar below = along.widths[i - 1], own = along.widths[i];

        if (below > 0 && own > 0)
        {
            along.weight[i] = own/(below + own);
            along.distance[i] = 0.5*(below + own);
            along.low[i] = -along.weight[i]/own;
            along.high[i - 1] = (1 - along.weight[i])/below;
            along.bendLow[i] = along.distance[i]/own;
            along.bendHigh[i - 1] = along.distance[i]/below;
        }
    }

    // The second difference of cells at patches is none
    const label last = lines::at(n - 1), zero = lines::at(0);

    if (!along.joined[0])
    {
        along.low[zero] = -1/along.widths[zero];
        along.bendLow[zero] = along.bendHigh[zero] = 0;
    }
    if (!along.joined[1])
    {
        along.high[last] = 1/along.widths[last];
        along.bendLow[last] = along.bendHigh[last] = 0;
    }
}


void Foam::lineGrid::findPlaces(const tensorGrid& grid)
{
    axis_.setSize(mesh_.nFaces());
    place_.setSize(mesh_.nFaces());

    for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
    {
        const label celli = mesh_.faceOwner()[facei];
        const labelVector way
        (
            grid.index()[mesh_.faceNeighbour()[facei]] - grid.index()[celli]
        );
        const direction k = way[0] != 0 ? 0 : way[1] != 0 ? 1 : 2;
        const lines& along = lines_[k];

        axis_[facei] = k;
        place_[facei] = along.face
        (
            celli/along.slab % along.nSlabs,
            celli/along.step % along.n + 1,
            celli/along.next % along.nLines
        );
    }

    for (direction k = 0; k < 3; ++k)
    {
        for (label side = 0; side < 2; ++side)
        {
            const lines& along = lines_[k];
            const labelList& faces = along.sides[side];

            forAll(faces, p)
            {
                const label facei = mesh_.nInternalFaces() + faces[p];

                axis_[facei] = k;
                place_[facei] = along.face
                (
                    p/along.nLines, side*along.n, p % along.nLines
                );
            }
        }
    }
}


Foam::lineGrid::lineGrid(const fvMesh& mesh)
:
    mesh_(mesh),
    coupled_(mesh),
    valid_(false)
{
    const tensorGrid grid(mesh);

    if (!grid.valid())
    {
        return;
    }

    labelVector first(labelVector::zero);
    bool good = findBox(grid, first);

    for (direction k = 0; k < 3 && good; ++k)
    {
        good = findSides(k);
    }
    valid_ = returnReduce(good, andOp<bool>());

    for (direction k = 0; k < 3 && valid_; ++k)
    {
        setLayers(k, grid.widths(k), first[k]);
    }
    if (valid_)
    {
        findPlaces(grid);
    }
}
