// SPDX-License-Identifier: GPL-3.0-or-later

#include "meanShape.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"

namespace Foam
{
namespace shapeModels
{
    defineTypeNameAndDebug(meanShape, 0);
    addToRunTimeSelectionTable(shapeModel, meanShape, dictionary);
}
}


Foam::shapeModels::meanShape::meanShape
(
    const dictionary& dict,
    const bodyShape& shape
)
:
    sphericity_(shape)
{
    keywords::check(dict, {"type"});
}
