// SPDX-License-Identifier: GPL-3.0-or-later

#include "closureRecord.H"
#include "Time.H"
#include "uniformState.H"

namespace Foam
{
    defineTypeNameAndDebug(closureRecord, 0);
}

namespace
{
    const char* const phases[2] = {"fluid", "bodies"};

    //- A list that has been written as text, whatever the format of the file,
    //  or of the message by which another rank has got it
    template<class ListType>
    ListType asText(const Foam::dictionary& dict, const Foam::word& key)
    {
        Foam::ITstream& is = dict.lookup(key);

        is.format(Foam::IOstream::ASCII);

        return ListType(is);
    }
}


void Foam::closureRecord::readVelocities
(
    const dictionary& dict,
    const word& key,
    velocities& v
)
{
    const dictionary& entries = dict.subDict(key);

    v.time = entries.get<scalar>("time");
    v.both = asText<labelList>(entries, "both");

    for (label phase = 0; phase < 2; ++phase)
    {
        v.U[phase] = asText<List<vector>>(entries, phases[phase]);
    }
}


void Foam::closureRecord::writeVelocities
(
    Ostream& os,
    const word& key,
    const velocities& v
)
{
    const auto list = [&](const char* name, const label n)
        -> Ostream&
    {
        return os.writeKeyword(name) << n << token::BEGIN_LIST;
    };

    // As text, whatever the format
    os.beginBlock(key);
    os.writeEntry("time", v.time);

    list("both", v.both.size());
    for (const label there : v.both)
    {
        os  << token::SPACE << there;
    }
    os  << token::SPACE << token::END_LIST << token::END_STATEMENT << nl;

    for (label phase = 0; phase < 2; ++phase)
    {
        list(phases[phase], v.U[phase].size());
        for (const vector& U : v.U[phase])
        {
            os  << token::BEGIN_LIST << U.x() << token::SPACE << U.y()
                << token::SPACE << U.z() << token::END_LIST;
        }
        os  << token::END_LIST << token::END_STATEMENT << nl;
    }
    os.endBlock();
}


Foam::closureRecord::closureRecord
(
    const word& name,
    const objectRegistry& mesh,
    const label nPlaces
)
:
    regIOobject
    (
        IOobject
        (
            "closureFit." + name,
            mesh.time().timeName(),
            "uniform",
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        )
    ),
    fits_(nPlaces)
{
    for (velocities* v : {&old_, &oldOld_})
    {
        v->time = -1;
        v->both = labelList(nPlaces, Zero);
        v->U = vectorField(nPlaces, Zero);
    }

    dictionary states;

    if
    (
        !uniformState::read(mesh, this->name(), states)
     || states.get<label>("places") != nPlaces
    )
    {
        return;
    }

    forAll(fits_, i)
    {
        fits_[i].readState(states.subDict("fit" + Foam::name(i)));
    }
    readVelocities(states, "old", old_);
    readVelocities(states, "oldOld", oldOld_);
}


bool Foam::closureRecord::follows
(
    const velocities& now,
    const ddtCoefficients& ddt,
    const scalar deltaT,
    const scalar deltaT0
) const
{
    const auto before = [&](const velocities& v, const scalar ago)
    {
        return v.time >= 0 && mag(v.time + ago - now.time) < 1e-6*deltaT;
    };

    return before(old_, deltaT)
     && (ddt.c00 == 0 || before(oldOld_, deltaT + deltaT0));
}


bool Foam::closureRecord::both
(
    const velocities& now,
    const ddtCoefficients& ddt,
    const label i
) const
{
    return now.both[i] && old_.both[i] && (ddt.c00 == 0 || oldOld_.both[i]);
}


void Foam::closureRecord::shift(const velocities& now)
{
    oldOld_ = old_;
    old_ = now;
}


bool Foam::closureRecord::writeData(Ostream& os) const
{
    // As many digits as it takes to go on exactly
    const auto precision = os.precision(17);

    os.writeEntry("places", fits_.size());
    forAll(fits_, i)
    {
        os.beginBlock(word("fit" + Foam::name(i)));
        fits_[i].writeState(os);
        os.endBlock();
    }
    writeVelocities(os, "old", old_);
    writeVelocities(os, "oldOld", oldOld_);

    os.precision(precision);

    return os.good();
}
