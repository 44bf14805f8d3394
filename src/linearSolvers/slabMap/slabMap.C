// SPDX-License-Identifier: GPL-3.0-or-later

#include "slabMap.H"
#include "exchange.H"
#include "IndirectList.H"
#include "ListOps.H"
#include "PstreamReduceOps.H"


void Foam::slabMap::distribute
(
    labelList& places,
    const labelList& processors
)
{
    labelList nSend(Pstream::nProcs(), 0), nReceive(nSend);

    for (const label proci : processors)
    {
        ++nSend[proci];
    }

    if (Pstream::parRun())
    {
        UPstream::allToAll(nSend, nReceive);
    }
    else
    {
        nReceive = nSend;
    }

    sendStart_ = offsets(nSend);
    receiveStart_ = offsets(nReceive);
    local_ = returnReduce
    (
        nSend[Pstream::myProcNo()] == processors.size()
     && nSend == nReceive,
        andOp<bool>()
    );

    if (!local_)
    {
        // Stable: in the order of the cells, to each processor
        sortedOrder(processors, cells_);
        places = labelList(IndirectList<label>(places, cells_));
    }

    places_.setSize(receiveStart_.last());
    exchange(places, sendStart_, places_, receiveStart_);
}


Foam::labelList Foam::slabMap::tiled(const tensorGrid& grid) const
{
    const label side = 8;
    List<labelVector> tiles(grid.index());
    labelList order;

    for (labelVector& tile : tiles)
    {
        tile.x() /= side;
        tile.y() /= side;
    }

    // Stable: in the order of the cells within a tile
    sortedOrder
    (
        tiles,
        order,
        [&](const label i, const label j)
        {
            const labelVector& a = tiles[i];
            const labelVector& b = tiles[j];

            return
                a.z() != b.z() ? a.z() < b.z()
              : a.y() != b.y() ? a.y() < b.y()
              : a.x() < b.x();
        }
    );

    return order;
}


Foam::slabMap::slabMap(const tensorGrid& grid, const slabs& parts)
{
    const label t = parts.direction();
    const label a = (t == 0 ? 1 : 0), b = (t == 2 ? 1 : 2);
    const label n = grid.index().size();

    labelList places(n), processors(n);
    scalarField weights(n);

    forAll(places, celli)
    {
        const labelVector& i = grid.index()[celli];
        const label slab = parts.slabOf(i[t]);

        processors[celli] = parts.processor(slab);
        places[celli] =
            ((i[t] - parts.start(slab))*grid.n(b) + i[b])*grid.n(a) + i[a];
        weights[celli] = 1/sqrt(grid.volume(i));
    }

    cells_ = identity(n);
    distribute(places, processors);
    inOrder_ = local_ && places_ == cells_;

    if (local_ && t == 0)
    {
        cells_ = tiled(grid);
        places_ = labelList(IndirectList<label>(places, cells_));
    }
    weights_ = scalarField(weights, cells_);
    sent_.setSize(local_ ? 0 : n);
    received_.setSize(local_ ? 0 : places_.size());
}


void Foam::slabMap::toSlab(const scalarField& cellValues, scalar* v) const
{
    if (inOrder_)
    {
        forAll(cellValues, celli)
        {
            v[celli] = weights_[celli]*cellValues[celli];
        }
        return;
    }
    if (local_)
    {
        forAll(cells_, i)
        {
            v[places_[i]] = weights_[i]*cellValues[cells_[i]];
        }
        return;
    }

    forAll(cells_, i)
    {
        sent_[i] = weights_[i]*cellValues[cells_[i]];
    }

    exchange(sent_, sendStart_, received_, receiveStart_);

    forAll(places_, i)
    {
        v[places_[i]] = received_[i];
    }
}


void Foam::slabMap::fromSlab
(
    const scalar* v,
    const scalar factor,
    scalarField& cellValues
) const
{
    if (inOrder_)
    {
        forAll(cellValues, celli)
        {
            cellValues[celli] = factor*weights_[celli]*v[celli];
        }
        return;
    }
    if (local_)
    {
        forAll(cells_, i)
        {
            cellValues[cells_[i]] = factor*weights_[i]*v[places_[i]];
       }
        return;
    }

    forAll(places_, i)
    {
        received_[i] = v[places_[i]];
    }

    exchange(received_, receiveStart_, sent_, sendStart_);

    forAll(cells_, i)
    {
        cellValues[cells_[i]] = factor*weights_[i]*sent_[i];
    }
}
