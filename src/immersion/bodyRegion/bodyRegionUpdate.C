// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyRegion.H"

namespace
{

//- Give a list a size; values are lost. A list that grows has up to twice the
//  room that it needs: too much for many regions.
template<class T>
void setSizeOf(Foam::DynamicList<T>& list, const Foam::label n)
{
    list.clear();
    if (list.capacity() < n)
    {
        list.setCapacity(n + n/16);
    }
    list.setSize(n);
}

} // End anonymous namespace


template<class SizeAlong>
void Foam::bodyRegion::select
(
    const immersedBody& body,
    const labelUList& labels,
    const UList<point>& centres,
    const scalarField& sizes,
    const scalar sizeOfAll,
    const SizeAlong& sizeAlong,
    const scalar bandWidth,
    DynamicList<label>& inBand,
    DynamicList<scalar>& d,
    DynamicList<vector>& n,
    DynamicList<scalar>& h
) const
{
    const scalar hCap = hMax(body);
    const auto size = [&](const label i)
    {
        return sizes.empty() ? sizeOfAll : sizes[i];
    };
    const pointField allX(relative(centres, labels));
    scalarField allD(labels.size());
    body.posed().distance(allX, allD);

    label nMost = 0;

    forAll(labels, i)
    {
        nMost += allD[i] < bandWidth*size(i);
    }
    pointField x(nMost);
    setSizeOf(inBand, nMost);
    setSizeOf(d, nMost);
    setSizeOf(n, nMost);
    setSizeOf(h, nMost);

    label last = 0;

    forAll(labels, i)
    {
        if (allD[i] < bandWidth*size(i))
        {
            inBand[last] = labels[i];
            x[last] = allX[i];
            d[last] = allD[i];
            h[last] = size(i);
            ++last;
        }
    }

    body.posed().normal(x, n);

    if (sizes.empty())
    {
        return;
    }

    // Where the cells are thin along the normal the band is narrower
    label nKept = 0;

    forAll(inBand, i)
    {
        // No normal at the centre of a round body
        const scalar hi = magSqr(n[i]) > 0.5
          ? min(sizeAlong(inBand[i], n[i]), hCap)
          : h[i];

        if (d[i] < bandWidth*hi)
        {
            inBand[nKept] = inBand[i];
            d[nKept] = d[i];
            n[nKept] = n[i];
            h[nKept] = hi;
            ++nKept;
        }
    }

    inBand.setSize(nKept);
    d.setSize(nKept);
    n.setSize(nKept);
    h.setSize(nKept);
}


Foam::bodyRegion::change Foam::bodyRegion::update
(
    const immersedBody& body,
    const cellSearch& search,
    const scalar bandWidth,
    const bool again
)
{
    const bodyState& state = body.state();
    same_ = true;

    // A new time step begins with what a restart would find
    if
    (
        (again || followed_ == 0)
     && !slid_
     && state.position == position_
     && state.orientation == orientation_
    )
    {
        return change::none;
    }

    if (again && stillValid(body))
    {
        return change::none;
    }

    same_ = false;

    if (again && follow(body))
    {
        return change::moved;
    }

    position_ = state.position;
    orientation_ = state.orientation;
    followed_ = 0;
    force.clear();

    if
    (
        searchMargin_ < 0
     || mag(centre(state) - searchCentre_) > searchMargin_
    )
    {
        this->search(body, search, bandWidth);
    }
    slid_ = false;

    cellCentres_ = &search.mesh().cellCentres();
    faceCentres_ = &search.mesh().faceCentres();

    const scalar hOfAll = min(hMax(body), search.hMax());

    select
    (
        body, nearCells_, *cellCentres_, nearCellH_, hOfAll,
        [&](const label celli, const vector& n) { return search.h(celli, n); },
        bandWidth, cells, distance, normal, h
    );
    select
    (
        body, nearFaces_, *faceCentres_, nearFaceH_, hOfAll,
        [&](const label facei, const vector& n)
        {
            return search.faceH(facei, n);
        },
        bandWidth, faces, faceDistance, faceNormal, faceH
    );

    setSizeOf(c4, cells.size());

    // In the far part of the layer, and deep inside, its few per cent of the
    // resistance are of no effect
    const scalar inside = -2, outside = 3, mean = 0.7;

    forAll(cells, i)
    {
        const scalar d = distance[i]/h[i];

        c4[i] = d > inside && d < outside
          ? search.c4(cells[i], normal[i])
          : mean;
    }

    setSizeOf(resistance, cells.size());
    setSizeOf(shield, cells.size());
    setSizeOf(share, cells.size());
    setSizeOf(faceShield, faces.size());
    setSizeOf(faceShare, faces.size());

    return change::anew;
}
