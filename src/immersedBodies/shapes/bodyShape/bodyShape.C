// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyShape.H"
#include "checkKeywords.H"

namespace Foam
{
    defineTypeNameAndDebug(bodyShape, 0);
    defineRunTimeSelectionTable(bodyShape, dictionary);
}


Foam::autoPtr<Foam::bodyShape> Foam::bodyShape::New
(
    const dictionary& dict,
    const geometricSpace& space
)
{
    const word type(dict.get<word>("type"));
    auto iter = dictionaryConstructorTablePtr_->cfind(type);

    if (!iter.found())
    {
        keywords::refuse
        (
            dict,
            "type",
            type,
            dictionaryConstructorTablePtr_->sortedToc()
        );
    }

    return iter()(dict, space);
}


Foam::scalar Foam::bodyShape::distance(const point& X) const
{
    scalar d = 0;
    UList<scalar> result(&d, 1);
    distance(UList<point>(const_cast<point*>(&X), 1), result);

    return d;
}
