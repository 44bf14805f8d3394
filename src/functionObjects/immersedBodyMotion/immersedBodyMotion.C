// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodyMotion.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(immersedBodyMotion, 0);
    addToRunTimeSelectionTable(functionObject, immersedBodyMotion, dictionary);
}
}


Foam::functionObjects::immersedBodyMotion::immersedBodyMotion
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


Foam::wordList Foam::functionObjects::immersedBodyMotion::columns() const
{
    wordList names;

    appendVector(names, "position", "m");
    names.append("q_w");
    names.append("q_x");
    names.append("q_y");
    names.append("q_z");
    appendVector(names, "velocity", "m/s");
    appendVector(names, "angularVelocity", "rad/s");

    if (bodies().window().comoving())
    {
        appendVector(names, "windowPosition", "m");
        appendVector(names, "windowVelocity", "m/s");
    }
    if (bodies().periods().active())
    {
        appendVector(names, "unwrapped", "m");
    }

    return names;
}


void Foam::functionObjects::immersedBodyMotion::writeRow
(
    Ostream& os,
    const immersedBody& body
) const
{
    const bodyState& state = body.state();

    const meshWindow& window = bodies().window();

    writeVector(os, state.position + window.displacement());
    os  << tab << state.orientation.w();
    writeVector(os, state.orientation.v());
    writeVector(os, state.U);
    writeVector(os, state.omega);

    if (window.comoving())
    {
        writeVector(os, state.position);
        writeVector(os, state.U - window.velocity());
    }
    if (bodies().periods().active())
    {
        writeVector(os, body.motion().unwrapped() + window.displacement());
    }
}
