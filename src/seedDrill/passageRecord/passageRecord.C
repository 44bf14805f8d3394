// SPDX-License-Identifier: GPL-3.0-or-later

#include "passageRecord.H"
#include "Time.H"
#include "uniformState.H"

namespace Foam
{
    defineTypeNameAndDebug(passageRecord, 0);
}


Foam::passageRecord::passageRecord
(
    const word& name,
    const objectRegistry& mesh,
    const scalar begin
)
:
    regIOobject
    (
        IOobject
        (
            "opticalSensor." + name,
            mesh.time().timeName(),
            "uniform",
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        )
    ),
    begin_(begin)
{}


void Foam::passageRecord::append
(
    const word& name,
    autoPtr<passageStatistics> statistics
)
{
    names_.append(name);
    statistics_.append(statistics.ptr());
}


Foam::scalar Foam::passageRecord::duration
(
    const label planei,
    const scalar t
) const
{
    return max(t - max(begin_, statistics_[planei].start()), 0);
}


void Foam::passageRecord::readState()
{
    dictionary states;

    if (!uniformState::read(db(), name(), states))
    {
        return;
    }

    const dictionary& planes = states.subDict("planes");

    begin_ = states.get<scalar>("begin");

    forAll(names_, planei)
    {
        if (planes.found(names_[planei]))
        {
            statistics_[planei].readState(planes.subDict(names_[planei]));
        }
    }
}


bool Foam::passageRecord::writeData(Ostream& os) const
{
    // As many digits as it takes to go on exactly
    const auto precision = os.precision(17);

    os.writeEntry("begin", begin_);
    os.beginBlock("planes");

    forAll(names_, planei)
    {
        os.beginBlock(names_[planei]);
        statistics_[planei].writeState(os);
        os.endBlock();
    }

    os.endBlock();
    os.precision(precision);

    return os.good();
}
