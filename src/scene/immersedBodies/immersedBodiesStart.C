// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "bodyContacts.H"
#include "bodyHandover.H"
#include "bodyPassage.H"
#include "bodyRestart.H"
#include "uniformState.H"

bool Foam::immersedBodies::readState()
{
    if (!uniformState::found(mesh_, typeName))
    {
        if (mesh_.time().value() > 0)
        {
            WarningInFunction
                << "There is no state of the bodies, "
                << uniformState::path(mesh_, typeName)
                << ": they begin at the positions and velocities in "
                << dict_.name() << ", in the fluid of this time" << nl << endl;
        }
        wrapPositions();

        return false;
    }

    stateFile file(mesh_, typeName, "bodies");
    const dictionary& states = file.top();

    states.readIfPresent("time", clock_);
    window_.readState(states.subDict("window"));
    crowd_.readState(states);
    bodyRestart
    (
        start_, passage_(), contacts_(), mayBeSpread(), bodies_, h_
    ).read
    (
        file, dict_.subOrEmptyDict("bodies")
    );

    return true;
}


bool Foam::immersedBodies::mayBeSpread() const
{
    return contacts_->mayBeSpread()
        && coupling().lookupOrDefault<bool>("spread", true);
}


void Foam::immersedBodies::settle()
{
    if (!bodies_.share().spread())
    {
        return;
    }

    const scalar dt = mesh_.time().deltaTValue();

    // Those that a rank begins with may be in a cell of another, which has a
    // copy after the first time
    handover_->hand(dt);
    handover_->drop();
    handover_->hand(dt);
    contacts_->endStep();
    handover_->drop();
    handover_->decide();
}
