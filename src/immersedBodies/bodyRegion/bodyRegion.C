// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyRegion.H"

namespace
{

//- Sizes of cells, and of faces, by their labels
struct cellSize
{
    const Foam::cellSearch& search;

    Foam::scalar max(const Foam::label celli) const
    {
        return search.hMax(celli);
    }

    Foam::scalar along(const Foam::label celli, const Foam::vector& n) const
    {
        return search.h(celli, n);
    }
};

struct faceSize
{
    const Foam::cellSearch& search;

    Foam::scalar max(const Foam::label facei) const
    {
        return search.faceHMax(facei);
    }

    Foam::scalar along(const Foam::label facei, const Foam::vector& n) const
    {
        return search.faceH(facei, n);
    }
};

} // End anonymous namespace


Foam::bodyRegion::bodyRegion(const label bodyi, const vector& shift)
:
    body_(bodyi),
    shift_(shift),
    searchCentre_(Zero),
    searchMargin_(-1),
    position_(point::max),
    orientation_(quaternion::zero)
{}


void Foam::bodyRegion::search
(
    const immersedBody& body,
    const cellSearch& search,
    const scalar bandWidth
)
{
    const scalar hCap = hMax(body);
    const scalar radius = body.shape().boundingRadius();

    searchCentre_ = centre(body.state());
    searchMargin_ = 0.5*hCap;

    const labelList inBox
    (
        search.cellsAround
        (
            searchCentre_,
            reach(body, bandWidth) + searchMargin_
        )
    );
    DynamicList<label> inReach(inBox.size());

    for (const label celli : inBox)
    {
        const scalar reach =
            radius + (bandWidth + 0.5)*min(search.hMax(celli), hCap)
          + searchMargin_;

        if (mag(search.mesh().cellCentres()[celli] - searchCentre_) < reach)
        {
            inReach.append(celli);
        }
    }

    nearCells_ = inReach;
    nearFaces_ = search.facesOf(nearCells_);
}


Foam::pointField Foam::bodyRegion::relative
(
    const UList<point>& centres,
    const labelUList& labels
) const
{
    pointField x(centres, labels);

    if (shift_ != vector::zero)
    {
        x -= shift_;
    }

    return x;
}


template<class Size>
void Foam::bodyRegion::select
(
    const immersedBody& body,
    const labelUList& labels,
    const UList<point>& centres,
    const Size& size,
    const scalar bandWidth,
    DynamicList<label>& inBand,
    DynamicList<scalar>& d,
    DynamicList<vector>& n,
    DynamicList<scalar>& h
) const
{
    const scalar hCap = hMax(body);
    scalarField allD(labels.size());
    body.distance(relative(centres, labels), allD);

    inBand.clear();
    d.clear();

    forAll(labels, i)
    {
        if (allD[i] < bandWidth*min(size.max(labels[i]), hCap))
        {
            inBand.append(labels[i]);
            d.append(allD[i]);
        }
    }

    n.setSize(inBand.size());
    h.setSize(inBand.size());
    body.normal(relative(centres, inBand), n);

    // Where the cells are thin along the normal the band is narrower
    label nKept = 0;

    forAll(inBand, i)
    {
        // No normal at the centre of a round body
        const scalar along = magSqr(n[i]) > 0.5
          ? size.along(inBand[i], n[i])
          : size.max(inBand[i]);
        const scalar hi = min(along, hCap);

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


bool Foam::bodyRegion::update
(
    const immersedBody& body,
    const cellSearch& search,
    const scalar bandWidth
)
{
    const bodyState& state = body.state();

    if (state.position == position_ && state.orientation == orientation_)
    {
        return false;
    }

    position_ = state.position;
    orientation_ = state.orientation;

    if
    (
        searchMargin_ < 0
     || mag(centre(state) - searchCentre_) > searchMargin_
    )
    {
        this->search(body, search, bandWidth);
    }

    const fvMesh& mesh = search.mesh();

    select
    (
        body, nearCells_, mesh.cellCentres(), cellSize{search}, bandWidth,
        cells, distance, normal, h
    );
    select
    (
        body, nearFaces_, mesh.faceCentres(), faceSize{search}, bandWidth,
        faces, faceDistance, faceNormal, faceH
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
    faceShield.setSize(faces.size());

    return true;
}


bool Foam::bodyRegion::clear()
{
    const bool some = searchMargin_ > 0;

    searchMargin_ = -1;
    position_ = point::max;
    nearCells_.clear();
    nearFaces_.clear();

    for (DynamicList<label>* labels : {&cells, &faces})
    {
        labels->clearStorage();
    }
    for
    (
        DynamicList<scalar>* values
      : {
            &distance, &h, &c4, &resistance, &shield, &faceDistance, &faceH,
            &faceShield
        }
    )
    {
        values->clearStorage();
    }
    normal.clearStorage();
    faceNormal.clearStorage();

    return some;
}
