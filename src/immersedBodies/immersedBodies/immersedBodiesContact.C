// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "contactModel.H"
#include "profiling.H"

bool Foam::immersedBodies::contact() const
{
    return contact_->active();
}


Foam::scalar Foam::immersedBodies::contactSpeed() const
{
    scalar speed = 0;

    for (const immersedBody& body : bodies_)
    {
        speed = max(speed, body.contactSpeed());
    }

    return speed;
}


void Foam::immersedBodies::addContact()
{
    if (contact_->active())
    {
        addProfiling(contact, "immersedBodies::contact");

        contact_->advance
        (
            bodies_,
            walls_(),
            periodicity_,
            mesh_.time().deltaTValue(),
            window_.meanVelocity()
        );
    }
}
