// SPDX-License-Identifier: GPL-3.0-or-later

#include "Clift.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(Clift, 0);
    addToRunTimeSelectionTable(dragModel, Clift, dictionary);
}
}


Foam::dragModels::Clift::Clift(const dictionary& dict)
{
    keywords::check(dict, {"type"});
}


Foam::scalar Foam::dragModels::Clift::K(const scalar Re, const scalar) const
{
    if (Re <= 0.01)
    {
        return 1 + Re/128;
    }

    const scalar w = log10(Re);

    if (Re <= 20)
    {
        return 1 + 0.1315*pow(Re, 0.82 - 0.05*w);
    }
    if (Re <= 260)
    {
        return 1 + 0.1935*pow(Re, 0.6305);
    }

    // C_D as a polynomial, of w or as its logarithm
    scalar Cd;

    if (Re <= 1500)
    {
        Cd = pow(10, 1.6435 + w*(-1.1242 + w*0.1558));
    }
    else if (Re <= 1.2e4)
    {
        Cd = pow(10, -2.4571 + w*(2.5558 + w*(-0.9295 + w*0.1049)));
    }
    else if (Re <= 4.4e4)
    {
        Cd = pow(10, -1.9181 + w*(0.6370 - w*0.0636));
    }
    else if (Re <= 3.38e5)
    {
        Cd = pow(10, -4.3390 + w*(1.5809 - w*0.1546));
    }
    else if (Re <= 4e5)
    {
        Cd = 29.78 - 5.3*w;
    }
    else if (Re <= 1e6)
    {
        Cd = 0.1*w - 0.49;
    }
    else
    {
        Cd = 0.19 - 8e4/Re;
    }

    return Cd*Re/24;
}
