// SPDX-License-Identifier: GPL-3.0-or-later

#include "grainShare.H"
#include <algorithm>

const Foam::label Foam::grainShare::fewest;


void Foam::grainShare::divide(const label nBodies, const label nGrains)
{
    const label nRanks = Pstream::nProcs();

    start_.clear();

    if (Pstream::parRun() && nGrains >= fewest*nRanks)
    {
        start_.setSize(nRanks + 1);

        forAll(start_, rank)
        {
            start_[rank] = label(scalar(rank)/nRanks*nBodies + 0.5);
        }
    }
}


Foam::label Foam::grainShare::owner(const label bodyi) const
{
    return
        std::upper_bound(start_.begin(), start_.end(), bodyi)
      - start_.begin() - 1;
}


bool Foam::grainShare::mine(const label bodyi) const
{
    const label me = Pstream::myProcNo();

    return start_.empty() || (bodyi >= start_[me] && bodyi < start_[me + 1]);
}


void Foam::grainShare::add
(
    const UList<scalar>& numbered,
    const label n,
    scalarField& values
)
{
    for (label k = 0; k < numbered.size(); k += n + 1)
    {
        const label bodyi = label(numbered[k]);

        for (label i = 0; i < n; ++i)
        {
            values[n*bodyi + i] += numbered[k + 1 + i];
        }
    }
}
