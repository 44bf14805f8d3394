// SPDX-License-Identifier: GPL-3.0-or-later

#include "lineDisplacements.H"

Foam::lineDisplacements::lineDisplacements(const lineGrid& grid)
:
    grid_(grid)
{
    for (direction k = 0; k < 3; ++k)
    {
        const lineGrid::lines& along = grid.along(k);

        across_[k].values = scalarField(along.nSlabs*along.nFaces(), Zero);
        across_[k].slabs = bitSet(along.nSlabs);
    }
}


void Foam::lineDisplacements::setFaces(const labelUList& faces)
{
    for (facesAcross& across : across_)
    {
        UIndirectList<scalar>(across.values, across.place) = 0;
        across.index.clear();
        across.place.clear();
        across.slabs.reset();
    }

    forAll(faces, i)
    {
        const direction k = grid_.axis(faces[i]);
        const label place = grid_.place(faces[i]);

        across_[k].index.append(i);
        across_[k].place.append(place);
        across_[k].slabs.set(place/grid_.along(k).nFaces());
    }
}


void Foam::lineDisplacements::set(const UList<vector>& s)
{
    for (direction k = 0; k < 3; ++k)
    {
        facesAcross& across = across_[k];

        forAll(across.index, j)
        {
            across.values[across.place[j]] = s[across.index[j]][k];
        }
    }
}
