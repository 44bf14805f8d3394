// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyRegion.H"

Foam::bodyRegion::bodyRegion()
:
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

    searchCentre_ = body.state().position;
    searchMargin_ = 0.5*hCap;

    const labelList inBox
    (
        search.cellsAround
        (
            searchCentre_,
            radius + bandWidth*hCap + searchMargin_
        )
    );
    DynamicList<label> inReach(inBox.size());

    for (const label celli : inBox)
    {
        const scalar reach =
            radius + bandWidth*min(search.h()[celli], hCap) + searchMargin_;

        if (mag(search.mesh().cellCentres()[celli] - searchCentre_) < reach)
        {
            inReach.append(celli);
        }
    }

    nearCells_ = inReach;
    nearFaces_ = search.facesOf(nearCells_);
}


void Foam::bodyRegion::select
(
    const immersedBody& body,
    const labelUList& labels,
    const UList<point>& centres,
    const UList<scalar>& sizes,
    const scalar bandWidth,
    DynamicList<label>& inBand,
    DynamicList<scalar>& d,
    DynamicList<scalar>& h
)
{
    const scalar hCap = hMax(body);
    scalarField allD(labels.size());
    body.distance(pointField(centres, labels), allD);

    inBand.clear();
    d.clear();
    h.clear();

    forAll(labels, i)
    {
        const scalar hi = min(sizes[labels[i]], hCap);

        if (allD[i] < bandWidth*hi)
        {
            inBand.append(labels[i]);
            d.append(allD[i]);
            h.append(hi);
        }
    }
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

    if (searchMargin_ < 0 || mag(position_ - searchCentre_) > searchMargin_)
    {
        this->search(body, search, bandWidth);
    }

    const fvMesh& mesh = search.mesh();

    select
    (
        body, nearCells_, mesh.cellCentres(), search.h(), bandWidth,
        cells, distance, h
    );
    select
    (
        body, nearFaces_, mesh.faceCentres(), search.faceH(), bandWidth,
        faces, faceDistance, faceH
    );

    normal.setSize(cells.size());
    body.normal(pointField(mesh.cellCentres(), cells), normal);

    resistance.setSize(cells.size());
    shield.setSize(cells.size());
    faceShield.setSize(faces.size());

    return true;
}
