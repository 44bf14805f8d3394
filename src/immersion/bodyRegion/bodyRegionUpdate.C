// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyRegion.H"

template<class SizeAlong>
void Foam::bodyRegion::select
(
    const immersedBody& body,
    const labelUList& labels,
    const UList<point>& centres,
    const scalarField& sizes,
    const SizeAlong& sizeAlong,
    const scalar bandWidth,
    DynamicList<label>& inBand,
    DynamicList<point>& x,
    DynamicList<scalar>& d,
    DynamicList<vector>& n,
    DynamicList<scalar>& h
) const
{
    const scalar hCap = hMax(body);
    const pointField allX(relative(centres, labels));
    scalarField allD(labels.size());
    body.posed().distance(allX, allD);

    inBand.clear();
    x.clear();
    d.clear();
    h.clear();

    forAll(labels, i)
    {
        if (allD[i] < bandWidth*sizes[i])
        {
            inBand.append(labels[i]);
            x.append(allX[i]);
            d.append(allD[i]);
            h.append(sizes[i]);
        }
    }

    n.setSize(inBand.size());
    body.posed().normal(x, n);

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
            x[nKept] = x[i];
            d[nKept] = d[i];
            n[nKept] = n[i];
            h[nKept] = hi;
            ++nKept;
        }
    }

    inBand.setSize(nKept);
    x.setSize(nKept);
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

    select
    (
        body, nearCells_, search.mesh().cellCentres(), nearCellH_,
        [&](const label celli, const vector& n) { return search.h(celli, n); },
        bandWidth, cells, x, distance, normal, h
    );
    select
    (
        body, nearFaces_, search.mesh().faceCentres(), nearFaceH_,
        [&](const label facei, const vector& n)
        {
            return search.faceH(facei, n);
        },
        bandWidth, faces, faceX, faceDistance, faceNormal, faceH
    );

    c4.setSize(cells.size());

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

    resistance.setSize(cells.size());
    shield.setSize(cells.size());
    share.setSize(cells.size());
    faceShield.setSize(faces.size());
    faceShare.setSize(faces.size());

    return change::anew;
}
