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


void Foam::lineGrid::findEnds
(
    const direction k,
    const std::function<scalar(label)>& value,
    const std::function<scalar(label)>& onPatch,
    ends& beyond
) const
{
    const lines& along = lines_[k];
    List<vector> values(mesh_.nFaces() - mesh_.nInternalFaces(), Zero);

    const auto forSide = [&]
    (
        const label side,
        const std::function<void(label, label)>& f
    )
    {
        const label layer = side == 0 ? 0 : along.n - 1;

        for (label slabi = 0; slabi < along.nSlabs; ++slabi)
        {
            for (label line = 0; line < along.nLines; ++line)
            {
                f(slabi*along.nLines + line, along.cell(slabi, layer, line));
            }
        }
    };

    for (label side = 0; side < 2; ++side)
    {
        const label inwards = side == 0 ? along.step : -along.step;

        if (along.joined[side])
        {
            forSide(side, [&](const label p, const label celli)
            {
                values[along.sides[side][p]] = vector
                (
                    value(celli),
                    value(celli + inwards),
                    value(celli + 2*inwards)
                );
            });
        }
    }

    // Three values of a scalar; no patch is turned
    syncTools::swapBoundaryFaceList(mesh_, values);

    for (label side = 0; side < 2; ++side)
    {
        beyond[side].setSize(along.nLines*along.nSlabs);

        forAll(beyond[side], p)
        {
            const label face = along.sides[side][p];

            beyond[side][p] = along.joined[side]
              ? values[face]
              : vector(onPatch(face), 0, 0);
        }
    }
}
