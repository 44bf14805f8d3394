// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyStart.H"
#include "bodyHandover.H"
#include "bodyPlacement.H"

Foam::bodyStart::bodyStart
(
    const dictionary& dict,
    const fvMesh& mesh,
    const geometricSpace& space,
    const scalar rho,
    const bool known
)
:
    time_(mesh.time()),
    placed_
    (
        bodyPlacement(space, time_.globalPath(), rho).place
        (
            dict.subOrEmptyDict("bodies")
        )
    ),
    bounds_(mesh),
    nSpread_(-1)
{
    if (known)
    {
        return;
    }

    if (Pstream::parRun() && placed_.size() >= bodyHandover::fewest())
    {
        nSpread_ = placed_.size();
    }

    DynamicList<label> mine(placed_.size());

    for (label number = 0; number < placed_.size(); ++number)
    {
        if (nSpread_ < 0 || nearest(placed_.position(number)))
        {
            mine.append(number);
        }
    }

    bodies_.resize(mine.size());
    forAll(mine, i)
    {
        bodies_.set(i, make(mine[i]));
    }
}


std::vector<std::shared_ptr<const Foam::bodyKind>>
Foam::bodyStart::kinds() const
{
    std::vector<std::shared_ptr<const bodyKind>> kinds;

    for (const placedBodies::entry& e : placed_.entries())
    {
        kinds.push_back(e.kind);
    }

    return kinds;
}


Foam::autoPtr<Foam::immersedBody> Foam::bodyStart::make
(
    const label number
) const
{
    autoPtr<immersedBody> body(placed_.make(number));

    // Wrong ones that start from zero are refused here as well
    body->prescribe(time_.value() + time_.deltaTValue());
    body->startPrescribed(time_.value());

    return body;
}
