// SPDX-License-Identifier: GPL-3.0-or-later

#include "lineRemap.H"
#include "lineSweep.H"

Foam::lineRemap::lineRemap(autoPtr<lineGrid>&& grid)
:
    grid_(std::move(grid)),
    cells_(identity(grid_->mesh().nCells()))
{}


Foam::FixedList<Foam::lineRemap::displacements, 3>
Foam::lineRemap::sorted(const UList<vector>& s) const
{
    FixedList<displacements, 3> all;

    for (direction k = 0; k < 3; ++k)
    {
        const lineGrid::lines& along = grid_->along(k);

        all[k].faces = scalarField(along.nSlabs*along.nFaces(), Zero);
        all[k].slabs = bitSet(along.nSlabs);
    }

    forAll(faces_, i)
    {
        const direction k = grid_->axis(faces_[i]);

        if (s[i][k] != 0)
        {
            const label place = grid_->place(faces_[i]);

            all[k].faces[place] = s[i][k];
            all[k].slabs.set(place/grid_->along(k).nFaces());
        }
    }

    return all;
}


Foam::vectorField Foam::lineRemap::gradients(const volScalarField& y) const
{
    vectorField grad(cells_.size(), Zero);

    for (direction k = 0; k < 3; ++k)
    {
        const lineGrid::lines& along = grid_->along(k);

        if (along.single)
        {
            continue;
        }

        const auto value = [&](const label celli) { return y[celli]; };
        lineGrid::ends beyond;
        lineSweep slab(along);

        grid_->findEnds(k, value, onPatches(y, 0), beyond);

        for (label slabi = 0; slabi < along.nSlabs; ++slabi)
        {
            slab.load(slabi, value, beyond);
            slab.differentiate();

            for (label layer = 0; layer < along.n; ++layer)
            {
                const label celli = along.cell(slabi, layer, 0);

                for (label line = 0; line < along.nLines; ++line)
                {
                    grad[celli + line*along.next][k] =
                        slab.derivative(layer)[line];
                }
            }
        }
    }

    return grad;
}
