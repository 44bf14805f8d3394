// SPDX-License-Identifier: GPL-3.0-or-later

#include "lineGrid.H"
#include "coupledPolyPatch.H"

bool Foam::lineGrid::findSides(const direction k)
{
    lines& along = lines_[k];
    const label nFaces = along.nLines*along.nSlabs;
    FixedList<label, 2> nJoined(label(0)), n(label(0));

    along.sides = labelList(nFaces, -1);
    along.coupled = labelList(nFaces, -1);

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        const bool joined = coupled_.joined(patch.index());
        const vectorField& areas = mesh_.faceAreas();

        if (joined && !refCast<const coupledPolyPatch>(patch).parallel())
        {
            return false;
        }

        for (label i = 0; i < patch.size(); ++i)
        {
            const label facei = patch.start() + i;

            if (mag(areas[facei][k]) < 0.5*mag(areas[facei]))
            {
                continue;
            }

            const label side = areas[facei][k] > 0 ? 1 : 0;
            const label celli = mesh_.faceOwner()[facei];
            const label p = celli/along.slab % along.nSlabs*along.nLines
              + celli/along.next % along.nLines;

            along.sides[side][p] = facei - mesh_.nInternalFaces();
            along.coupled[side][p] =
                joined ? coupled_.index(patch.index(), i) : -1;
            ++n[side];
            nJoined[side] += joined;
        }
    }

    for (label side = 0; side < 2; ++side)
    {
        along.joined[side] = nJoined[side] > 0;

        if
        (
            n[side] != nFaces
         || nJoined[side] % nFaces != 0
         || (along.single && along.joined[side])
        )
        {
            return false;
        }
    }

    return true;
}


void Foam::lineGrid::exchange
(
    const direction k,
    const std::function<scalar(label)>& onPatch,
    List<vector>& atEnds,
    ends& beyond
) const
{
    const lines& along = lines_[k];

    // Three values of a scalar; no patch is turned
    coupled_.swap(atEnds);

    for (label side = 0; side < 2; ++side)
    {
        beyond[side].setSize(along.nLines*along.nSlabs);

        forAll(beyond[side], p)
        {
            beyond[side][p] = along.joined[side]
              ? atEnds[along.coupled[side][p]]
              : vector(onPatch(along.sides[side][p]), 0, 0);
        }
    }
}
