// SPDX-License-Identifier: GPL-3.0-or-later

#include "slidingPair.H"
#include "compat.H"
#include "cyclicPolyPatch.H"
#include "globalIndex.H"
#include "SubField.H"
#include "ListOps.H"

namespace
{

using namespace Foam;

//- Index of each value among the different ones, which are farther apart than
//  tolerance; sets these, in order
labelList indexSorted
(
    const scalarField& values,
    const scalar tolerance,
    DynamicList<scalar>& different
)
{
    labelList index(values.size());
    labelList order;

    sortedOrder(values, order);
    different.clear();

    for (const label i : order)
    {
        if (different.empty() || values[i] > different.last() + tolerance)
        {
            different.append(values[i]);
        }
        index[i] = different.size() - 1;
    }

    return index;
}

} // End anonymous namespace


Foam::slidingPair::faceList Foam::slidingPair::gather(const label patchi) const
{
    const polyPatch& patch = mesh_.boundaryMesh()[patchi];
    List<vectorField> centres(Pstream::nProcs()), areas(Pstream::nProcs());
    faceList all;

    centres[Pstream::myProcNo()] = patch.faceCentres();
    areas[Pstream::myProcNo()] = patch.faceAreas();
    compat::allGather(centres);
    compat::allGather(areas);
    all.first = 0;

    forAll(centres, proci)
    {
        all.first += proci < Pstream::myProcNo() ? centres[proci].size() : 0;
        all.centres.append(centres[proci]);
        all.areas.append(areas[proci]);
    }

    return all;
}


void Foam::slidingPair::findHeight
(
    const faceList& first,
    const faceList& second
)
{
    if (first.centres.empty() || first.centres.size() != second.centres.size())
    {
        refuse("need the same number of faces, and at least one");
    }

    const vector n(sum(first.areas)/sum(mag(first.areas)));

    for (const vector& area : first.areas)
    {
        if ((area & n) < (1 - 1e-6)*mag(area))
        {
            refuse("have to be plane");
        }
    }
    for (const vector& area : second.areas)
    {
        if ((area & n) > -(1 - 1e-6)*mag(area))
        {
            refuse("have to be plane, and parallel to each other");
        }
    }

    height_ = ((average(first.centres) - average(second.centres)) & n)*n;

    if ((height_ & n) < VSMALL || mag(direction_ & n) > 1e-6)
    {
        refuse("need a 'direction' along them, and the mesh between them");
    }

    // Without the rounding of the mesh
    direction_ = direction_ - (direction_ & n)*n;
    direction_ /= mag(direction_);
}


void Foam::slidingPair::checkPeriodic() const
{
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(patch))
        {
            return;
        }
    }

    refuse("need cyclic patches at both ends of 'direction'");
}


Foam::List<Foam::labelPair> Foam::slidingPair::findRows
(
    const pointField& centres
)
{
    const vector across(normalised(height_ ^ direction_));
    const scalarField x(centres & direction_), y(centres & across);
    const scalar tolerance = 1e-6*max(max(x) - min(x), max(y) - min(y));
    DynamicList<scalar> columns, rows;
    const labelList column(indexSorted(x, tolerance, columns));
    const labelList row(indexSorted(y, tolerance, rows));

    nCells_ = columns.size();

    if (nCells_ < 2 || nCells_*rows.size() != centres.size())
    {
        refuse("have to be made of rows of cells along 'direction'");
    }
    cellSize_ = (columns.last() - columns.first())/(nCells_ - 1);

    forAll(columns, i)
    {
        const scalar equal = columns[0] + i*cellSize_;

        if (mag(columns[i] - equal) > 1e-4*cellSize_)
        {
            refuse("need equal cells along 'direction'");
        }
    }

    List<labelPair> result(centres.size());

    forAll(result, i)
    {
        result[i] = labelPair(row[i], column[i]);
    }

    return result;
}


void Foam::slidingPair::setRows
(
    const List<labelPair>& faces,
    const label firstFace,
    const label nFaces,
    const List<labelPair>& others,
    const label nOthers,
    rowsBeyond& rows
) const
{
    // Faces on the other side by row and column
    labelList otherAt(others.size());
    const label nRows = others.size()/nCells_;

    forAll(others, i)
    {
        otherAt[others[i].first()*nCells_ + others[i].second()] = i;
    }

    labelList localRow(nRows, -1);
    label nLocal = 0;

    rows.places.setSize(nFaces);

    for (label i = 0; i < nFaces; ++i)
    {
        const labelPair& at = faces[firstFace + i];
        label& local = localRow[at.first()];

        if (local < 0)
        {
            local = nLocal++;
        }
        rows.places[i] = local*nCells_ + at.second();
    }

    rows.from.setSize(nLocal*nCells_);

    forAll(localRow, row)
    {
        for (label i = 0; i < nCells_ && localRow[row] >= 0; ++i)
        {
            rows.from[localRow[row]*nCells_ + i] = otherAt[row*nCells_ + i];
        }
    }

    rows.shift.reset(new rowShift(nCells_, nLocal));

    if (Pstream::parRun())
    {
        List<Map<label>> compactMap;

        rows.exchange.reset
        (
            new mapDistribute(globalIndex(nOthers), rows.from, compactMap)
        );
    }
}
