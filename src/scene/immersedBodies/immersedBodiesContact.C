// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "contactModel.H"
#include "profiling.H"

bool Foam::immersedBodies::contact() const
{
    return contact_->active();
}


const Foam::contactModel& Foam::immersedBodies::contacts() const
{
    return contact_();
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

        // Of a sphere and of a disc that leave a wall, or one like them, in
        // potential flow: 3/2 zeta(3) - 1 and pi^2/3 - 1
        const scalar addedMass = space_.twoD() ? 2.290 : 0.803;

        for (immersedBody& body : bodies_)
        {
            body.setAddedMass(addedMass);
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
