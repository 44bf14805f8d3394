// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyOrigin.H"

Foam::bodyOrigin::bodyOrigin
(
    const word& injector,
    const scalar size,
    const scalar densityRatio
)
:
    injector(injector),
    size(size),
    densityRatio(densityRatio)
{}


Foam::bodyOrigin::bodyOrigin(const dictionary& dict)
:
    injector(dict.get<word>("injector")),
    size(dict.get<scalar>("size")),
    densityRatio(dict.get<scalar>("densityRatio"))
{}


void Foam::bodyOrigin::write(Ostream& os) const
{
    os.writeEntry("injector", injector);
    os.writeEntry("size", size);
    os.writeEntry("densityRatio", densityRatio);
}
