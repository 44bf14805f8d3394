// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBody.H"
#include "checkKeywords.H"
#include "Switch.H"

const Foam::wordList Foam::immersedBody::keywords
({
    "shape", "density", "densityRatio", "velocity", "angularVelocity",
    "constraints", "motion", "coupling", "material", "restraints"
});


namespace
{

//- Read a vector or the word ambient; returns true for the latter
bool readOrAmbient
(
    const Foam::dictionary& dict,
    const Foam::word& key,
    Foam::vector& value
)
{
    using namespace Foam;

    ITstream& is = dict.lookup(key);
    const token first(is);

    if (first.isWord())
    {
        if (first.wordToken() != "ambient")
        {
            FatalIOErrorInFunction(dict)
                << "'" << key << " " << first.wordToken() << "' in '"
                << dict.dictName() << "' must be 'ambient' or a vector"
                << nl << exit(FatalIOError);
        }
        return true;
    }

    value = dict.get<vector>(key);
    return false;
}


//- Read a vector of zeros and ones, allowed only where limit is one
Foam::vector readFlags
(
    const Foam::dictionary& dict,
    const Foam::word& key,
    const Foam::vector& limit
)
{
    using namespace Foam;

    const vector flags(dict.lookupOrDefault<vector>(key, limit));

    for (direction i = 0; i < 3; ++i)
    {
        if (flags[i] != 0 && flags[i] != 1)
        {
            FatalIOErrorInFunction(dict)
                << "'" << key << " " << flags << "' in '" << dict.dictName()
                << "' must have components 0 (locked) or 1 (free)"
                << nl << exit(FatalIOError);
        }
    }

    return cmptMultiply(flags, limit);
}

} // End anonymous namespace


void Foam::immersedBody::readMotion(const dictionary& dict)
{
    const dictionary motion
    (
        dict.subOrEmptyDict("motion", keyType::REGEX, dict.found("motion"))
    );
    const word type
    (
        Foam::keywords::choice
        (
            motion,
            "type",
            {"free", "fixed", "prescribed"},
            "free"
        )
    );

    if (type == "free")
    {
        Foam::keywords::check(motion, {"type"});
        readConstraints(dict);
        readVelocities(dict);
        return;
    }

    freeU_ = freeOmega_ = Zero;

    for (const word key : {"constraints", "velocity", "angularVelocity"})
    {
        if (dict.found(key) && (type == "fixed" || key != "constraints"))
        {
            FatalIOErrorInFunction(dict)
                << "'" << key << "' in '" << dict.dictName() << "' is for"
                << " 'motion { type free; }' and this body has 'type " << type
                << "'; velocities of 'type prescribed' are entries of 'motion'"
                << nl << exit(FatalIOError);
        }
    }

    if (type == "fixed")
    {
        fixed_ = true;
        Foam::keywords::check(motion, {"type"});
    }
    else
    {
        readPrescribed(dict, motion);
    }
}


void Foam::immersedBody::readPrescribed
(
    const dictionary& dict,
    const dictionary& motion
)
{
    if (dict.found("constraints"))
    {
        const dictionary& constraints = dict.subDict("constraints");

        // None is free or prescribed by default: both would surprise
        constraints.get<vector>("translate");
        constraints.get<vector>("rotate");

        freeU_ = space_.translation();
        freeOmega_ = space_.rotation();
        readConstraints(dict);
    }

    if (freeU_ == space_.translation() && freeOmega_ == space_.rotation())
    {
        FatalIOErrorInFunction(dict)
            << "'constraints' in '" << dict.dictName() << "' leave nothing to"
            << " 'motion { type prescribed; }': lock a component with 0, or"
            << " use 'type free'" << nl << exit(FatalIOError);
    }

    prescribed_ = std::make_shared<const prescribedMotion>
    (
        motion, space_, freeU_, freeOmega_
    );
}


void Foam::immersedBody::readDensity(const dictionary& dict, const scalar rho)
{
    if (dict.found("density") == dict.found("densityRatio"))
    {
        if (dict.found("density") || isFree())
        {
            FatalIOErrorInFunction(dict)
                << "'" << dict.dictName() << "' needs one of 'density' and"
                << " 'densityRatio'" << nl << exit(FatalIOError);
        }
    }
    else if (dict.found("densityRatio"))
    {
        densityRatio_ = Foam::keywords::positive(dict, "densityRatio");
    }
    else
    {
        densityRatio_ = Foam::keywords::positive(dict, "density")/rho;

        if (!(rho > 0))
        {
            FatalIOErrorInFunction(dict)
                << "'density' needs the density of the fluid: set 'rho' [kg/m3]"
                << " in immersedBodyProperties or transportProperties, or use"
                << " 'densityRatio'" << nl << exit(FatalIOError);
        }
    }
}


