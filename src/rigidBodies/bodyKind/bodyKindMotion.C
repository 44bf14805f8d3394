// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyKind.H"
#include "checkKeywords.H"

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


void Foam::bodyKind::readMotion(const dictionary& dict)
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

    freedom_.lock();

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


void Foam::bodyKind::readPrescribed
(
    const dictionary& dict,
    const dictionary& motion
)
{
    const bodyFreedom all(space_.translation(), space_.rotation());

    if (dict.found("constraints"))
    {
        const dictionary& constraints = dict.subDict("constraints");

        // None is free or prescribed by default: both would surprise
        constraints.get<vector>("translate");
        constraints.get<vector>("rotate");

        freedom_ = all;
        readConstraints(dict);
    }

    if (freedom_ == all)
    {
        FatalIOErrorInFunction(dict)
            << "'constraints' in '" << dict.dictName() << "' leave nothing to"
            << " 'motion { type prescribed; }': lock a component with 0, or"
            << " use 'type free'" << nl << exit(FatalIOError);
    }

    prescribed_.reset
    (
        new prescribedMotion(motion, space_, freedom_.U(), freedom_.omega())
    );
}


void Foam::bodyKind::readConstraints(const dictionary& dict)
{
    if (dict.found("constraints"))
    {
        const dictionary& constraints = dict.subDict("constraints");
        Foam::keywords::check(constraints, {"translate", "rotate"});

        const vector U(readFlags(constraints, "translate", freedom_.U()));

        freedom_ = bodyFreedom
        (
            U, readFlags(constraints, "rotate", freedom_.omega())
        );
    }
}


void Foam::bodyKind::readVelocities(const dictionary& dict)
{
    if (dict.found("velocity"))
    {
        ambientU_ = readOrAmbient(dict, "velocity", U_);
    }

    ambientOmega_ = ambientU_;

    if (dict.found("angularVelocity"))
    {
        ambientOmega_ = readOrAmbient(dict, "angularVelocity", omega_);
    }

    const vector outU(U_ - cmptMultiply(U_, space_.translation()));
    const vector outOmega
    (
        omega_ - cmptMultiply(omega_, space_.rotation())
    );

    if (magSqr(outU) > 0 || magSqr(outOmega) > 0)
    {
        FatalIOErrorInFunction(dict)
            << "'velocity' or 'angularVelocity' in '" << dict.dictName()
            << "' leads out of the plane of the mesh" << nl
            << exit(FatalIOError);
    }
}
