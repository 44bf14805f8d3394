// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyRegion.H"

namespace
{
    // As parts of a body's width

    //- How far its surface follows it without being evaluated: errors, over
    //  the width, are of the order of its square
    const Foam::scalar maxFollowed = 0.0025;

    //- How far it moves in later iterations without its surface following it:
    //  a ten-thousandth of a cell of one of ten. With ten times as much, runs
    //  that differ in where cyclic patches cut bodies differ by 1e-6.
    const Foam::scalar minFollowed = 1e-5;
}


Foam::bodyRegion::bodyRegion
(
    const label bodyi,
    const periodicity::image& im
)
:
    body_(bodyi),
    image_(im),
    searchCentre_(Zero),
    searchMargin_(-1),
    position_(point::max),
    orientation_(quaternion::zero),
    followed_(0),
    same_(false),
    slid_(false),
    cellCentres_(nullptr),
    faceCentres_(nullptr)
{}


void Foam::bodyRegion::search
(
    const immersedBody& body,
    const cellSearch& search,
    const scalar bandWidth
)
{
    const scalar hCap = min(hMax(body), search.hMax());
    const scalar radius = body.shape().boundingRadius();

    searchCentre_ = centre(body.state());

    // A cell at least: of a small body half a one is left in a step or two
    searchMargin_ = max(0.5*hMax(body), hCap);

    const labelList inSphere
    (
        search.cellsAround
        (
            searchCentre_,
            radius + (bandWidth + 0.5)*hCap + searchMargin_
        )
    );
    DynamicList<label> inReach(inSphere.size());

    for (const label celli : inSphere)
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

    if (search.uniform())
    {
        return;
    }

    nearCellH_.setSize(nearCells_.size());
    nearFaceH_.setSize(nearFaces_.size());

    forAll(nearCells_, i)
    {
        nearCellH_[i] = min(search.hMax(nearCells_[i]), hCap);
    }
    forAll(nearFaces_, i)
    {
        nearFaceH_[i] = min(search.faceHMax(nearFaces_[i]), hCap);
    }
}


Foam::pointField Foam::bodyRegion::relative
(
    const UList<point>& centres,
    const labelUList& labels
) const
{
    pointField x(centres, labels);

    if (image_.shift != vector::zero)
    {
        x -= image_.shift;
    }

    return x;
}


void Foam::bodyRegion::slide(const periodicity::image& im)
{
    if (im.shift != image_.shift)
    {
        // Nothing of the last update is valid but the near cells
        slid_ = true;
    }
    image_ = im;
}


Foam::scalar Foam::bodyRegion::moved(const immersedBody& body) const
{
    const bodyState& state = body.state();
    const quaternion turn(state.orientation*conjugate(orientation_));

    return mag(state.position - position_)
      + 2*mag(turn.v())*body.shape().boundingRadius();
}


bool Foam::bodyRegion::stillValid(const immersedBody& body) const
{
    return
        searchMargin_ >= 0 && !slid_
     && moved(body) < minFollowed*body.shape().width();
}


bool Foam::bodyRegion::follow(const immersedBody& body)
{
    // One that is new, of an image that came within a time step, or has slid
    if (searchMargin_ < 0 || slid_)
    {
        return false;
    }

    const bodyState& state = body.state();
    const vector move(state.position - position_);
    const quaternion turn(state.orientation*conjugate(orientation_));
    const vector angle((turn.w() < 0 ? -2 : 2)*turn.v());

    const scalar far = followed_ + moved(body);

    if (far > maxFollowed*body.shape().width())
    {
        return false;
    }

    followed_ = far;

    forAll(cells, i)
    {
        distance[i] -= normal[i] & (move + (angle^(x(i) - position_)));
    }
    forAll(faces, i)
    {
        faceDistance[i] -=
            faceNormal[i] & (move + (angle^(faceX(i) - position_)));
    }

    position_ = state.position;
    orientation_ = state.orientation;

    return true;
}


Foam::autoPtr<Foam::bodyRegion> Foam::bodyRegion::part
(
    const bitSet& inCells,
    const bitSet& onFaces
) const
{
    autoPtr<bodyRegion> some(new bodyRegion(body_, image_));
    bodyRegion& one = some();

    one.same_ = true;
    one.cellCentres_ = cellCentres_;
    one.faceCentres_ = faceCentres_;

    forAll(cells, i)
    {
        if (inCells.test(cells[i]))
        {
            one.cells.append(cells[i]);
            one.resistance.append(resistance[i]);
            one.shield.append(shield[i]);
            one.share.append(share[i]);
        }
    }
    forAll(faces, i)
    {
        if (onFaces.test(faces[i]))
        {
            one.faces.append(faces[i]);
            one.faceShield.append(faceShield[i]);
            one.faceShare.append(faceShare[i]);
        }
    }

    return some;
}
