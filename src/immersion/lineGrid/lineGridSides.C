// SPDX-License-Identifier: GPL-3.0-or-later

#include "lineGrid.H"
#include "cellSearch.H"
#include "coupledPolyPatch.H"
#include "syncTools.H"

bool Foam::lineGrid::findSides(const direction k)
{
    lines& along = lines_[k];
    const label nFaces = along.nLines*along.nSlabs;
    FixedList<label, 2> nJoined(label(0)), n(label(0));

    along.sides = labelList(nFaces, -1);

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        const bool joined = cellSearch::matched(patch);
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
    syncTools::swapBoundaryFaceList(mesh_, atEnds);

    for (label side = 0; side < 2; ++side)
    {
        beyond[side].setSize(along.nLines*along.nSlabs);

        forAll(beyond[side], p)
        {
            const label face = along.sides[side][p];

            beyond[side][p] = along.joined[side]
              ? atEnds[face]
              : vector(onPatch(face), 0, 0);
        }
    }
}
