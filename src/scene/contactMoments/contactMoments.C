// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactMoments.H"
#include "bodyLoads.H"
#include "bodyShare.H"
#include "contactModel.H"

void Foam::contactMoments::update
(
    const contactModel& model,
    const bodyLoads& loads,
    const scalar dt
)
{
    const tensorField none(bodies_.size(), Zero);

    contact_ = none;
    film_ = none;

    for (const contactModel::pairMoment& pair : model.moments(dt))
    {
        const bool wall = pair.b < 0;

        // One that is not cut has the whole of the other beside it
        const scalar nParts = wall
          ? loads.nParts(pair.a)
          : min(loads.nParts(pair.a), loads.nParts(pair.b));
        const scalar part = (wall ? 1 : 0.5)/nParts;

        for (const label bodyi : {pair.a, pair.b})
        {
            if (bodyi >= 0)
            {
                contact_[bodyi] += part*pair.contact;
                film_[bodyi] += part*pair.film;
            }
        }
    }

    bodies_.share().combine(contact_, plusEqOp<tensor>());
    bodies_.share().combine(film_, plusEqOp<tensor>());
}
