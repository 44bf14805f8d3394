// SPDX-License-Identifier: GPL-3.0-or-later

#include "rankBounds.H"
#include "compat.H"
#include "fvMesh.H"

Foam::rankBounds::rankBounds(const fvMesh& mesh)
:
    bounds_(Pstream::nProcs())
{
    bounds_[Pstream::myProcNo()] = boundBox(mesh.cellCentres(), false);
    compat::allGather(bounds_);
}


Foam::label Foam::rankBounds::nearest(const point& x) const
{
    label closest = 0;
    scalar least = GREAT;

    forAll(bounds_, rank)
    {
        if (bounds_[rank].valid() && distance(rank, x) < least)
        {
            closest = rank;
            least = distance(rank, x);
        }
    }

    return closest;
}


Foam::labelList Foam::rankBounds::reached
(
    const point& x,
    const scalar radius,
    const periodicity& periods
) const
{
    DynamicList<label> ranks;
    const List<periodicity::image> images(periods.globalImages(x, radius));

    forAll(bounds_, rank)
    {
        bool reached = false;

        // overlaps() finds all points within bounds that are inverted
        for (label i = 0; i < images.size() && bounds_[rank].valid(); ++i)
        {
            reached = reached
             || bounds_[rank].overlaps(x + images[i].shift, sqr(radius));
        }
        if (reached)
        {
            ranks.append(rank);
        }
    }

    return ranks;
}


Foam::labelList Foam::rankBounds::others
(
    const point& x,
    const scalar radius,
    const periodicity& periods
) const
{
    DynamicList<label> ranks;

    if (bounds_.size() == 1)
    {
        return ranks;
    }

    for (const label rank : reached(x, radius, periods))
    {
        if (rank != Pstream::myProcNo())
        {
            ranks.append(rank);
        }
    }

    return ranks;
}
