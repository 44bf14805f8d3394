// SPDX-License-Identifier: GPL-3.0-or-later

#include "remapChoice.H"

namespace
{
    //- Part of all cells beside displaced faces from which on lines pay
    const Foam::scalar goodPart = 0.15;
}


Foam::remapChoice::remapChoice
(
    const fvMesh& mesh,
    const cellNeighbours& neighbours
)
:
    mesh_(mesh),
    neighbours_(neighbours),
    known_(false)
{}


Foam::frameRemap& Foam::remapChoice::select(const labelUList& faces)
{
    if (!known_)
    {
        autoPtr<lineGrid> grid(new lineGrid(mesh_));

        if (grid->valid())
        {
            lines_.reset(new lineRemap(std::move(grid)));
        }
        known_ = true;
    }

    // Three faces to a cell
    const label nBeside = returnReduce(faces.size(), sumOp<label>())/3;
    const label nCells = returnReduce(mesh_.nCells(), sumOp<label>());
    frameRemap* remap = lines_.get();

    if (!remap || nBeside < goodPart*nCells)
    {
        if (!swept_.valid())
        {
            swept_.reset(new sweptRemap(mesh_, neighbours_));
        }
        remap = swept_.get();
    }

    remap->setFaces(faces);

    return *remap;
}
