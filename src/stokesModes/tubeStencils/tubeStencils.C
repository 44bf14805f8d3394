// SPDX-License-Identifier: GPL-3.0-or-later

#include "tubeStencils.H"

Foam::tubeStencils::tubeStencils
(
    stokesEquations& equations,
    const tubeGrid& grid
)
:
    ny_(grid.ny()),
    values_(nResults*3*ny_*width*width, Zero)
{
    equations.setBodies(nullptr);

    for (label k = 0; k < 3; ++k)
    {
        for (label first = 0; first <= width; ++first)
        {
            probe(equations, grid, k, first);
        }
    }
}


void Foam::tubeStencils::probe
(
    stokesEquations& equations,
    const tubeGrid& grid,
    const label k,
    const label first
)
{
    const label n = equations.mesh().nCells();
    const label i0 = grid.nx()/2;
    scalarField x(3*n, Zero);

    for (label j = first; j < ny_; j += width + 1)
    {
        x[k*n + grid.cell(i0, j)] = 1;
    }

    const scalarField y(equations.multiply(x));
    autoPtr<stokesFlow> flow(equations.flow(x, false));

    for (label j = first; j < ny_; j += width + 1)
    {
        for (label dj = -reach; dj <= reach; ++dj)
        {
            const label row = j + dj;

            if (row < 0 || row >= ny_)
            {
                continue;
            }

            for (label di = -reach; di <= reach; ++di)
            {
                const label celli = grid.cell(i0 + di, row);
                const auto set = [&](const label result, const scalar value)
                {
                    values_[at(result, k, j, di, dj)] = value;
                };

                for (label l = 0; l < 3; ++l)
                {
                    set(rows + l, y[l*n + celli]);
                }
                set(gradP, flow->gradP[celli].x());
                set(gradP + 1, flow->gradP[celli].y());
                set
                (
                    east,
                    grid.eastSign(i0 + di, row)
                   *stokesFlow::onFace(flow->phi, grid.east(i0 + di, row))
                );

                if (grid.north(i0 + di, row) >= 0)
                {
                    set
                    (
                        north,
                        grid.northSign(i0 + di, row)
                       *stokesFlow::onFace(flow->phi, grid.north(i0 + di, row))
                    );
                }
            }
        }
    }
}
