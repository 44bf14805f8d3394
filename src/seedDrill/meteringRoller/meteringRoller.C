// SPDX-License-Identifier: GPL-3.0-or-later

#include "meteringRoller.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "keyedRandom.H"
#include "ListOps.H"

namespace Foam
{
    defineTypeNameAndDebug(meteringRoller, 0);
    addToRunTimeSelectionTable(injectionOrder, meteringRoller, dictionary);
}


namespace
{

//- Numbers of the draws for a cell: less than zero, which those for a body are
//  not; grains come after them, downward
enum draws { NUMBER = -2, DELAY = -3 };


//- The number under a keyword, from 0 to 1; 0 if it is not there
Foam::scalar part(const Foam::dictionary& dict, const Foam::word& key)
{
    const Foam::scalar value = dict.lookupOrDefault<Foam::scalar>(key, 0);

    if (!(value >= 0 && value <= 1))
    {
        FatalIOErrorInFunction(dict)
            << "'" << key << ' ' << value << "' in '" << dict.dictName()
            << "' must be from 0 to 1" << Foam::nl
            << Foam::exit(Foam::FatalIOError);
    }

    return value;
}


//- The whole number under a keyword, at least 1
Foam::label count
(
    const Foam::dictionary& dict,
    const Foam::word& key,
    const Foam::label value
)
{
    if (value < 1)
    {
        FatalIOErrorInFunction(dict)
            << "'" << key << ' ' << value << "' in '" << dict.dictName()
            << "' must be at least 1" << Foam::nl
            << Foam::exit(Foam::FatalIOError);
    }

    return value;
}


//- The argument, after a check of its keywords
const Foam::dictionary& checked(const Foam::dictionary& dict)
{
    Foam::keywords::check
    (
        dict,
        {
            "revolutionsPerSecond", "cells", "grainsPerCell", "jitter",
            "misses", "doubles"
        }
    );

    return dict;
}

} // End anonymous namespace


Foam::meteringRoller::meteringRoller
(
    const dictionary& dict,
    const dictionary& injector
)
:
    frequency_
    (
        Foam::keywords::positive(dict, "revolutionsPerSecond")
       *count(dict, "cells", dict.get<label>("cells"))
    ),
    nGrains_
    (
        count
        (
            dict,
            "grainsPerCell",
            dict.lookupOrDefault<label>("grainsPerCell", 1)
        )
    ),
    jitter_(part(dict, "jitter")),
    misses_(part(dict, "misses")),
    doubles_(part(dict, "doubles")),
    seed_(random() ? injector.get<label>("seed") : 0),
    cell_(0),
    inCell_(0)
{
    if (misses_ == 1 || misses_ + doubles_ > 1)
    {
        FatalIOErrorInFunction(dict)
            << "'misses " << misses_ << "' and 'doubles " << doubles_
            << "' are parts of all cells: their sum must not be more than 1,"
            << " and not all can be empty" << nl << exit(FatalIOError);
    }

    skipEmptyCells();
}


Foam::meteringRoller::meteringRoller(const dictionary& injector)
:
    meteringRoller(checked(injector.subDict("roller")), injector)
{}


Foam::label Foam::meteringRoller::nGrains(const label cell) const
{
    if (misses_ == 0 && doubles_ == 0)
    {
        return nGrains_;
    }

    Random random(keyedRandom::generator(seed_, cell, NUMBER));
    const scalar x = random.sample01<scalar>();

    return x < misses_ ? 0 : x < misses_ + doubles_ ? nGrains_ + 1 : nGrains_;
}


Foam::scalarList Foam::meteringRoller::times(const label cell) const
{
    scalarList times(nGrains(cell), cell/frequency_);

    if (jitter_ > 0)
    {
        forAll(times, i)
        {
            Random random(keyedRandom::generator(seed_, cell, DELAY - i));

            times[i] =
                (cell + jitter_*random.sample01<scalar>())/frequency_;
        }
        Foam::sort(times);
    }

    return times;
}


void Foam::meteringRoller::skipEmptyCells()
{
    while (inCell_ >= nGrains(cell_))
    {
        ++cell_;
        inCell_ = 0;
    }
}


Foam::scalar Foam::meteringRoller::time
(
    const label number,
    const scalar start,
    const scalar last
) const
{
    return start + times(cell_)[inCell_];
}


void Foam::meteringRoller::advance()
{
    ++inCell_;
    skipEmptyCells();
}


void Foam::meteringRoller::readState(const dictionary& dict)
{
    cell_ = dict.get<label>("cell");
    inCell_ = dict.get<label>("inCell");
}


void Foam::meteringRoller::writeState(Ostream& os) const
{
    os.writeEntry("cell", cell_);
    os.writeEntry("inCell", inCell_);
}
