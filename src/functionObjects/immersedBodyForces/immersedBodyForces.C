// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodyForces.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(immersedBodyForces, 0);
    addToRunTimeSelectionTable(functionObject, immersedBodyForces, dictionary);
}
}


Foam::functionObjects::immersedBodyForces::immersedBodyForces
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    bodyFunctionObject(name, typeName, runTime, dict)
{
    read(dict);
}


Foam::wordList Foam::functionObjects::immersedBodyForces::columns() const
{
    wordList names;

    appendVector(names, "fluidForce", "N");
    appendVector(names, "fluidTorque", "Nm");
    appendVector(names, "contactForce", "N");

    return names;
}


void Foam::functionObjects::immersedBodyForces::writeRow
(
    Ostream& os,
    const immersedBody& body
) const
{
    const scalar rho = bodies().rho();

    writeVector(os, rho*body.fluid().force());
    writeVector(os, rho*body.fluid().torque());
    writeVector(os, rho*body.contact().force().linear);
}
