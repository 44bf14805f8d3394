// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyFunctionObject.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(bodyFunctionObject, 0);
}
}


Foam::functionObjects::bodyFunctionObject::bodyFunctionObject
(
    const word& name,
    const word& fileName,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    tableFile(mesh_, name, fileName, dict)
{}


Foam::immersedBodies& Foam::functionObjects::bodyFunctionObject::sceneOf
(
    const fvMesh& mesh,
    const word& name
)
{
    immersedBodies* bodies =
        mesh.getObjectPtr<immersedBodies>(immersedBodies::typeName);

    if (!bodies)
    {
        FatalErrorInFunction
            << "Function object '" << name << "' needs immersed bodies: run"
            << " it with the solver immersedFluid and bodies in"
            << " constant/immersedBodyProperties" << nl << exit(FatalError);
    }

    return *bodies;
}


const Foam::immersedBodies&
Foam::functionObjects::bodyFunctionObject::bodiesOf
(
    const fvMesh& mesh,
    const word& name
)
{
    immersedBodies& bodies = sceneOf(mesh, name);

    if (bodies.keepTogether())
    {
        WarningInFunction
            << "Function object '" << name << "' has been added while bodies"
            << " were spread over the ranks: it sees no contact between them"
            << " before the next time step" << nl << endl;
    }

    return bodies;
}


void Foam::functionObjects::bodyFunctionObject::resolvedOnly
(
    const immersedBodies& bodies,
    const word& name,
    const word& what
)
{
    if (bodies.list().nUnresolved())
    {
        WarningInFunction
            << "Function object '" << name << "': bodies that the mesh does not"
            << " resolve have no part in the " << what << nl << endl;
    }
}


void Foam::functionObjects::bodyFunctionObject::writeVector
(
    Ostream& os,
    const vector& v
)
{
    os  << tab << v.x() << tab << v.y() << tab << v.z();
}


void Foam::functionObjects::bodyFunctionObject::appendVector
(
    wordList& names,
    const word& name,
    const word& unit
)
{
    for (const char* cmpt : {"x", "y", "z"})
    {
        names.append(word(name + '_' + cmpt + '[' + unit + ']', false));
    }
}


bool Foam::functionObjects::bodyFunctionObject::read(const dictionary& dict)
{
    return fvMeshFunctionObject::read(dict) && writeFile::read(dict);
}


bool Foam::functionObjects::bodyFunctionObject::execute()
{
    return true;
}


bool Foam::functionObjects::bodyFunctionObject::write()
{
    sceneOf(mesh_, name()).unite();

    const immersedBodies& bodies = this->bodies();

    if (!writeToFile())
    {
        return true;
    }

    OFstream& os = file();

    if (!writtenHeader_)
    {
        writeHeader(os, "Bodies, by number:");

        for (label bodyi = 0; bodyi < bodies.size(); ++bodyi)
        {
            const immersedBody& body = bodies[bodyi];

            writeHeaderValue(os, Foam::name(body.number()), body.name());
            named_.insert(body.number());
        }

        writeCommented(os, "time[s]");
        os  << tab << "body";

        for (const word& column : columns())
        {
            os  << tab << column;
        }
        os  << nl;
        writtenHeader_ = true;
    }

    for (label bodyi = 0; bodyi < bodies.size(); ++bodyi)
    {
        const immersedBody& body = bodies[bodyi];

        if (named_.insert(body.number()))
        {
            writeHeaderValue(os, Foam::name(body.number()), body.name());
        }

        writeCurrentTime(os);
        os  << tab << body.number();
        writeRow(os, body);
        os  << nl;
    }
    os.flush();

    return true;
}
