// SPDX-License-Identifier: GPL-3.0-or-later

#include "turbulentEddy.H"

Foam::turbulentEddy::turbulentEddy()
:
    U(Zero),
    age(1),
    number(0)
{}


Foam::turbulentEddy::turbulentEddy(const dictionary& dict)
:
    U(dict.get<vector>("fluctuation")),
    age(dict.get<scalar>("age")),
    number(dict.get<label>("number"))
{}


void Foam::turbulentEddy::write(Ostream& os) const
{
    os.writeEntry("fluctuation", U);
    os.writeEntry("age", age);
    os.writeEntry("number", number);
}
