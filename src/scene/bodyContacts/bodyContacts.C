// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyContacts.H"
#include "bodyShare.H"
#include "meshWalls.H"
#include "profiling.H"

Foam::bodyContacts::bodyContacts
(
    const dictionary& dict,
    bodyList& bodies,
    const fvMesh& mesh,
    const geometricSpace& space,
    const periodicity& periods,
    const fluidConstants& fluid,
    const bool window
)
:
    periodicity_(periods),
    // Of a sphere and of a disc that leave a wall, or one like them, in
    // potential flow: 3/2 zeta(3) - 1 and pi^2/3 - 1
    addedMass_(space.twoD() ? 2.290 : 0.803),
    lubrication_
    (
        lubricationModel::New
        (
            dict.subOrEmptyDict("lubrication"), space, fluid.nu()
        )
    ),
    model_
    (
        contactModel::New
        (
            dict.subOrEmptyDict("contact"), fluid.rho(), lubrication_()
        )
    ),
    mayBeSpread_(model_->follow(bodies.share())),
    sleep_(dict, bodies, fluid.g(), model_->active(), window),
    proximity_(mesh, periods, model_())
{
    if (model_->active())
    {
        walls_.reset(new meshWalls(mesh, space));
        model_->readMaterials(dict, walls_());
    }
}


void Foam::bodyContacts::advance
(
    PtrList<immersedBody>& bodies,
    const UList<scalar>& h,
    const scalar dt,
    const vector& meshU
)
{
    if (!model_->active())
    {
        return;
    }

    addProfiling(contact, "immersedBodies::contact");

    for (immersedBody& body : bodies)
    {
        const addedInertia alone{addedMass_, 0};

        body.contact().setAdded
        (
            model_->implicit() && body.resolved()
          ? alone + body.fluid().viscous()
          : alone
        );
    }

    model_->advance(bodies, h, walls_(), periodicity_, dt, meshU);
}


void Foam::bodyContacts::updateSleep(const scalar dt)
{
    if (sleep_.active())
    {
        sleep_.update(periodicity_, walls_(), dt);
    }
}


void Foam::bodyContacts::readState
(
    const bodyList& bodies,
    const label bodyi,
    const dictionary& dict
)
{
    model_->readState(bodies[bodyi], dict);
    sleep_.readState(bodyi, dict);
}


void Foam::bodyContacts::writeState
(
    Ostream& os,
    const bodyList& bodies,
    const label bodyi
) const
{
    model_->writeState(os, bodies[bodyi]);
    sleep_.writeState(os, bodyi);
}


void Foam::bodyContacts::report
(
    const bodyList& bodies,
    Ostream& os
) const
{
    if (model_->active())
    {
        os  << "    contact: ";
        model_->report(os);
        os  << nl;
    }

    if (lubrication_->active())
    {
        const label nOthers = bodies.share().sum<label>
        (
            [&](const label i) { return !bodies[i].shape().round(); }
        );

        os  << "    lubrication: ";
        lubrication_->report(os);

        if (nOthers)
        {
            os  << "; none for " << nOthers << " that are not round";
        }
        os  << nl;
    }

    if (sleep_.active())
    {
        os  << "    sleep: ";
        sleep_.report(os);
        os  << nl;
    }
}
