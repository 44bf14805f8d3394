// SPDX-License-Identifier: GPL-3.0-or-later

#include "comovingDerivative.H"

void Foam::comovingDerivative::findCells()
{
    const auto append = [&](const label celli)
    {
        if (cellAt_[celli] < 0)
        {
            cellAt_[celli] = cells_.size();
            cells_.append(celli);
        }
    };

    for (const label facei : faces_)
    {
        append(mesh_.faceOwner()[facei]);

        if (mesh_.isInternalFace(facei))
        {
            append(mesh_.faceNeighbour()[facei]);
        }
    }

    widen();
}


void Foam::comovingDerivative::widen()
{
    wide_ = cells_;

    // Marked by their places in the longer list while that is made
    const auto append = [&](const label celli)
    {
        if (cellAt_[celli] < 0)
        {
            cellAt_[celli] = wide_.size();
            wide_.append(celli);
        }
    };

    if (coupled_)
    {
        const List<label> places(beyond(cellAt_));

        for (const fvPatch& patch : mesh_.boundary())
        {
            const label first = patch.start() - mesh_.nInternalFaces();

            for (label i = 0; patch.coupled() && i < patch.size(); ++i)
            {
                if (places[first + i] >= 0)
                {
                    append(patch.faceCells()[i]);
                }
            }
        }
    }

    for (const label celli : cells_)
    {
        for (const auto& n : neighbours_.of(celli))
        {
            append(n.cell());
        }
    }

    for (label i = cells_.size(); i < wide_.size(); ++i)
    {
        cellAt_[wide_[i]] = -1;
    }
}
