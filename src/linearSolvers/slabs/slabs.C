// SPDX-License-Identifier: GPL-3.0-or-later

#include "slabs.H"
#include "compat.H"
#include "ListOps.H"
#include "PstreamReduceOps.H"


Foam::slabs::slabs(const tensorGrid& grid, const label direction)
:
    direction_(direction),
    start_(Pstream::nProcs() + 1, 0),
    mine_(0),
    moved_(0)
{
    const label n = grid.n(direction), me = Pstream::myProcNo();
    scalarList centre(Pstream::nProcs(), Zero), nCells(centre);

    for (const labelVector& index : grid.index())
    {
        centre[me] += index[direction];
    }

    nCells[me] = grid.index().size();
    centre[me] = nCells[me] > 0 ? centre[me]/nCells[me] : GREAT;
    compat::allReduce(centre, plusEqOp<scalar>());
    compat::allReduce(nCells, plusEqOp<scalar>());
    sortedOrder(centre, processor_);
    mine_ = processor_.find(me);

    scalar nBefore = 0;

    for (label i = 0; i < size(); ++i)
    {
        nBefore += nCells[processor_[i]];
        start_[i + 1] = round(n*nBefore/grid.nCells());
    }

    if (!valid())
    {
        for (label i = 0; i <= size(); ++i)
        {
            start_[i] = n*i/size();
        }
    }

    for (const labelVector& index : grid.index())
    {
        moved_ += slabOf(index[direction]) == mine_ ? 0 : 1;
    }

    reduce(moved_, sumOp<scalar>());
    moved_ /= grid.nCells();
}


bool Foam::slabs::valid() const
{
    for (label i = 0; i < size(); ++i)
    {
        if (size() > 1 && start_[i + 1] - start_[i] < 2)
        {
            return false;
        }
    }

    return true;
}


Foam::label Foam::slabs::slabOf(const label layer) const
{
    return std::upper_bound(start_.begin(), start_.end(), layer)
      - start_.begin() - 1;
}
