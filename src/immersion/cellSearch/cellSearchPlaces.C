// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellSearch.H"
#include <algorithm>

const Foam::pointGrid& Foam::cellSearch::grid() const
{
    if (!gridPtr_.valid())
    {
        const scalar side = h_.size() ? average(h_) : 1;

        gridPtr_.reset(new pointGrid(mesh_.cellCentres(), side));
    }

    return *gridPtr_;
}


Foam::labelList Foam::cellSearch::cellsAround
(
    const point& x,
    const scalar radius
) const
{
    const pointField& C = mesh_.cellCentres();
    DynamicList<label> cells;

    grid().forNear
    (
        x,
        radius,
        [&](const label celli)
        {
            if (magSqr(C[celli] - x) < sqr(radius))
            {
                cells.append(celli);
            }
        }
    );
    Foam::sort(cells);

    return labelList(std::move(cells));
}


Foam::label Foam::cellSearch::nearest(const point& x) const
{
    const pointField& C = mesh_.cellCentres();
    label found = -1;

    for (scalar r = grid().side(); found < 0 && r < GREAT; r *= 2)
    {
        for (const label celli : cellsAround(x, r))
        {
            if (found < 0 || magSqr(C[celli] - x) < magSqr(C[found] - x))
            {
                found = celli;
            }
        }
    }

    return found;
}


bool Foam::cellSearch::contains(const label celli, const point& x) const
{
    const scalar tolerance = 1e-9*h_[celli];

    for (const label facei : mesh_.cells()[celli])
    {
        const vector& Sf = mesh_.faceAreas()[facei];
        const scalar beyond = (x - mesh_.faceCentres()[facei]) & Sf;
        const bool owner = mesh_.faceOwner()[facei] == celli;

        if ((owner ? beyond : -beyond) > tolerance*mag(Sf))
        {
            return false;
        }
    }

    return true;
}


Foam::label Foam::cellSearch::findCell(const point& x) const
{
    const label first = bounds_.contains(x) ? nearest(x) : -1;

    if (first < 0 || contains(first, x))
    {
        return first;
    }

    // Next to smaller cells, whose centres are nearer
    for (const label celli : cellsAround(x, 4*hMax(first)))
    {
        if (contains(celli, x))
        {
            return celli;
        }
    }

    return -1;
}


Foam::labelList Foam::cellSearch::cellsAt(const point& x) const
{
    const label first = findCell(x);
    DynamicList<label> cells;

    if (first >= 0)
    {
        for (const label celli : cellsAround(x, 4*hMax(first)))
        {
            if (celli == first || contains(celli, x))
            {
                cells.append(celli);
            }
        }
    }

    return labelList(std::move(cells));
}
