// SPDX-License-Identifier: GPL-3.0-or-later

#include "averagingKernel.H"
#include "checkKeywords.H"

namespace Foam
{
    defineTypeNameAndDebug(averagingKernel, 0);
    defineRunTimeSelectionTable(averagingKernel, dictionary);
}


Foam::autoPtr<Foam::averagingKernel> Foam::averagingKernel::New
(
    const dictionary& dict,
    const scalar diameter,
    const bool twoD
)
{
    keywords::check(dict, {"type", "radius"});

    const scalar radius = keywords::positiveOr(dict, "radius", 1);
    const word type
    (
        keywords::choice
        (
            dict,
            "type",
            dictionaryConstructorTablePtr_->sortedToc(),
            "Gaussian"
        )
    );

    return dictionaryConstructorTablePtr_->cfind(type)()
    (
        radius*diameter,
        twoD
    );
}
