// SPDX-License-Identifier: GPL-3.0-or-later

#include "constantDrag.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(constantDrag, 0);
    addToRunTimeSelectionTable(dragModel, constantDrag, dictionary);
}
}


Foam::dragModels::constantDrag::constantDrag(const dictionary& dict)
:
    coefficient_(keywords::positiveOr(dict, "coefficient", 0.44))
{
    keywords::check(dict, {"type", "coefficient"});
}
