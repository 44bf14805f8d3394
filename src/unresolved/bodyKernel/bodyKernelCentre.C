// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyKernel.H"

namespace
{

//- Is x inside the mesh, and in the cell but for a tenth of its size h [m]? The
//  planes of warped faces have gaps between them.
bool isBeside
(
    const Foam::fvMesh& mesh,
    const Foam::label celli,
    const Foam::scalar h,
    const Foam::point& x
)
{
    for (const Foam::label facei : mesh.cells()[celli])
    {
        const Foam::vector& Sf = mesh.faceAreas()[facei];
        const Foam::scalar outwards =
            mesh.faceOwner()[facei] == celli ? 1 : -1;
        const Foam::label patchi = mesh.boundaryMesh().whichPatch(facei);
        const bool between =
            patchi < 0 || mesh.boundaryMesh()[patchi].coupled();

        if
        (
            outwards*((x - mesh.faceCentres()[facei]) & Sf)
          > (between ? 0.1 : 1e-9)*h*Foam::mag(Sf)
        )
        {
            return false;
        }
    }

    return true;
}

} // End anonymous namespace


template<class Test>
Foam::label Foam::bodyKernel::firstCell(const Test& test) const
{
    label i = 0;

    for (const part& p : parts_)
    {
        const point x(centre_ + p.shift);

        for (; i < p.end; ++i)
        {
            if (test(cells_[i], x))
            {
                return cells_[i];
            }
        }
    }

    return -1;
}


void Foam::bodyKernel::findCentre
(
    const label nearest,
    const point& at,
    const cellSearch& search
)
{
    const pointField& C = search.mesh().cellCentres();

    nBeside_ = 0;
    hBeside_ = 0;

    // Next to smaller cells the nearest centre may be that of another
    centreCell_ = nearest >= 0 && search.contains(nearest, at)
      ? nearest
      : firstCell
        (
            [&](const label celli, const point& x)
            {
                return
                    mag(C[celli] - x) < search.hMax(celli)
                 && search.contains(celli, x);
            }
        );

    // From small cells into a large one, whose centre is beyond the kernel
    if (centreCell_ < 0 && near_.size())
    {
        centreCell_ = search.findCell(centre_);

        if (centreCell_ >= 0 && cells_.empty())
        {
            cells_.append(centreCell_);
            weights_.append(1);

            for (part& p : parts_)
            {
                p.end = 1;
            }
        }
    }

    if (centreCell_ >= 0)
    {
        return;
    }

    forCells
    (
        [&](const label celli, const scalar, const point& x, const vector&)
        {
            const scalar h = search.hMax(celli);

            if
            (
                mag(C[celli] - x) < h
             && isBeside(search.mesh(), celli, h, x)
            )
            {
                ++nBeside_;
                hBeside_ += h;
            }
        }
    );
}
