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


bool Foam::immersedBodies::lubrication() const
{
    return lubrication_->active();
}


Foam::contactEnergy Foam::immersedBodies::energyOfContact() const
{
    return contact_->energy();
}


void Foam::immersedBodies::addContact()
{
    if (contact_->active())
    {
        addProfiling(contact, "immersedBodies::contact");

        // Of a sphere and of a disc in unbounded fluid
        for (immersedBody& body : bodies_)
        {
            body.setAddedMass(space_.twoD() ? 1 : 0.5);
        }

        contact_->advance
        (
            bodies_,
            h_,
            walls_(),
            periodicity_,
            mesh_.time().deltaTValue(),
            window_.meanVelocity()
        );
    }
}
