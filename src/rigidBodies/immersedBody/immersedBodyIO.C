// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBody.H"
#include "Switch.H"

void Foam::immersedBody::readState(const dictionary& dict)
{
    const scalar volumeThen = dict.lookupOrDefault("volume", volume());

    if (mag(volumeThen - volume()) > 1e-6*volume())
    {
        FatalIOErrorInFunction(dict)
            << "Body '" << name_ << "' has a volume of " << volume()
            << " m3 now and had " << volumeThen << " m3 in the run that is"
            << " to go on: leave its 'shape' as it was, or begin at time 0"
            << nl << exit(FatalIOError);
    }

    number_ = dict.lookupOrDefault("number", number_);
    status_.pass(dict.lookupOrDefault("passing", word::null));
    if (dict.lookupOrDefault("held", false))
    {
        hold();
    }

    status_.setResolved(!dict.found("load"));

    rigidMomentum load
    {
        dict.lookupOrDefault<vector>("load", Zero), vector::zero
    };
    dict.readIfPresent("heldForce", load.linear);
    dict.readIfPresent("heldTorque", load.angular);
    fluid_.setLoad(load);

    if (dict.found("eddy"))
    {
        fluid_.setEddy(turbulentEddy(dict.subDict("eddy")));
    }

    addedInertia viscous{0, 0};
    dict.readIfPresent("viscousMass", viscous.mass);
    dict.readIfPresent("viscousRotation", viscous.rotation);
    fluid_.setViscous(viscous);

    motion_.read(dict);
    contact_.read(dict);

    for (Foam::restrainedMotion& one : restrained_)
    {
        one.read(dict);
    }

    // The previous run may have moved it
    if (status_.fixed())
    {
        motion_.stop();
        restart();
    }

    ambientU_ = ambientOmega_ = dict.lookupOrDefault("ambient", false);
}


void Foam::immersedBody::writeState(Ostream& os) const
{
    const geometricSpace& space = kind_->space();
    const bodyFreedom all(space.translation(), space.rotation());

    os.writeEntry("number", number_);
    os.writeEntry("volume", volume());
    if (origin_)
    {
        os.beginBlock("origin");
        origin_->write(os);
        os.endBlock();
    }
    if (status_.passing().size())
    {
        os.writeEntry("passing", status_.passing());
        os.writeEntry("held", Switch(status_.fixed()));
    }
    if (ambientU_)
    {
        // It waits to enter again
        os.writeEntry("ambient", Switch(true));
    }

    if (!resolved())
    {
        // What the next step begins with
        os.writeEntry("load", fluid_.load().linear);
    }
    else if (!isFixed() && status_.freedom() != all)
    {
        // What the next step compares the load with, see bodyEquation
        os.writeEntry("heldForce", fluid_.load().linear);
        os.writeEntry("heldTorque", fluid_.load().angular);
    }
    if (fluid_.viscous().mass > 0)
    {
        os.writeEntry("viscousMass", fluid_.viscous().mass);
        os.writeEntry("viscousRotation", fluid_.viscous().rotation);
    }
    if (fluid_.eddy().number > 0)
    {
        os.beginBlock("eddy");
        fluid_.eddy().write(os);
        os.endBlock();
    }

    motion_.write(os);

    for (const Foam::restrainedMotion& one : restrained_)
    {
        one.write(os);
    }

    contact_.write(os);

    os.beginBlock("old");
    motion_.old().write(os);
    os.endBlock();
}
