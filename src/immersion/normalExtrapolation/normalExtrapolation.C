// SPDX-License-Identifier: GPL-3.0-or-later

#include "normalExtrapolation.H"
#include "syncTools.H"

namespace
{

//- Distance below which nothing flows [cell sizes]
const Foam::scalar deepest = -2;

//- Sweeps that it takes to come there from outside, on diagonals as well
const Foam::label nSweeps = 10;

//- Largest slope [per cell size]: steeper, the mesh does not resolve it
const Foam::scalar steepest = 0.5;

} // End anonymous namespace


Foam::scalarField Foam::normalExtrapolation::withNeighbours
(
    const scalarField& f
) const
{
    List<scalar> beyond;
    syncTools::swapBoundaryCellList(mesh_, f, beyond);

    scalarField all(f.size() + beyond.size());
    SubList<scalar>(all, f.size()) = f;
    SubList<scalar>(all, beyond.size(), f.size()) = beyond;

    return all;
}


void Foam::normalExtrapolation::nearest
(
    const PtrList<bodyRegion>& regions,
    scalarField& d,
    vectorField& gradD
)
{
    for (const bodyRegion& region : regions)
    {
        forAll(region.cells, i)
        {
            const label celli = region.cells[i];
            const scalar di = region.distance[i]/region.h[i];

            if (di < d[celli])
            {
                d[celli] = di;
                gradD[celli] = region.normal[i]/region.h[i];
            }
        }
    }
}


Foam::label Foam::normalExtrapolation::neighbour
(
    const label celli,
    const label facei
) const
{
    if (mesh_.isInternalFace(facei))
    {
        const label own = mesh_.faceOwner()[facei];

        return own == celli ? mesh_.faceNeighbour()[facei] : own;
    }

    return mesh_.nCells() + facei - mesh_.nInternalFaces();
}


Foam::normalExtrapolation::normalExtrapolation
(
    const fvMesh& mesh,
    const PtrList<bodyRegion>& regions,
    const scalar start
)
:
    mesh_(mesh),
    start_(start),
    sum_(mesh.nCells(), Zero),
    sumSqr_(mesh.nCells(), Zero)
{
    scalarField d(mesh.nCells(), GREAT);
    vectorField gradD(mesh.nCells(), Zero);
    nearest(regions, d, gradD);

    const scalarField allD(withNeighbours(d));
    List<point> beyond;
    syncTools::swapBoundaryCellPositions(mesh, mesh.cellCentres(), beyond);

    forAll(d, celli)
    {
        if (d[celli] < deepest || d[celli] >= start_ + 1)
        {
            continue;
        }

        for (const label facei : mesh.cells()[celli])
        {
            const label other = neighbour(celli, facei);
            const point& to = other < mesh.nCells()
              ? mesh.cellCentres()[other]
              : beyond[other - mesh.nCells()];
            const scalar dd = (to - mesh.cellCentres()[celli]) & gradD[celli];

            // Beyond a wall are the values of the cell itself
            if (dd > 1e-6 && allD[other] > d[celli])
            {
                (d[celli] < start_ ? layer_ : edge_).append
                (
                    link{celli, other, dd}
                );
                sum_[celli] += dd;
                sumSqr_[celli] += sqr(dd);
            }
        }
    }
}


Foam::scalarField Foam::normalExtrapolation::edgeSlope
(
    const scalarField& f
) const
{
    const scalarField all(withNeighbours(f));
    scalarField slope(f.size(), Zero);

    for (const link& l : edge_)
    {
        slope[l.cell] += l.d/sumSqr_[l.cell]*(all[l.other] - f[l.cell]);
    }

    return max(-steepest, min(steepest, slope));
}


void Foam::normalExtrapolation::apply
(
    scalarField& f,
    const bool sloped
) const
{
    scalarField slope(sloped ? edgeSlope(f) : scalarField(f.size(), Zero));

    for (label sweep = 0; sweep < nSweeps; ++sweep)
    {
        const scalarField allF(withNeighbours(f));
        const scalarField allSlope(withNeighbours(slope));

        for (const link& l : layer_)
        {
            f[l.cell] = slope[l.cell] = 0;
        }
        for (const link& l : layer_)
        {
            slope[l.cell] += l.d/sum_[l.cell]*allSlope[l.other];
        }
        for (const link& l : layer_)
        {
            f[l.cell] += l.d/sum_[l.cell]
               *(allF[l.other] - l.d*slope[l.cell]);
        }
    }
}
