// SPDX-License-Identifier: GPL-3.0-or-later

#include "nearFaces.H"

Foam::nearFaces::nearFaces()
:
    number_(-1),
    shift_(Zero),
    within_(0),
    searchCentre_(Zero)
{}


void Foam::nearFaces::search
(
    const immersedBody& body,
    const cellSearch& search,
    const scalar margin
)
{
    const scalar reach = body.shape().boundingRadius() + within_ + margin;
    DynamicList<label> cells;

    number_ = body.number();
    searchCentre_ = body.state().position + shift_;

    // A face has to be met from both sides
    for
    (
        const label celli
      : search.cellsAround(searchCentre_, reach + search.hMax())
    )
    {
        const point& x = search.mesh().cellCentres()[celli];

        if (mag(x - searchCentre_) < reach + search.hMax(celli))
        {
            cells.append(celli);
        }
    }
    all_ = search.facesOf(cells);
    centres_ = pointField(search.mesh().faceCentres(), all_) - shift_;
}


void Foam::nearFaces::update
(
    const immersedBody& body,
    const vector& shift,
    const cellSearch& search,
    const scalar within
)
{
    // Some steps
    const scalar margin = 0.125*body.shape().width();
    const point centre(body.state().position + shift);

    if
    (
        number_ != body.number()
     || shift_ != shift
     || within_ != within
     || mag(centre - searchCentre_) > margin
    )
    {
        shift_ = shift;
        within_ = within;
        this->search(body, search, margin);
    }

    scalarField d(all_.size());
    body.posed().distance(centres_, d);

    faces.clear();
    x.clear();
    distance.clear();

    forAll(all_, i)
    {
        if (d[i] < within)
        {
            faces.append(all_[i]);
            x.append(centres_[i]);
            distance.append(d[i]);
        }
    }
}
