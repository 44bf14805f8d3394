// SPDX-License-Identifier: GPL-3.0-or-later

#include "lineRemap.H"
#include "lineSweep.H"

Foam::lineRemap::lineRemap(autoPtr<lineGrid>&& grid)
:
    grid_(std::move(grid)),
    cells_(identity(grid_->mesh().nCells())),
    s_(grid_())
{}


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
            along.forCells
            (
                slabi,
                [&](const label celli, const label layer, const label line)
                {
                    grad[celli][k] = slab.derivative(layer, line);
                }
            );
        }
    }

    return grad;
}
