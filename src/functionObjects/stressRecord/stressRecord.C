// SPDX-License-Identifier: GPL-3.0-or-later

#include "stressRecord.H"
#include "Time.H"
#include "uniformState.H"
#include <cmath>

namespace Foam
{
    defineTypeNameAndDebug(stressRecord, 0);
}


Foam::stressRecord::stressRecord
(
    const word& name,
    const objectRegistry& mesh,
    const wordList& names
)
:
    regIOobject
    (
        IOobject
        (
            "suspensionStress." + name,
            mesh.time().timeName(),
            "uniform",
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        )
    ),
    names_(names),
    averages_(names.size())
{
    dictionary states;

    if (!uniformState::read(mesh, this->name(), states))
    {
        return;
    }

    forAll(names_, i)
    {
        if (states.found(names_[i]))
        {
            averages_[i].readState(states.subDict(names_[i]));
        }
    }
}


void Foam::stressRecord::add(const UList<scalar>& values)
{
    forAll(averages_, i)
    {
        // What is not defined, as the gap of a single body
        if (!std::isnan(values[i]))
        {
            averages_[i].add(values[i]);
        }
    }
}


bool Foam::stressRecord::writeData(Ostream& os) const
{
    // As many digits as it takes to go on exactly
    const auto precision = os.precision(17);

    forAll(names_, i)
    {
        os.beginBlock(names_[i]);
        averages_[i].writeState(os);
        os.endBlock();
    }

    os.precision(precision);

    return os.good();
}
