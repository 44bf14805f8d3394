// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodySurfaces.H"
#include "addToRunTimeSelectionTable.H"
#include "foamVtkOutput.H"
#include "OSspecific.H"
#include <fstream>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(immersedBodySurfaces, 0);
    addToRunTimeSelectionTable
    (
        functionObject,
        immersedBodySurfaces,
        dictionary
    );
}
}


namespace
{

//- Write a named array of labels
void writeLabels
(
    Foam::vtk::formatter& format,
    const Foam::word& name,
    const Foam::labelUList& values
)
{
    format.beginDataArray<Foam::label>(name);
    Foam::vtk::writeList(format, values);
    format.flush();
    format.endDataArray();
}


//- Write a named array of vectors
void writeVectors
(
    Foam::vtk::formatter& format,
    const Foam::word& name,
    const Foam::UList<Foam::vector>& values
)
{
    format.beginDataArray<float, 3>(name);
    Foam::vtk::writeList(format, values);
    format.flush();
    format.endDataArray();
}

} // End anonymous namespace


Foam::functionObjects::immersedBodySurfaces::immersedBodySurfaces
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict)
{
    read(dict);

    const immersedBodies* bodies =
        mesh_.findObject<immersedBodies>(immersedBodies::typeName);

    // What a run begins with, where no earlier one has written it
    if
    (
        !postProcess
     && runTime.timeIndex() == runTime.startTimeIndex()
     && bodies && !bodies->restarted()
    )
    {
        write();
    }
}


Foam::labelList
Foam::functionObjects::immersedBodySurfaces::writeGeometry
(
    vtk::formatter& format,
    const immersedBodies& bodies
)
{
    const label nBodies = bodies.size();

    DynamicList<point> points;
    DynamicList<label> corners, ends, bodyOfFace;

    for (label bodyi = 0; bodyi < nBodies; ++bodyi)
    {
        points.append(bodies[bodyi].state().position);
    }

    for (label bodyi = 0; bodyi < nBodies; ++bodyi)
    {
        const bodyState& state = bodies[bodyi].state();
        const tensor R(state.orientation.R());
        const label start = points.size();
        pointField bodyPoints;
        faceList bodyFaces;

        bodies[bodyi].shape().surface(bodyPoints, bodyFaces);

        for (const point& X : bodyPoints)
        {
            points.append(state.position + (R & X));
        }
        for (const face& f : bodyFaces)
        {
            for (const label pointi : f)
            {
                corners.append(start + pointi);
            }
            ends.append(corners.size());
            bodyOfFace.append(bodyi);
        }
    }

    format.tag
    (
        vtk::fileTag::PIECE,
        "NumberOfPoints", points.size(),
        "NumberOfVerts", nBodies,
        "NumberOfPolys", ends.size()
    );

    format.tag(vtk::fileTag::POINTS);
    writeVectors(format, "Points", points);
    format.endTag(vtk::fileTag::POINTS);

    format.tag(vtk::fileTag::VERTS);
    writeLabels(format, "connectivity", identity(nBodies));
    writeLabels(format, "offsets", identity(nBodies, 1));
    format.endTag(vtk::fileTag::VERTS);

    format.tag(vtk::fileTag::POLYS);
    writeLabels(format, "connectivity", corners);
    writeLabels(format, "offsets", ends);
    format.endTag(vtk::fileTag::POLYS);

    return labelList(std::move(bodyOfFace));
}


void Foam::functionObjects::immersedBodySurfaces::writeCellData
(
    vtk::formatter& format,
    const immersedBodies& bodies,
    const labelUList& bodyOfFace
)
{
    // One value per vertex, then one per polygon
    labelList body(identity(bodies.size()));
    body.append(bodyOfFace);

    vectorField U(body.size()), omega(body.size()), force(body.size());
    scalarField radius(body.size());

    forAll(body, i)
    {
        const immersedBody& b = bodies[body[i]];

        radius[i] = b.shape().boundingRadius();
        U[i] = b.state().U;
        omega[i] = b.state().omega;
        force[i] = bodies.rho()*b.fluid().force();
    }

    // Numbers last as long as the case runs, indices do not
    labelList number(body.size());

    forAll(number, i)
    {
        number[i] = bodies[body[i]].number();
    }

    format.beginCellData();
    writeLabels(format, "body", number);

    format.beginDataArray<float>("radius");
    vtk::writeList(format, radius);
    format.flush();
    format.endDataArray();

    writeVectors(format, "velocity", U);
    writeVectors(format, "angularVelocity", omega);
    writeVectors(format, "force", force);
    format.endCellData();
}


bool Foam::functionObjects::immersedBodySurfaces::write()
{
    immersedBodies* bodies =
        mesh_.getObjectPtr<immersedBodies>(immersedBodies::typeName);

    if (!bodies)
    {
        return true;
    }

    bodies->unite();

    if (!Pstream::master())
    {
        return true;
    }

    const fileName folder
    (
        time_.globalPath()/functionObject::outputPrefix/name()
    );
    const fileName file
    (
        "bodies_" + Foam::name(time_.timeIndex()) + ".vtp"
    );

    mkDir(folder);

    if (series_.empty())
    {
        // Go on from the files of the run that this one continues
        series_.load(folder/"bodies.vtp", true, time_.value());
    }

    std::ofstream os(folder/file);
    autoPtr<vtk::formatter> format(vtk::newFormatter(os, 8));

    format->xmlHeader();
    format->beginVTKFile<vtk::fileTag::POLY_DATA>();
    const labelList bodyOfFace(writeGeometry(format(), *bodies));
    writeCellData(format(), *bodies, bodyOfFace);
    format->endPiece();
    format->endTag(vtk::fileTag::POLY_DATA);
    format->endVTKFile();

    series_.append(time_.value(), file);
    series_.write(folder/"bodies.vtp");

    return true;
}