void Foam::immersedBody::readConstraints(const dictionary& dict)
{
    if (dict.found("constraints"))
    {
        const dictionary& constraints = dict.subDict("constraints");
        Foam::keywords::check(constraints, {"translate", "rotate"});

        freeU_ = readFlags(constraints, "translate", freeU_);
        freeOmega_ = readFlags(constraints, "rotate", freeOmega_);
    }
}


void Foam::immersedBody::readCoupling(const dictionary& dict)
{
    if (dict.found("coupling"))
    {
        coupling_ = Foam::keywords::choice
        (
            dict, "coupling", {"resolved", "unresolved", "auto"}, word::null
        );
    }
}


void Foam::immersedBody::readVelocities(const dictionary& dict)
{
    if (dict.found("velocity"))
    {
        ambientU_ = readOrAmbient(dict, "velocity", state_.U);
    }

    ambientOmega_ = ambientU_;

    if (dict.found("angularVelocity"))
    {
        ambientOmega_ = readOrAmbient(dict, "angularVelocity", state_.omega);
    }

    const vector outU
    (
        state_.U - cmptMultiply(state_.U, space_.translation())
    );
    const vector outOmega
    (
        state_.omega - cmptMultiply(state_.omega, space_.rotation())
    );

    if (magSqr(outU) > 0 || magSqr(outOmega) > 0)
    {
        FatalIOErrorInFunction(dict)
            << "'velocity' or 'angularVelocity' in '" << dict.dictName()
            << "' leads out of the plane of the mesh" << nl
            << exit(FatalIOError);
    }
}


void Foam::immersedBody::readState(const dictionary& dict)
{
    const dictionary& old = dict.subDict("old");
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
    passing_ = dict.lookupOrDefault("passing", word::null);
    if (dict.lookupOrDefault("held", false))
    {
        hold();
    }

    resolved_ = !dict.found("load");
    load_.linear = dict.lookupOrDefault<vector>("load", Zero);
    dict.readIfPresent("heldForce", load_.linear);
    dict.readIfPresent("heldTorque", load_.angular);

    if (dict.found("eddy"))
    {
        eddy_ = turbulentEddy(dict.subDict("eddy"));
    }

    dict.readIfPresent("startPosition", startPosition_);
    dict.readIfPresent("startOrientation", startOrientation_);

    state_ = bodyState(dict);
    trendU_ = velocityTrend(dict, "velocity");
    trendOmega_ = velocityTrend(dict, "angularVelocity");

    wrapped_ = dict.lookupOrDefault<vector>("wrapped", Zero);
    contactU_ = dict.lookupOrDefault<vector>("contactVelocity", Zero);
    contactOmega_ = dict.lookupOrDefault<vector>("contactSpin", Zero);

    old_ = oldOld_ = bodyState(old);

    // The previous run may have moved it
    if (fixed_)
    {
        state_.U = state_.omega = Zero;
        old_ = oldOld_ = state_;
        trendU_ = trendOmega_ = velocityTrend();
        contactU_ = contactOmega_ = Zero;
    }

    ambientU_ = ambientOmega_ = dict.lookupOrDefault("ambient", false);
}


void Foam::immersedBody::writeState(Ostream& os) const
{
    os.beginBlock(name_);

    os.writeEntry("number", number_);
    os.writeEntry("volume", volume());
    if (origin_)
    {
        os.beginBlock("origin");
        origin_->write(os);
        os.endBlock();
    }
    if (passing_.size())
    {
        os.writeEntry("passing", passing_);
        os.writeEntry("held", Switch(fixed_));
    }
    if (ambientU_)
    {
        // It waits to enter again
        os.writeEntry("ambient", Switch(true));
    }

    if (!resolved_)
    {
        // What the next step begins with
        os.writeEntry("load", load_.linear);
    }
    else if
    (
        !isFixed()
     && (freeU_ != space_.translation() || freeOmega_ != space_.rotation())
    )
    {
        // What the next step compares the load with, see heldChange()
        os.writeEntry("heldForce", load_.linear);
        os.writeEntry("heldTorque", load_.angular);
    }
    if (eddy_.number > 0)
    {
        os.beginBlock("eddy");
        eddy_.write(os);
        os.endBlock();
    }

    state_.write(os);
    trendU_.write(os, "velocity");
    trendOmega_.write(os, "angularVelocity");

    if (wrapped_ != vector::zero)
    {
        os.writeEntry("wrapped", wrapped_);
    }

    if (restraints_)
    {
        os.writeEntry("startPosition", startPosition_);
        os.writeEntry("startOrientation", startOrientation_);
    }

    if (contactSpeed() > 0)
    {
        os.writeEntry("contactVelocity", contactU_);
        os.writeEntry("contactSpin", contactOmega_);
    }

    os.beginBlock("old");
    old_.write(os);
    os.endBlock();

    os.endBlock();
}
