// SPDX-License-Identifier: GPL-3.0-or-later

#include "grainShare.H"

const Foam::label Foam::grainShare::fewest;


void Foam::grainShare::divide(const labelUList& owners, const label nGrains)
{
    const label nRanks = Pstream::nProcs();

    owners_.clear();
    spread_ = nullptr;

    if (!Pstream::parRun() || nGrains < fewest*nRanks)
    {
        return;
    }
    owners_ = owners;
    list();
}


void Foam::grainShare::divide(const bodyShare& spread)
{
    owners_ = spread.owners();
    spread_ = &spread;
    list();
}


void Foam::grainShare::list()
{
    labelList sizes(Pstream::nProcs(), 0);

    for (const label rank : owners_)
    {
        if (rank >= 0)
        {
            ++sizes[rank];
        }
    }
    start_ = offsets(sizes);
    given_.setSize(start_.last());

    labelList next(start_);

    forAll(owners_, i)
    {
        if (owners_[i] >= 0)
        {
            given_[next[owners_[i]]++] = i;
        }
    }
}


Foam::SubList<Foam::label> Foam::grainShare::own() const
{
    const label me = Pstream::myProcNo();

    return SubList<label>(given_, start_[me + 1] - start_[me], start_[me]);
}
