// SPDX-License-Identifier: GPL-3.0-or-later

#include "passageTable.H"
#include "OSspecific.H"

Foam::passageTable::passageTable(const objectRegistry& mesh)
:
    writeFile(mesh, "immersedBodies", "passage")
{
    writeToFile_ = Pstream::master();
    writePrecision_ = 12;
}


void Foam::passageTable::writeHeader()
{
    const Time& time = fileObr_.time();
    const fileName folder
    (
        baseFileDir()/prefix_/time.timeName(time.startTime().value())
    );

    mkDir(folder);
    filePtr_.reset(new OFstream(folder/(fileName_ + ".dat")));

    OFstream& os = filePtr_();
    initStream(os);

    writeFile::writeHeader(os, "Bodies that enter and leave");
    writeCommented(os, "time[s]");
    os  << tab << "body";

    for (const char* name : {"position", "velocity", "angularVelocity"})
    {
        for (const char* cmpt : {"x", "y", "z"})
        {
            os  << tab << name << '_' << cmpt
                << (*name == 'p' ? "[m]" : *name == 'v' ? "[m/s]" : "[rad/s]");
        }
    }
    os  << tab << "what" << tab << "name" << tab << "where" << nl;
}


void Foam::passageTable::add
(
    const immersedBody& body,
    const word& what,
    const word& where,
    const vector& displacement
)
{
    const bodyState& state = body.state();
    const point position(state.position + displacement);

    Info<< "Body " << body.name() << ' ' << what << ": " << where << ", at "
        << position << " with the velocity " << state.U << ", spin "
        << state.omega << endl;

    if (!writeToFile())
    {
        return;
    }
    if (!filePtr_.valid())
    {
        writeHeader();
    }

    OFstream& os = filePtr_();

    writeCurrentTime(os);
    os  << tab << body.number();

    for (const vector& v : {vector(position), state.U, state.omega})
    {
        os  << tab << v.x() << tab << v.y() << tab << v.z();
    }
    os  << tab << what << tab << body.name() << tab << where << endl;
}
