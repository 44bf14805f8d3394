// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyStart.H"
#include "bodyHandover.H"
#include "bodyPlacement.H"
#include "rankBounds.H"

Foam::bodyStart::bodyStart
(
    const dictionary& dict,
    const fvMesh& mesh,
    const geometricSpace& space,
    const scalar rho,
    const bool known
)
:
    nSpread_(-1)
{
    const Time& time = mesh.time();
    const dictionary& entries = dict.subOrEmptyDict("bodies");
    const bodyPlacement placement(space, time.globalPath(), rho);

    // Names and numbers of all are needed where others enter
    const bool own =
        Pstream::parRun() && !known
     && dict.subOrEmptyDict("injection").empty()
     && dict.subOrEmptyDict("window").empty()
     && placement.nListed(entries) >= bodyHandover::fewest();

    if (own)
    {
        const rankBounds bounds(mesh);

        nSpread_ = placement.place
        (
            entries, bodies_, kinds_,
            [&](const point& x)
            {
                return bounds.nearest(x) == Pstream::myProcNo();
            }
        );
    }
    else
    {
        placement.place
        (
            entries, bodies_, kinds_, [](const point&) { return true; }
        );
    }

    for (immersedBody& body : bodies_)
    {
        // Wrong ones that start from zero are refused here as well
        body.prescribe(time.value() + time.deltaTValue());
        body.startPrescribed(time.value());
    }
}
