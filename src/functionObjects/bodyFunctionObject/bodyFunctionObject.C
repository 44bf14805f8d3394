// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyFunctionObject.H"
#include "bodiesInOrder.H"
#include "bytes.H"
#include "OStringStream.H"

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
Foam::functionObjects::bodyFunctionObject::actingIn
(
    const fvMesh& mesh,
    const word& name,
    const word& what
)
{
    immersedBodies& bodies = sceneOf(mesh, name);

    bodies.keepActions();
    if (bodies.list().share().any(bodies.list().nUnresolved()))
    {
        WarningInFunction
            << "Function object '" << name << "': bodies that the mesh does not"
            << " resolve have no part in the " << what << nl << endl;
    }

    return bodies;
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


void Foam::functionObjects::bodyFunctionObject::writeTop(const bodyList& all)
{
    if (writeToFile())
    {
        writeHeader(file(), "Bodies, by number:");
    }

    bodiesInOrder::visit<char>
    (
        all,
        [&](const label bodyi, DynamicList<char>& data)
        {
            bytes::append(all[bodyi].number(), data);
            bytes::append(all[bodyi].name(), data);
        },
        [&](const UList<char>& bytesOfBody)
        {
            const char* data = bytesOfBody.cdata();

            writeName(data);
        }
    );

    if (writeToFile())
    {
        OFstream& os = file();

        writeCommented(os, "time[s]");
        os  << tab << "body";

        for (const word& column : columns())
        {
            os  << tab << column;
        }
        os  << nl;
    }
}


Foam::label Foam::functionObjects::bodyFunctionObject::writeName
(
    const char*& data
)
{
    label number;
    word name;

    bytes::read(data, number);
    bytes::read(data, name);
    if (writeToFile() && named_.insert(number))
    {
        writeHeaderValue(file(), Foam::name(number), name);
    }

    return number;
}


void Foam::functionObjects::bodyFunctionObject::writeBody(const char* data)
{
    const label number = writeName(data);
    std::string row;

    bytes::read(data, row);
    if (writeToFile())
    {
        OFstream& os = file();

        writeCurrentTime(os);
        os  << tab << number;
        os.writeQuoted(row, false);
        os  << nl;
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
    const bodyList& all = bodies().list();

    if (!writeToFile() && !all.share().spread())
    {
        return true;
    }
    if (writesHeader())
    {
        writeTop(all);
    }

    bodiesInOrder::visit<char>
    (
        all,
        [&](const label bodyi, DynamicList<char>& data)
        {
            OStringStream row;

            initStream(row);
            row.width(0);
            writeRow(row, all[bodyi]);
            bytes::append(all[bodyi].number(), data);
            bytes::append(all[bodyi].name(), data);
            bytes::append(std::string(row.str()), data);
        },
        [&](const UList<char>& bytesOfBody)
        {
            writeBody(bytesOfBody.cdata());
        }
    );
    if (writeToFile())
    {
        file().flush();
    }

    return true;
}
