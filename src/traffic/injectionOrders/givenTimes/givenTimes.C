// SPDX-License-Identifier: GPL-3.0-or-later

#include "givenTimes.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
    defineTypeNameAndDebug(givenTimes, 0);
    addToRunTimeSelectionTable(injectionOrder, givenTimes, dictionary);
}


Foam::givenTimes::givenTimes(const dictionary& injector)
:
    times_(injector.get<scalarList>("times"))
{
    for (label i = 1; i < times_.size(); ++i)
    {
        if (times_[i] < times_[i - 1])
        {
            FatalIOErrorInFunction(injector)
                << "'times' in '" << injector.dictName()
                << "' must be in order: " << times_[i] << " is after "
                << times_[i - 1] << nl << exit(FatalIOError);
        }
    }
}


Foam::scalar Foam::givenTimes::time
(
    const label number,
    const scalar start,
    const scalar last
) const
{
    return number < times_.size() ? times_[number] : GREAT;
}
