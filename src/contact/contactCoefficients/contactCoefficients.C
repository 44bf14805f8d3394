// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactCoefficients.H"
#include "checkKeywords.H"

Foam::contactCoefficients::contactCoefficients
(
    const dictionary& dict,
    const contactCoefficients& deflt
)
:
    restitution(keywords::positiveOr(dict, "restitution", deflt.restitution)),
    friction(dict.lookupOrDefault<scalar>("friction", deflt.friction)),
    own(deflt.own)
{
    if (restitution > 1 || friction < 0)
    {
        FatalIOErrorInFunction(dict)
            << "In '" << dict.dictName() << "' 'restitution " << restitution
            << "' must be at most 1 and 'friction " << friction
            << "' at least 0" << nl << exit(FatalIOError);
    }
}
