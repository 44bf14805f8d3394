// SPDX-License-Identifier: GPL-3.0-or-later

#include "absoluteFlux.H"
#include "addToRunTimeSelectionTable.H"
#include "bodyFunctionObject.H"
#include "checkKeywords.H"
#include "surfaceFields.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(absoluteFlux, 0);
    addToRunTimeSelectionTable(functionObject, absoluteFlux, dictionary);
}
}


Foam::functionObjects::absoluteFlux::absoluteFlux
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict)
{
    keywords::checkFunctionObject(dict, wordList());
    read(dict);
}


bool Foam::functionObjects::absoluteFlux::execute()
{
    const dimensionedVector V
    (
        "V",
        dimVelocity,
        bodyFunctionObject::sceneOf(mesh_, name()).window().velocity()
    );
    word phiAbs("phiAbs");

    return store
    (
        phiAbs,
        lookupObject<surfaceScalarField>("phi") + (V & mesh_.Sf())
    );
}
